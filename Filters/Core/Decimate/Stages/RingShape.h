// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RingShape.h
 * @brief The smallest angle of the triangles around a vertex, as a function of its position, and where it is larger.
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
  /// Takes the triangles around a vertex, which must not be NonManifold.
  void Gather(const HalfEdgeMesh& mesh, VertexId vertex);
  /// Takes the triangles that remain around the merged vertex of an edge.
  void Gather(const HalfEdgeMesh& mesh, const EdgeNeighborhood& around);

  /// Cosine of the smallest angle with the vertex at that position. No less than `enough` if that is exceeded on the way.
  double CosineAt(const Vector3& position, double enough = 1.0) const;

  /**
   * A position of a larger smallest angle: a pattern search in the tangent plane.
   * @param cosine That of `from`; becomes that of the position returned.
   * @param enough The search ends there.
   */
  Vector3 Search(const Vector3& from, double enough, double& cosine) const;

private:
  std::vector<std::array<Vector3, 2>>
    Sides; // the other corners of each triangle, mm from the local origin
};
}

#endif
