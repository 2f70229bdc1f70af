// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BackHints.h
 * @brief The way back: for places on the current mesh the true original triangle near them.
 *
 * Every vertex and every face of the current mesh remembers the original triangle that was nearest to it, or to its
 * middle, when it was last asked. Walks start there, so that they are short and stay on their sheet.
 */
#ifndef BoneDecimate_Core_Reference_BackHints_h
#define BoneDecimate_Core_Reference_BackHints_h

#include "SurfaceWalk.h"

#include <vector>

namespace bonedecimate
{
class BackHints
{
public:
  /// @param original The mesh as it was at first, which must stay; ids of vertices and faces are those of the current one.
  explicit BackHints(const HalfEdgeMesh& original)
    : Source(original)
    , OfVertex(static_cast<std::size_t>(original.NumberOfVertexSlots()), None)
    , OfFace(static_cast<std::size_t>(original.NumberOfFaceSlots()), None)
  {
  }

  /// Begins anew after collapses: each vertex at its own original place, each face at that of a corner.
  void Begin(const HalfEdgeMesh& mesh);

  PlaceOnMesh FromVertex(const Vector3& p, Index vertex) const
  {
    return WalkFrom(this->Source, p, this->OfVertex[vertex]);
  }
  PlaceOnMesh FromFace(const Vector3& p, Index face) const
  {
    return WalkFrom(this->Source, p, this->OfFace[face]);
  }
  void SetVertex(Index vertex, Index triangle) { this->OfVertex[vertex] = triangle; }
  void SetFace(Index face, Index triangle) { this->OfFace[face] = triangle; }
  const HalfEdgeMesh& Original() const { return this->Source; }

private:
  const HalfEdgeMesh& Source;
  std::vector<Index> OfVertex;
  std::vector<Index> OfFace;
};
}

#endif
