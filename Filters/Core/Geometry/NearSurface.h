// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NearSurface.h
 * @brief Whether triangles come near a surface: never missed, and at most a quarter of the distance
 * too early.
 *
 *     nearest point of the surface to the middle of the triangle
 *     neither near nor farther than the distance and the radius: the triangle is cut into four,
 *       down to a quarter of the distance
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
  std::shared_ptr<const BoundingTree> Others; ///< Null: none.
  double Distance = 0.0;                      ///< mm
};

/// Whether a point of the triangle may be within the distance of the surface.  @param distance mm,
/// above 0.
bool MayComeNear(
  const BoundingTree& surface, const std::array<Vector3, 3>& corners, double distance);

/// The triangles whose corners are valid and finite, with all points.
Surface UsableTriangles(const Surface& surface);

/// For each triangle of a surface 1 if it may be within the distance of the others, else 0.
/// Triangles without usable corners are near nothing.
std::vector<char> TrianglesNear(
  const Surface& surface, const Surface& others, double distance, int threads);
}

#endif
