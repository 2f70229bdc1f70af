// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ComparedSurface.h
 * @brief Counts, area, volume and intersecting pairs of surfaces that are compared, and components
 * that one of them lacks.
 */
#ifndef BoneDecimate_Core_Run_Output_ComparedSurface_h
#define BoneDecimate_Core_Run_Output_ComparedSurface_h

#include "Base/Monitor.h"
#include "Geometry/Surface.h"
#include "Proof/Certificate/Certificate.h"
#include "Run/Report/CertificateTable.h"

namespace bonedecimate
{
/// Figures of both surfaces of a good certificate, which says if that was aborted. None for a
/// surface that cannot be used.
void DescribePair(const Surface& reference, const Surface& result, int threads,
  const Monitor& monitor, Certificate& certificate, PairFigures& figures);
}

#endif
