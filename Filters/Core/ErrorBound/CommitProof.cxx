// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// What a Prover records when the edit that it proved last has been applied.
#include "Prover.h"

namespace bonedecimate
{
void Prover::Commit(const SurfaceChange& change)
{
  this->Change = &change;
  if (this->Change->Moved != None)
  {
    this->Shared.Nearest[this->Change->Moved] = this->MovedCorner.Nearest;
  }
  this->NewElements.clear();
  for (const SurfaceChange::Face& face : this->Change->NewFaces)
  {
    this->NewElements.push_back(face.Id);
  }
  Commit(this->Shared.ByFaces, this->Change->OldFaces, this->Items, this->NewElements);
  if (!this->Change->NewBoundary.empty() && !this->Change->BoundaryStays &&
    this->Change->Moved != None)
  {
    this->Shared.NearestBoundary[this->Change->Moved] = this->BoundaryHint;
  }
  this->NewElements.clear();
  for (const SurfaceChange::BoundaryEdge& edge : this->Change->NewBoundary)
  {
    this->NewElements.push_back(edge.Id);
  }
  Commit(
    this->Shared.ByBoundaries, this->Change->OldBoundary, this->BoundaryItems, this->NewElements);
}

//------------------------------------------------------------------------------
void Prover::Commit(Coverage& coverage, const std::vector<Index>& gone, SparseSet<Item>& items,
  const std::vector<Index>& coverings)
{
  for (const Index covering : gone)
  {
    coverage.Forget(covering);
  }
  for (const Item& item : items)
  {
    for (int slot = 0; slot < Coverage::SlotsPerItem; ++slot)
    {
      if ((item.Gone >> slot & 1) != 0)
      {
        coverage.Free(item.Id, slot);
      }
    }
    for (std::size_t i = 0; i < coverings.size(); ++i)
    {
      if ((item.Used >> i & 1) != 0)
      {
        coverage.Add(item.Id, coverings[i]);
      }
    }
  }
}
}
