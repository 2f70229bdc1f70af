// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BorderLines.h
 * @brief The edges of a mesh that have one triangle, as lines to walk along.
 */
#ifndef BoneDecimate_Core_Guarantee_BorderLines_h
#define BoneDecimate_Core_Guarantee_BorderLines_h

#include "BorderProof.h"
#include "Mesh/HalfEdgeMesh.h"

namespace bonedecimate
{
class BorderLines
{
public:
  /// @param mesh Must stay as it is.
  explicit BorderLines(const HalfEdgeMesh& mesh);

  Index Count() const { return static_cast<Index>(this->Edges.size()); }
  /// The half-edge without a twin.
  Index HalfEdge(Index edge) const { return this->Edges[edge]; }
  BorderProof::Segment Ends(Index edge) const;
  double Distance(const Vector3& p, Index edge) const; ///< mm

  /// The edges before and after; None at the line's ends, where seams do not run through, and at vertices that are locked.
  const std::array<Index, 2>& NeighboursOf(Index edge) const { return this->Neighbours[edge]; }

  /// Along the line while the distance falls.
  Index WalkFrom(const Vector3& p, Index edge) const;

  /// Of each vertex an edge that begins or ends there, None where there is none.
  std::vector<Index> EdgesAtVertices() const;

private:
  const HalfEdgeMesh& Mesh;
  std::vector<Index> Edges; // half-edges
  std::vector<std::array<Index, 2>> Neighbours;
};
}

#endif
