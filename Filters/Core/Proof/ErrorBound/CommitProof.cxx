// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// What an ErrorBound records when an edit that it proved has been applied.
#include "EditProof.h"
#include "ErrorBound.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
bool IsAsProved(const Coverage& coverage, const std::vector<CoveredItem>& items)
{
  return std::all_of(items.begin(), items.end(),
    [&](const CoveredItem& item) { return coverage.VersionOf(item.Id) == item.Version; });
}

/// @param gone Covering elements that are replaced by the new ones.
void Replace(Coverage& coverage, const std::vector<Index>& gone,
  const std::vector<CoveredItem>& items, const std::vector<Index>& newElements)
{
  for (const Index covering : gone)
  {
    coverage.Forget(covering);
  }
  for (const CoveredItem& item : items)
  {
    for (int slot = 0; slot < Coverage::SlotsPerItem; ++slot)
    {
      if ((item.Gone >> slot & 1) != 0)
      {
        coverage.Free(item.Id, slot);
      }
    }
    for (std::size_t i = 0; i < newElements.size(); ++i)
    {
      if ((item.Used >> i & 1) != 0)
      {
        coverage.Add(item.Id, newElements[i]);
      }
    }
  }
}
}

//------------------------------------------------------------------------------
bool ErrorBound::StillAccepts(
  const HalfEdgeMesh&, const SurfaceChange&, EditFilter::Pending& pending) const
{
  const EditProof& proof = static_cast<const EditProof&>(pending);
  return IsAsProved(this->ByFaces, proof.Items) &&
    IsAsProved(this->ByBoundaries, proof.BoundaryItems);
}

//------------------------------------------------------------------------------
void ErrorBound::Commit(
  const HalfEdgeMesh&, const SurfaceChange& change, EditFilter::Pending& pending, Tally&)
{
  EditProof& proof = static_cast<EditProof&>(pending);
  if (change.Moved != None)
  {
    this->Nearest[change.Moved] = proof.Nearest;
  }
  proof.NewElements.clear();
  for (const SurfaceChange::Face& face : change.NewFaces)
  {
    proof.NewElements.push_back(face.Id);
  }
  Replace(this->ByFaces, change.OldFaces, proof.Items, proof.NewElements);
  if (!change.NewBoundary.empty() && !change.BoundaryStays && change.Moved != None)
  {
    this->NearestBoundary[change.Moved] = proof.NearestBoundary;
  }
  proof.NewElements.clear();
  for (const SurfaceChange::BoundaryEdge& edge : change.NewBoundary)
  {
    proof.NewElements.push_back(edge.Id);
  }
  Replace(this->ByBoundaries, change.OldBoundary, proof.BoundaryItems, proof.NewElements);
}
}
