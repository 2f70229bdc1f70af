// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OriginalHints.h
 * @brief For each vertex of the current mesh a nearby triangle of the original.
 *
 * It is the triangle that was nearest to the vertex in its last query. Walks start there, so they
 * are short and stay on the same side of a thin bone, which a search for the globally nearest
 * triangle would not.
 */
#ifndef BoneDecimate_Core_Proof_Reference_OriginalHints_h
#define BoneDecimate_Core_Proof_Reference_OriginalHints_h

#include "Base/Monitor.h"
#include "SurfaceWalk.h"

#include <vector>

namespace bonedecimate
{
class OriginalHints
{
public:
  /// @param original Must outlive this object.
  /// @param starts For each vertex of the mesh, an original triangle near it. Null: the original is
  ///   the mesh before the first edit, and each vertex starts at one of its own triangles.
  explicit OriginalHints(const HalfEdgeMesh& original, const std::vector<Index>* starts = nullptr)
    : OriginalMesh(original)
    , Starts(starts)
    , TriangleOfVertex(starts != nullptr ? starts->size()
                                         : static_cast<std::size_t>(original.NumberOfVertexSlots()),
        None)
  {
  }

  /// Sets all hints again after collapses, from the starts. False after an abort.
  bool Restart(const HalfEdgeMesh& mesh, int threads, const Monitor& monitor);

  PointOnMesh Find(const Vector3& p, VertexId vertex) const
  {
    return WalkFrom(this->OriginalMesh, p, this->TriangleOfVertex[vertex]);
  }
  /// The best of a point found and of walks from the hints of other vertices.
  /// @param squaredReach mm^2; a point within this distance ends the search.
  template <typename Vertices>
  PointOnMesh FindBetter(
    const Vector3& p, const PointOnMesh& found, double squaredReach, const Vertices& vertices) const
  {
    PointOnMesh best = found;
    for (const VertexId v : vertices)
    {
      if (best.Point.SquaredDistance <= squaredReach)
      {
        break;
      }
      const bool isNew =
        this->TriangleOfVertex[v] != None && this->TriangleOfVertex[v] != best.Face;
      const PointOnMesh other = isNew ? this->Find(p, v) : best;
      best = other.Point.SquaredDistance < best.Point.SquaredDistance ? other : best;
    }
    return best;
  }
  void Set(VertexId vertex, Index triangle) { this->TriangleOfVertex[vertex] = triangle; }
  Index Of(VertexId vertex) const { return this->TriangleOfVertex[vertex]; }
  const HalfEdgeMesh& Original() const { return this->OriginalMesh; }

private:
  const HalfEdgeMesh& OriginalMesh;
  const std::vector<Index>* Starts;
  std::vector<Index> TriangleOfVertex;
};
}

#endif
