// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SideFinder.h
 * @brief The side of a surface on which a point lies, by the pseudonormal at the nearest point: the
 * normal of a triangle, the sum of two normals at an edge, the sum weighted by angles at a corner.
 *
 * J. A. Baerentzen, H. Aanaes, Signed distance computation using the angle weighted pseudonormal,
 * 2005: the side is correct if the surface around the nearest point is closed and consistently
 * oriented.
 */
#ifndef BoneDecimate_Core_Proof_Certificate_SideFinder_h
#define BoneDecimate_Core_Proof_Certificate_SideFinder_h

#include "Simplices.h"

#include <array>

namespace bonedecimate::certificate
{
class SideFinder
{
public:
  /// Keeps a reference to a surface.
  explicit SideFinder(const Simplices& surface);

  /**
   * @param nearestTriangle A triangle that contains the point nearest to p.
   * @return 1 on the side of the normals (outside), -1 on the other. 0 on the surface, and where
   *   the nearest point is on a boundary, on an edge that is not manifold or not consistently
   *   oriented, or on triangles without area.
   */
  int SideOf(const Vector3& p, Index nearestTriangle) const;

private:
  std::array<Vector3, 3> CornersOf(Index triangle) const;
  Vector3 UnitNormal(Index triangle) const;
  bool AddEdge(Index triangle, int side, Vector3& normal) const;
  bool AddFan(Index triangle, int corner, Vector3& normal) const;
  int CornerAt(Index triangle, const Vector3& position) const;

  const Simplices& Surface;
  const EdgeSides& Sides;
};

/// The side of each point.
/// @param nearest For each point a triangle that contains the nearest point; None: the side is 0.
std::vector<signed char> FindSides(const std::vector<Vector3>& points,
  const std::vector<Index>& nearest, const Simplices& surface, int threads);

/// The angle between two directions, rad, to 1e-8. Uses arithmetic and square roots only, so it is
/// the same on all systems.
double AngleBetween(const Vector3& a, const Vector3& b);
}

#endif
