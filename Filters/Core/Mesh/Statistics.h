// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Statistics.h
 * @brief Counts and measures of a surface as a plain triangle list.
 */
#ifndef BoneDecimate_Core_Mesh_Statistics_h
#define BoneDecimate_Core_Mesh_Statistics_h

#include "EdgeMatching.h"
#include "Figures/SurfaceFigures.h"
#include "Geometry/Surface.h"

#include <cstdint>
#include <vector>

namespace bonedecimate
{
/// Points may be unused. Corners must be valid.
SurfaceStatistics Describe(const Surface& surface, int threads = 1);

/// Figures that are already known.
struct SurfaceCounts
{
  std::int64_t Points = 0; ///< Used by triangles.
  std::int64_t Components = 0;
  EdgeCounts Edges;
};
SurfaceStatistics Describe(const Surface& surface, const SurfaceCounts& counts, int threads);

/// The components, in the order of their first points; None for points that no triangle uses.
struct Components
{
  std::vector<Index> OfPoint;
  Index Count = 0;
};
/// @param originals For each point, a point not after it that belongs to the same component. Empty:
/// there are none.
Components FindComponents(const Surface& surface, const std::vector<Index>& originals = {});
}

#endif
