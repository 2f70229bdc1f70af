// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// What a Prover does where an edit touches an open boundary.
#include "Prover.h"

#include "WalkedTargets.h"

#include <algorithm>

namespace bonedecimate
{
/// Old boundaries by new ones, and new ones by the old ones that the edges they replace proved.
bool Prover::BoundaryIsNear(const HalfEdgeMesh& mesh)
{
  for (Item& item : this->BoundaryItems)
  {
    if (!this->ProveBoundaryItem(mesh, item))
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
  const WalkedBoundary original(this->Shared.Boundaries, this->Shared.Allowed);
  for (const SurfaceChange::BoundaryEdge& edge : this->Change->NewBoundary)
  {
    PieceCover<2>::Piece whole;
    for (std::size_t i = 0; i < 2; ++i)
    {
      if (this->Shared.NearestBoundary[edge.OnLine[i]] == None)
      {
        return false;
      }
      whole[i] = original.Find(edge.Ends[i], this->Shared.NearestBoundary[edge.OnLine[i]]);
      if (edge.Vertices[i] == this->Change->Moved)
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
bool Prover::ProveBoundaryItem(const HalfEdgeMesh& mesh, Item& item)
{
  if (this->Change->BoundaryStays)
  {
    this->HandOver(item);
    return true;
  }
  this->Boundary.Candidates.clear();
  for (const SurfaceChange::BoundaryEdge& edge : this->Change->NewBoundary)
  {
    this->Boundary.Candidates.push_back(edge.Ends);
  }
  const std::size_t newEdges = this->Boundary.Candidates.size();
  for (int slot = 0; slot < Coverage::SlotsPerItem; ++slot)
  {
    const Index h = this->Shared.ByBoundaries.CoveringElement(item.Id, slot);
    if (h != None && (item.Gone >> slot & 1) == 0)
    {
      this->Boundary.Candidates.push_back(
        { mesh.Position(mesh.Origin(h)), mesh.Position(mesh.Target(h)) });
    }
  }
  const HalfEdgeId boundary = this->Shared.Boundaries.HalfEdge(item.Id);
  const BoundaryProof::Piece whole = { this->Shared.Boundaries.Ends(item.Id),
    { this->Shared.LimitAt(this->Shared.Source.Origin(boundary)),
      this->Shared.LimitAt(this->Shared.Source.Target(boundary)) } };
  const bool proved = this->Boundary.Prove(
    whole, [&](std::size_t used) { item.Used |= used < newEdges ? Faces(1) << used : Faces(0); });
  const std::size_t others = this->Boundary.Candidates.size() - newEdges;
  return proved && others + CountBits(item.Used) <= Coverage::SlotsPerItem;
}

//------------------------------------------------------------------------------
/// From each old boundary edge to the new one that replaces it.
void Prover::HandOver(Item& item)
{
  for (int slot = 0; slot < Coverage::SlotsPerItem; ++slot)
  {
    for (std::size_t i = 0; i < this->Change->NewBoundary.size(); ++i)
    {
      const bool isCovering = (item.Gone >> slot & 1) != 0 &&
        this->Shared.ByBoundaries.CoveringElement(item.Id, slot) ==
          this->Change->NewBoundary[i].Replaces;
      item.Used |= isCovering ? Faces(1) << i : Faces(0);
    }
  }
}
}
