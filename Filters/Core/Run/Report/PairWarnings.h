// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PairWarnings.h
 * @brief What bounds of a distance do not say of two surfaces.
 */
#ifndef BoneDecimate_Core_Run_Report_PairWarnings_h
#define BoneDecimate_Core_Run_Report_PairWarnings_h

#include "CertificateTable.h"
#include "Geometry/Surface.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/// A sentence for each: missing components, one of two closed surfaces that is inside out, more
/// non-manifold edges, more intersecting pairs of triangles, and two surfaces that are the same.
/// Empty unless both were measured.
std::vector<std::string> PairWarnings(const PairFigures& pair);

/// The same after the warnings of sizes, PairSizeWarnings.
/// @param tolerance The largest, mm; 0 or less: none.
std::vector<std::string> PairWarnings(
  const Surface& reference, const Surface& result, double tolerance, const PairFigures& pair);
}

#endif
