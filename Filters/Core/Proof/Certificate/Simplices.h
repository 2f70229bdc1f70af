// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Simplices.h
 * @brief The sets between which distances are certified: triangles, or segments of boundaries, in a
 * local frame.
 */
#ifndef BoneDecimate_Core_Proof_Certificate_Simplices_h
#define BoneDecimate_Core_Proof_Certificate_Simplices_h

#include "EdgeSides.h"
#include "Geometry/Surface.h"

#include <cstddef>
#include <vector>

namespace bonedecimate::certificate
{
/// A point set made of triangles, segments (third corner None) and points (second and third corner
/// None).
struct Simplices
{
  std::vector<Vector3> Points; ///< mm, in the local frame; may contain points that are not corners
  std::vector<Triangle> Corners; ///< indices into Points
  /// The triangle of the surface for each simplex. Empty: the index of the simplex.
  std::vector<Index> TriangleIds;
  const EdgeSides* Sides = nullptr;   ///< Null: no surface.
  std::vector<double> PointTolerance; ///< mm, at each point, linear in between; empty: 0

  std::size_t Size() const { return this->Corners.size(); }
  int NumberOfCorners(std::size_t simplex) const
  {
    const Triangle& corners = this->Corners[simplex];
    return corners[2] != None ? 3 : corners[1] != None ? 2 : 1;
  }
  Index TriangleId(Index simplex) const
  {
    return simplex == None || this->TriangleIds.empty() ? simplex : this->TriangleIds[simplex];
  }
};
}

#endif
