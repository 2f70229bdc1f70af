// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceHints.h
 * @brief What makes a surface hard to simplify, with a remedy: double-sided surfaces, nearly equal
 * points, and surfaces that are inside out.
 */
#ifndef BoneDecimate_Core_Repair_Diagnostics_SurfaceHints_h
#define BoneDecimate_Core_Repair_Diagnostics_SurfaceHints_h

#include "Geometry/Surface.h"

#include <cstdint>
#include <string>
#include <vector>

namespace bonedecimate
{
/// Counts of a run's input after cleaning.
struct CountsOfInput
{
  std::int64_t Points = 0;
  std::int64_t Triangles = 0;
  std::int64_t NonManifoldPoints = 0;
  std::int64_t Components = 0;
  std::int64_t BoundaryEdges = 0;
  double Volume = 0.0; ///< mm3, signed.
};

/**
 * One sentence for each. The diagnostics, which take time, run only if the counts suggest that most
 * of the surface is not manifold or not connected, or that it is closed with a negative volume.
 * @param surface The surface of the same run, before cleaning.
 */
std::vector<std::string> SurfaceHints(
  const Surface& surface, const CountsOfInput& counts, int threads = 0);
}

#endif
