// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NearSurface.h
 * @brief Whether triangles come near a surface. A near triangle is never missed, and one that is
 * farther than 1.25 times the distance never counts as near.
 *
 *     find the point of the surface nearest to the middle of the triangle
 *     near:                              yes
 *     farther than distance + radius:    no
 *     otherwise:                         cut it into four, down to a quarter of the distance
 */
#ifndef BoneDecimate_Core_Geometry_NearSurface_h
#define BoneDecimate_Core_Geometry_NearSurface_h

#include "BoundingTree.h"

#include <array>
#include <memory>
#include <vector>

namespace bonedecimate
{
/// Other surfaces from which a distance is kept.
struct NeighborSurfaces
{
  std::shared_ptr<const BoundingTree> Others; ///< All of their triangles; null: there are none.
  double Distance = 0.0;                      ///< mm
};

/// Whether a point of the triangle may be within the distance of the surface.
/// @param distance mm, above 0.
bool MayComeNear(
  const BoundingTree& surface, const std::array<Vector3, 3>& corners, double distance);

/// All points, and the triangles whose corners are valid and finite.
Surface UsableTriangles(const Surface& surface);

/// For each triangle of the surface, 1 if it may be within the distance of the others, else 0.
/// Triangles with unusable corners count as far.
std::vector<char> TrianglesNear(
  const Surface& surface, const Surface& others, double distance, int threads);
}

#endif
