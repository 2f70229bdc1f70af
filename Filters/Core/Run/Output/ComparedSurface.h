// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ComparedSurface.h
 * @brief The certificate of two surfaces as they were read, with what was left out of them, their
 * counts, area, volume and intersecting pairs, and components that one of them lacks.
 *
 * Triangles without area are no surface: those that cleaning drops (Cleaning.h) are left out and
 * listed, so that a surface is not near where only such a triangle is.
 */
#ifndef BoneDecimate_Core_Run_Output_ComparedSurface_h
#define BoneDecimate_Core_Run_Output_ComparedSurface_h

#include "Base/Monitor.h"
#include "Figures/LeftOut.h"
#include "Geometry/Surface.h"
#include "Proof/Certificate/Certificate.h"
#include "Run/Report/CertificateTable.h"

#include <vector>

namespace bonedecimate
{
/// A surface, and what its reader left out.
struct ComparedSurface
{
  const bonedecimate::Surface& Surface;
  const std::vector<LeftOutShape>& LeftOut;
};

/// @param withFigures Also figures of both surfaces, if the certificate is good; none for a surface
/// that cannot be used.
/// @param[out] figures What was left out, and these figures.
Certificate CertifyPair(const ComparedSurface& reference, const ComparedSurface& result,
  const CertificateOptions& options, bool withFigures, const Monitor& monitor,
  PairFigures& figures);
}

#endif
