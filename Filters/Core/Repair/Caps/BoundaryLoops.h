// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoundaryLoops.h
 * @brief Open boundaries as closed loops of points, and the planes in which they lie.
 */
#ifndef BoneDecimate_Core_Repair_Caps_BoundaryLoops_h
#define BoneDecimate_Core_Repair_Caps_BoundaryLoops_h

#include "Geometry/Surface.h"

#include <set>
#include <utility>
#include <vector>

namespace bonedecimate
{
struct BoundaryLoop
{
  /// In the direction of triangles that would fill it, against that of the surface.
  std::vector<Index> Points;
  std::size_t Triangle = 0;       ///< One that has an edge of the loop.
  Vector3 Area = Vector3::Zero(); ///< mm^2, twice the vector area.
};

using PointPair = std::pair<Index, Index>; ///< The lower id first, unless it has a direction.

struct BoundaryLoops
{
  std::vector<BoundaryLoop> Loops;   ///< In the order of their first triangles.
  std::size_t NonManifold = 0;       ///< Boundaries that end at a non-manifold edge: no loops.
  std::vector<PointPair> SplitEdges; ///< The ends of edges in whose middle a cap has a new point.
  std::set<PointPair> Chords;        ///< Other edges between points of loops.
};

/// Points of equal coordinates are one. Triangles with an id out of range or two equal corners do
/// not count.
BoundaryLoops FindBoundaryLoops(const Surface& surface);

/**
 * Loops at planes where the surface ends: the points of a loop lie within the tolerance of the
 * plane and all other points on its inner side. Loops of the same plane belong together, as the
 * outer and the inner boundary of a cut shaft do. A loop of three points always lies in a plane, so
 * it counts only beside a larger one.
 * @param tolerance mm.
 * @return Indices of loops, a list for each plane, the largest loop of each first.
 */
std::vector<std::vector<std::size_t>> GroupByEndPlanes(
  const Surface& surface, const std::vector<BoundaryLoop>& loops, double tolerance);
}

#endif
