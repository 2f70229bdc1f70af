// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SideFinder.h
 * @brief On which side of a surface a point is, told at the nearest place: by the normal of the triangle, the sum of two at
 *        an edge, their sum weighted by angles at a corner.
 *
 * J. A. Baerentzen, H. Aanaes, Signed distance computation using the angle weighted pseudonormal, 2005: with these, the
 * side is right wherever the surface around the nearest place is closed and consistently oriented.
 */
#ifndef BoneDecimate_Core_Certificate_SideFinder_h
#define BoneDecimate_Core_Certificate_SideFinder_h

#include "EdgeSides.h"
#include "Simplices.h"

#include <array>

namespace bonedecimate::certificate
{
class SideFinder
{
public:
  /// Keeps a reference. All simplices must be triangles.
  explicit SideFinder(const Simplices& surface);

  /**
   * @param nearestTriangle One on which the place nearest to p is.
   * @return 1 where the normals point to (outside), -1 behind; 0 on the surface, and where the nearest place is on a border,
   *         on an edge of several triangles or of two that are not oriented alike, or on triangles without area.
   */
  int SideOf(const Vector3& p, Index nearestTriangle) const;

private:
  std::array<Vector3, 3> CornersOf(Index triangle) const;
  Vector3 UnitNormal(Index triangle) const;
  bool AddEdge(Index triangle, int side, Vector3& normal) const;
  bool AddFan(Index triangle, int corner, Vector3& normal) const;
  int CornerAt(Index triangle, const Vector3& place) const;

  const Simplices& Surface;
  EdgeSides Across;
};

/// The side of each point.
/// @param nearest A triangle on which the nearest place is; None: 0.
std::vector<signed char> FindSides(const std::vector<Vector3>& points,
  const std::vector<Index>& nearest, const Simplices& surface, int threads);

/// The angle between two directions, rad, to 1e-8, by nothing but arithmetic and square roots.
double AngleBetween(const Vector3& a, const Vector3& b);
}

#endif
