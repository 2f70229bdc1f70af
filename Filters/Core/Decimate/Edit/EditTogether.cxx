// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// What an Editor does to collapse an edge of a feature curve, which is one edge in several manifold
// patches.
#include "CollapseRules.h"
#include "Editor.h"
#include "PatchRules.h"
#include "RingQuadrics.h"

#include <algorithm>

namespace bonedecimate
{
PatchBoundaries* Editor::FeatureCurves()
{
  return this->Curves && this->Curves->NumberOfEdges() > 0 ? this->Curves.get() : nullptr;
}

//------------------------------------------------------------------------------
/// Nothing changes before all patches allow it. Their faces have no corner in common that moves or
/// is removed, so that each is checked on its own.
Rejection Editor::CheckTogether(const std::vector<Edit>& edits)
{
  std::vector<const EdgeNeighborhood*> around;
  for (std::size_t i = 0; i < edits.size(); ++i)
  {
    Workspace& work = this->ManifoldPatches[i].Space;
    const Rejection topology = work.Around.Gather(this->Half, edits[i].Edge)
      ? CheckTopology(this->Half, work.Around)
      : Rejection::Valence;
    if (topology != Rejection::NotRejected)
    {
      return topology;
    }
    around.push_back(&work.Around);
  }
  const VertexId gone = this->Half.Across(edits[0].Edge, edits[0].Keep);
  Rejection rejection = CheckPatchBoundary(this->Half, around, this->Half.OriginalVertex(gone));
  for (std::size_t i = 0; i < edits.size() && rejection == Rejection::NotRejected; ++i)
  {
    PatchEdit& patch = this->ManifoldPatches[i];
    Workspace& work = patch.Space;
    FillFan(
      this->Half, work.Around, work.Faces.Reserve(static_cast<int>(work.Around.Corners.size())));
    rejection =
      CheckPosition(this->Half, work.Around, edits[i], work.Faces.Current(), patch.VolumeChange);
    patch.Origin = this->Half.Position(work.Around.Start);
  }
  return rejection;
}

//------------------------------------------------------------------------------
/// As one edit, with the first workspace.
Decision Editor::FilterTogether(const std::vector<Edit>& edits)
{
  Workspace& first = this->ManifoldPatches[0].Space;
  double volumeChange = 0.0; // mm^3
  for (std::size_t i = 0; i < edits.size(); ++i)
  {
    volumeChange += this->ManifoldPatches[i].VolumeChange;
  }
  ProposedEdit& proposed = this->Propose(edits[0], edits[0].Keep, volumeChange, first, 1);
  proposed.OtherGoneFace = first.Around.GoneFaces[1];
  if (this->NeedsSurfaceChange)
  {
    proposed.Change.FillCollapse(this->Half, first.Around, edits[0]);
    for (std::size_t i = 1; i < edits.size(); ++i)
    {
      proposed.Change.AddCollapse(this->Half, this->ManifoldPatches[i].Space.Around, edits[i]);
    }
  }
  return this->RunFilters(first);
}

//------------------------------------------------------------------------------
Decision Editor::CollapseTogether(const std::vector<Edit>& edits)
{
  if (this->ManifoldPatches.size() < edits.size())
  {
    this->ManifoldPatches.resize(edits.size());
  }
  Decision decision = this->CheckTogether(edits);
  if (decision.IsAccepted())
  {
    decision = this->FilterTogether(edits);
  }
  if (!decision.IsAccepted())
  {
    this->RejectionCounts[static_cast<std::size_t>(decision.Reason())] += decision.IsRejected();
    return decision;
  }
  std::vector<Index> gone;
  for (std::size_t i = 0; i < edits.size(); ++i)
  {
    gone.push_back(this->Half.Across(edits[i].Edge, edits[i].Keep));
    this->ChangeMesh(edits[i], this->ManifoldPatches[i].Space);
  }
  this->Commit(this->ManifoldPatches[0].Space);
  for (std::size_t i = 0; i < edits.size(); ++i)
  {
    PatchEdit& patch = this->ManifoldPatches[i];
    if (this->KeepsQuadrics)
    {
      ExchangeRingQuadrics(
        this->Half, patch.Space.Around, edits[i].Keep, patch.Origin, patch.Space.Faces.Current());
    }
    this->UpdateBookkeeping(edits[i], gone[i], patch.Space);
    this->Settle(patch.Space.Counted);
  }
  this->Edits -= static_cast<std::int64_t>(edits.size()) - 1; // one point was removed
  return Decision::Accept();
}
}
