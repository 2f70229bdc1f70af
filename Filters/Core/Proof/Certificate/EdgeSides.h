// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EdgeSides.h
 * @brief The neighbor across each side of a triangle, and the boundary edges, which have exactly
 * one triangle. Points of equal coordinates are merged.
 *
 * Triangles that use a point twice have no edges; those of three collinear points have three.
 */
#ifndef BoneDecimate_Core_Proof_Certificate_EdgeSides_h
#define BoneDecimate_Core_Proof_Certificate_EdgeSides_h

#include "Geometry/Surface.h"

#include <array>
#include <vector>

namespace bonedecimate::certificate
{
constexpr Index Boundary = None; ///< There is no neighbor.
constexpr Index NotRegular = -2; ///< There are several neighbors, or one of opposite orientation.

/// For each triangle, the neighbors across its sides, or one of the values above. Side k runs from
/// corner k to the next one.
using EdgeSides = std::vector<std::array<Index, 3>>;

EdgeSides FindEdgeSides(
  const std::vector<Vector3>& points, const std::vector<Triangle>& triangles, int threads);

struct BoundaryEdge
{
  std::array<Index, 2> Points; ///< in the order of the triangle
  Index Triangle = None;
};

/// Boundary edges in the order of the triangles.  @param sides Edge sides of the surface.
std::vector<BoundaryEdge> FindBoundaries(const Surface& surface, const EdgeSides& sides);
}

#endif
