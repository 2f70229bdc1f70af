// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ComparedSurface.h
 * @brief Counts, area, volume and intersecting pairs of a surface that is compared with another.
 */
#ifndef BoneDecimate_Core_Run_Output_ComparedSurface_h
#define BoneDecimate_Core_Run_Output_ComparedSurface_h

#include "Base/Monitor.h"
#include "Figures/ComparedFigures.h"
#include "Geometry/Surface.h"
#include "Proof/Certificate/Certificate.h"
#include "Run/Report/CertificateTable.h"

#include <optional>

namespace bonedecimate
{
/// @returns None after an abort, and of a surface that cannot be used.
std::optional<ComparedFigures> DescribeCompared(
  const Surface& surface, int threads, const Monitor& monitor = {});

/// The same of both surfaces of a good certificate, which says if that was aborted.
void DescribePair(const Surface& reference, const Surface& result, int threads,
  const Monitor& monitor, Certificate& certificate, PairFigures& figures);
}

#endif
