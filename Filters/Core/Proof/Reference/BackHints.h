// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BackHints.h
 * @brief For each vertex of the current mesh a nearby triangle of the original surface.
 *
 * Each vertex stores the original triangle that was nearest to it in its last query. Walks start
 * there, so they are short and stay on the same side of a thin bone, which the globally nearest
 * triangle would not.
 */
#ifndef BoneDecimate_Core_Proof_Reference_BackHints_h
#define BoneDecimate_Core_Proof_Reference_BackHints_h

#include "Base/Monitor.h"
#include "SurfaceWalk.h"

#include <vector>

namespace bonedecimate
{
class BackHints
{
public:
  /// @param original The original; must outlive this object.
  /// @param starts For each vertex of the mesh, an original triangle near it. Null: the original is
  /// the mesh before the first edit, and vertices start at their own.
  explicit BackHints(const HalfEdgeMesh& original, const std::vector<Index>* starts = nullptr)
    : Source(original)
    , Starts(starts)
    , OfVertex(starts != nullptr ? starts->size()
                                 : static_cast<std::size_t>(original.NumberOfVertexSlots()),
        None)
  {
  }

  /// Restarts after collapses: each vertex where it starts. False after an abort.
  bool Begin(const HalfEdgeMesh& mesh, int threads, const Monitor& monitor);

  PointOnMesh Find(const Vector3& p, VertexId vertex) const
  {
    return WalkFrom(this->Source, p, this->OfVertex[vertex]);
  }
  /// The best of the point found and of walks from the hints of other vertices, which start nearby
  /// on the same surface.
  /// @param squaredReach mm^2; a point within this distance is accepted without further walks.
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
      const bool isNew = this->OfVertex[v] != None && this->OfVertex[v] != best.Face;
      const PointOnMesh other = isNew ? this->Find(p, v) : best;
      best = other.Point.SquaredDistance < best.Point.SquaredDistance ? other : best;
    }
    return best;
  }
  void Set(VertexId vertex, Index triangle) { this->OfVertex[vertex] = triangle; }
  Index Of(VertexId vertex) const { return this->OfVertex[vertex]; }
  const HalfEdgeMesh& Original() const { return this->Source; }

private:
  const HalfEdgeMesh& Source;
  const std::vector<Index>* Starts;
  std::vector<Index> OfVertex;
};
}

#endif
