// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RingShape.h
 * @brief The smallest angle of the triangles around a vertex as a function of its position, and a
 * search for a larger one.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_RingShape_h
#define BoneDecimate_Core_Decimate_Stages_RingShape_h

#include "Mesh/EdgeNeighborhood.h"
#include "Mesh/HalfEdgeMesh.h"

#include <array>
#include <vector>

namespace bonedecimate
{
class RingShape
{
public:
  /// Reads the triangles around a vertex, which must not be NonManifold.
  void Gather(const HalfEdgeMesh& mesh, VertexId vertex);
  /// Reads the triangles that remain around the merged vertex of an edge.
  void Gather(const HalfEdgeMesh& mesh, const EdgeNeighborhood& around);

  /// Cosine of the smallest angle with the vertex at that position. Ends early, with a cosine above
  /// `enough`, if one triangle exceeds it.
  double CosineAt(const Vector3& position, double enough = 1.0) const;

  /**
   * Finds a position with a larger smallest angle by a pattern search in the tangent plane.
   * @param enough Cosine at which the search ends.
   * @param cosine In: that of `from`. Out: that of the returned position.
   */
  Vector3 Search(const Vector3& from, double enough, double& cosine) const;

private:
  // the other two corners of each triangle, mm from the local origin
  std::vector<std::array<Vector3, 2>> Sides;
};
}

#endif
