// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The part of Prover for edits at open boundaries.
#include "Prover.h"

#include "WalkedTargets.h"

#include <algorithm>

namespace bonedecimate
{
/// Proves original boundary edges by new edges, and new edges by the original.
bool Prover::BoundaryIsNear(const HalfEdgeMesh& mesh)
{
  for (CoveredElement& covered : this->CoveredEdges)
  {
    if (!this->ProveBoundaryEdge(mesh, covered))
    {
      return false;
    }
  }
  return this->NewBoundaryIsNear();
}

//------------------------------------------------------------------------------
bool Prover::NewBoundaryIsNear()
{
  if (this->Change->BoundaryStays)
  {
    return true;
  }
  const WalkedBoundary original(this->Bound.Boundaries, this->Bound.OriginalLimits);
  for (const SurfaceChange::BoundaryEdge& edge : this->Change->NewBoundary)
  {
    PieceCover<2>::Piece whole;
    for (std::size_t i = 0; i < 2; ++i)
    {
      if (this->Bound.NearBoundaryEdges[edge.CurveVertices[i]] == None)
      {
        return false;
      }
      whole[i] = original.Find(edge.Ends[i], this->Bound.NearBoundaryEdges[edge.CurveVertices[i]]);
      if (edge.Vertices[i] == this->Change->MovedVertex)
      {
        this->BoundaryHint = whole[i].Nearest;
      }
    }
    if (!this->BoundaryPieces.Prove(original, whole))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool Prover::ProveBoundaryEdge(const HalfEdgeMesh& mesh, CoveredElement& covered)
{
  if (this->Change->BoundaryStays)
  {
    this->ProveByReplacement(covered);
    return true;
  }
  this->Boundary.Candidates.clear();
  for (const SurfaceChange::BoundaryEdge& edge : this->Change->NewBoundary)
  {
    this->Boundary.Candidates.push_back(edge.Ends);
  }
  const std::size_t newEdges = this->Boundary.Candidates.size();
  for (int slot = 0; slot < Coverage::SlotsPerElement; ++slot)
  {
    const Index h = this->Bound.BoundaryCoverage.CoveringElement(covered.Id, slot);
    if (h != None && (covered.ReplacedSlots >> slot & 1) == 0)
    {
      this->Boundary.Candidates.push_back(
        { mesh.Position(mesh.Origin(h)), mesh.Position(mesh.Target(h)) });
    }
  }
  const HalfEdgeId boundary = this->Bound.Boundaries.HalfEdge(covered.Id);
  const BoundaryProof::Piece whole = { this->Bound.Boundaries.Ends(covered.Id),
    { this->Bound.LimitAt(this->Bound.OriginalMesh.Origin(boundary)),
      this->Bound.LimitAt(this->Bound.OriginalMesh.Target(boundary)) } };
  const bool proved = this->Boundary.Prove(whole,
    [&](std::size_t used) { covered.ProvedBy |= used < newEdges ? Faces(1) << used : Faces(0); });
  const std::size_t others = this->Boundary.Candidates.size() - newEdges;
  return proved && others + CountBits(covered.ProvedBy) <= Coverage::SlotsPerElement;
}

//------------------------------------------------------------------------------
/// Each old boundary edge is at the same position as the new one that replaces it.
void Prover::ProveByReplacement(CoveredElement& covered)
{
  for (int slot = 0; slot < Coverage::SlotsPerElement; ++slot)
  {
    for (std::size_t i = 0; i < this->Change->NewBoundary.size(); ++i)
    {
      const bool isCovering = (covered.ReplacedSlots >> slot & 1) != 0 &&
        this->Bound.BoundaryCoverage.CoveringElement(covered.Id, slot) ==
          this->Change->NewBoundary[i].Replaces;
      covered.ProvedBy |= isCovering ? Faces(1) << i : Faces(0);
    }
  }
}
}
