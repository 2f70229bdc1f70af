// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// What a Prover does where an edit touches an open border.
#include "Prover.h"

#include "WalkedTargets.h"

#include <algorithm>

namespace bonedecimate
{
/// Old borders by new ones, and new ones by the old ones that the edges they replace proved.
bool Prover::BorderIsNear(const HalfEdgeMesh& mesh)
{
  for (Item& item : this->BorderItems)
  {
    if (!this->ProveBorderItem(mesh, item))
    {
      return false;
    }
  }
  return this->NewBorderIsNear();
}

//------------------------------------------------------------------------------
bool Prover::NewBorderIsNear()
{
  if (this->Change.BorderStays)
  {
    return true;
  }
  const WalkedBorder original(this->Shared.Borders, this->Shared.Allowed);
  for (const Patch::BorderEdge& edge : this->Change.NewBorder)
  {
    PieceCover<2>::Piece whole;
    for (std::size_t i = 0; i < 2; ++i)
    {
      whole[i] = original.Find(edge.Ends[i], this->Shared.NearestBorder[edge.OnLine[i]]);
      if (edge.Vertices[i] == this->Change.Moved)
      {
        this->BorderPlace = whole[i].Nearest;
      }
    }
    if (!this->BorderPieces.Prove(original, whole))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool Prover::ProveBorderItem(const HalfEdgeMesh& mesh, Item& item)
{
  if (this->Change.BorderStays)
  {
    this->HandOver(item);
    return true;
  }
  this->Border.Candidates.clear();
  for (const Patch::BorderEdge& edge : this->Change.NewBorder)
  {
    this->Border.Candidates.push_back(edge.Ends);
  }
  const std::size_t ours = this->Border.Candidates.size();
  for (int slot = 0; slot < Supports::MostHolders; ++slot)
  {
    const Index h = this->Shared.ByBorders.Holder(item.Id, slot);
    if (h != None && (item.Gone >> slot & 1) == 0)
    {
      this->Border.Candidates.push_back(
        { mesh.Position(mesh.Origin(h)), mesh.Position(mesh.Target(h)) });
    }
  }
  const Index border = this->Shared.Borders.HalfEdge(item.Id);
  const BorderProof::Piece whole = { this->Shared.Borders.Ends(item.Id),
    { this->Shared.LimitAt(this->Shared.Source.Origin(border)),
      this->Shared.LimitAt(this->Shared.Source.Target(border)) } };
  const bool proved = this->Border.Prove(
    whole, [&](std::size_t used) { item.Used |= used < ours ? Faces(1) << used : Faces(0); });
  const std::size_t others = this->Border.Candidates.size() - ours;
  return proved && others + CountBits(item.Used) <= Supports::MostHolders;
}

//------------------------------------------------------------------------------
/// From each old border edge to the new one in its place.
void Prover::HandOver(Item& item)
{
  for (int slot = 0; slot < Supports::MostHolders; ++slot)
  {
    for (std::size_t i = 0; i < this->Change.NewBorder.size(); ++i)
    {
      const bool isHolder = (item.Gone >> slot & 1) != 0 &&
        this->Shared.ByBorders.Holder(item.Id, slot) == this->Change.NewBorder[i].Replaces;
      item.Used |= isHolder ? Faces(1) << i : Faces(0);
    }
  }
}
}
