// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoundaryCurves.h
 * @brief The boundary edges of a mesh, which have one triangle each, as curves to walk along.
 */
#ifndef BoneDecimate_Core_Proof_ErrorBound_BoundaryCurves_h
#define BoneDecimate_Core_Proof_ErrorBound_BoundaryCurves_h

#include "BoundaryProof.h"
#include "Mesh/CutEdges.h"
#include "Mesh/HalfEdgeMesh.h"

namespace bonedecimate
{
class BoundaryCurves
{
public:
  /// @param mesh Must not change.  @param cuts Edges that are left out.
  explicit BoundaryCurves(const HalfEdgeMesh& mesh, const CutEdges& cuts = {});

  Index Count() const { return static_cast<Index>(this->Edges.size()); }
  /// The half-edge without a twin.
  Index HalfEdge(Index edge) const { return this->Edges[edge]; }
  BoundaryProof::Segment Ends(Index edge) const;
  double Distance(const Vector3& p, Index edge) const; ///< mm

  /// The edges before and after it. None at an end of the curve: where patch boundaries end, and at
  /// non-manifold vertices.
  const std::array<Index, 2>& NeighborsOf(Index edge) const { return this->Neighbors[edge]; }

  /// Walks along the curve while the distance to p falls.
  Index WalkFrom(const Vector3& p, Index edge) const;

  /// For each vertex, an edge that begins or ends there; None if there is none.
  std::vector<Index> EdgesAtVertices() const;

private:
  const HalfEdgeMesh& Mesh;
  std::vector<Index> Edges; // half-edges
  std::vector<std::array<Index, 2>> Neighbors;
};
}

#endif
