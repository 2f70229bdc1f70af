// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BackHints.h
 * @brief The way back: for the vertices of the current mesh the true original triangle near them.
 *
 * Every vertex remembers the original triangle that was nearest to it when it was last asked. Walks start there, so
 * that they are short and stay on their sheet: the nearest sheet of all would let a thin bone fall onto its other side.
 */
#ifndef BoneDecimate_Core_Reference_BackHints_h
#define BoneDecimate_Core_Reference_BackHints_h

#include "Monitor.h"
#include "SurfaceWalk.h"

#include <vector>

namespace bonedecimate
{
class BackHints
{
public:
  /// @param original The mesh as it was at first, which must stay; ids of vertices are those of the current one.
  explicit BackHints(const HalfEdgeMesh& original)
    : Source(original)
    , OfVertex(static_cast<std::size_t>(original.NumberOfVertexSlots()), None)
  {
  }

  /// Begins anew after collapses: each vertex at its own original place. False if the monitor said stop.
  bool Begin(const HalfEdgeMesh& mesh, int threads, const Monitor& monitor);

  PlaceOnMesh Find(const Vector3& p, Index vertex) const
  {
    return WalkFrom(this->Source, p, this->OfVertex[vertex]);
  }
  /// What was found is near enough, or else the best that walks from other vertices find: their sheet is the same.
  /// @param squaredReach What is near enough, mm^2.
  template <typename Vertices>
  PlaceOnMesh FindBetter(
    const Vector3& p, const PlaceOnMesh& found, double squaredReach, const Vertices& vertices) const
  {
    PlaceOnMesh best = found;
    for (const Index v : vertices)
    {
      if (best.Place.SquaredDistance <= squaredReach)
      {
        break;
      }
      const bool isNew = this->OfVertex[v] != None && this->OfVertex[v] != best.Face;
      const PlaceOnMesh other = isNew ? this->Find(p, v) : best;
      best = other.Place.SquaredDistance < best.Place.SquaredDistance ? other : best;
    }
    return best;
  }
  void Set(Index vertex, Index triangle) { this->OfVertex[vertex] = triangle; }
  Index Of(Index vertex) const { return this->OfVertex[vertex]; }
  const HalfEdgeMesh& Original() const { return this->Source; }

private:
  const HalfEdgeMesh& Source;
  std::vector<Index> OfVertex;
};
}

#endif
