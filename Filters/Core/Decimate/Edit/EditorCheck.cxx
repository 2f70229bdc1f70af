// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// How an Editor checks an edit: the rules of its kind, then the filters.
#include "CollapseRules.h"
#include "Editor.h"
#include "FlipAndMoveRules.h"
#include "PatchRules.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
Decision Count(Decision decision, EditWorkspace& workspace)
{
  if (decision.IsRejected())
  {
    ++workspace.Counts.Rejections[static_cast<std::size_t>(decision.Reason())];
  }
  return decision;
}
}

Decision Editor::CheckEdge(HalfEdgeId edge, EditWorkspace& workspace) const
{
  const Rejection ends = CheckEnds(this->CurrentMesh, edge);
  if (ends != Rejection::NotRejected)
  {
    return ends;
  }
  Decision topology = workspace.Neighborhood.Gather(this->CurrentMesh, edge)
    ? CheckTopology(this->CurrentMesh, workspace.Neighborhood)
    : Rejection::Valence;
  if (topology.IsAccepted() && this->CurrentMesh.HasPatches())
  {
    topology = CheckPatches(this->CurrentMesh, workspace.Neighborhood, workspace.Change.Range);
  }
  if (!topology.IsAccepted())
  {
    workspace.Neighborhood.Edge = None;
    return topology;
  }
  FillFan(this->CurrentMesh, workspace.Neighborhood,
    workspace.FanArrays.Reserve(static_cast<int>(workspace.Neighborhood.Corners.size())));
  return Decision::Accept();
}

//------------------------------------------------------------------------------
Decision Editor::Gather(HalfEdgeId edge, EditWorkspace& workspace) const
{
  return Count(this->CheckEdge(edge, workspace), workspace);
}

//------------------------------------------------------------------------------
Decision Editor::Check(const Edit& edit, EditWorkspace& workspace) const
{
  this->Propose(edit, workspace);
  Decision decision = edit.Kind == EditKind::Collapse ? this->CheckCollapse(workspace)
    : edit.Kind == EditKind::Flip                     ? this->CheckFlipOf(workspace)
                                                      : this->CheckNewPosition(workspace);
  if (decision.IsAccepted())
  {
    decision = this->RunFilters(workspace);
  }
  return edit.Kind == EditKind::Collapse ? Count(decision, workspace) : decision;
}

//------------------------------------------------------------------------------
/// Rounds the position as it will be written, because the error bound is proved for written
/// positions.
SurfaceChange& Editor::Propose(const Edit& edit, EditWorkspace& workspace) const
{
  SurfaceChange& change = workspace.Change;
  change.Requested = edit;
  if (this->BoundFilter && !edit.KeepStays && edit.Kind != EditKind::Flip)
  {
    change.Requested.Position = this->BoundFilter->Rounded(edit.Position);
  }
  change.Vertex = edit.Keep;
  change.VolumeChange = 0.0;
  change.Unsettled = &workspace.Counts.Volumes;
  return change;
}

//------------------------------------------------------------------------------
Decision Editor::CheckCollapse(EditWorkspace& workspace) const
{
  SurfaceChange& change = workspace.Change;
  if (workspace.Neighborhood.Edge != change.Requested.Edge)
  {
    const Decision decision = this->CheckEdge(change.Requested.Edge, workspace);
    if (!decision.IsAccepted())
    {
      return decision;
    }
  }
  change.SecondRemovedFace = workspace.Neighborhood.RemovedFaces[1];
  const Rejection rejection =
    CheckPosition(this->CurrentMesh, workspace.Neighborhood, workspace.FanArrays.Current(), change);
  if (rejection == Rejection::NotRejected && this->NeedsSurfaceChange)
  {
    change.Fill(this->CurrentMesh, workspace.Neighborhood);
  }
  return rejection;
}

//------------------------------------------------------------------------------
Decision Editor::CheckFlipOf(EditWorkspace& workspace) const
{
  SurfaceChange& change = workspace.Change;
  change.Vertex = this->CurrentMesh.Origin(change.Requested.Edge);
  Decision decision = CheckFlip(this->CurrentMesh, change);
  if (decision.IsAccepted() && this->CurrentMesh.HasPatches())
  {
    const std::array<Index, 4> corners = CornersAround(this->CurrentMesh, change.Requested.Edge);
    decision = CheckNewEdge(this->CurrentMesh, corners[2], corners[3], change.Range);
  }
  if (decision.IsAccepted())
  {
    change.Fill(this->CurrentMesh, workspace.Neighborhood);
  }
  return decision;
}

//------------------------------------------------------------------------------
/// Checks a move or a split.
Decision Editor::CheckNewPosition(EditWorkspace& workspace) const
{
  SurfaceChange& change = workspace.Change;
  const bool isSplit = change.Requested.Kind == EditKind::Split;
  const Rejection rejection = isSplit ? CheckSplit(this->CurrentMesh, change.Requested.Edge)
                                      : CheckMove(this->CurrentMesh, change);
  if (rejection != Rejection::NotRejected)
  {
    return rejection;
  }
  change.Fill(this->CurrentMesh, workspace.Neighborhood);
  if (!isSplit)
  {
    return Decision::Accept();
  }
  change.Vertex = this->CurrentMesh.Origin(change.Requested.Edge);
  return CheckNewFaces(this->CurrentMesh, change);
}

//------------------------------------------------------------------------------
Decision Editor::RunFilters(EditWorkspace& workspace) const
{
  if (workspace.Pending.empty())
  {
    for (const std::shared_ptr<EditFilter>& filter : this->Filters)
    {
      workspace.Pending.push_back(filter->MakePending());
    }
  }
  Decision decision = Decision::Accept();
  for (std::size_t i = 0; i < this->Filters.size() && decision.IsAccepted(); ++i)
  {
    decision = this->Filters[i]->Screen(this->CurrentMesh, workspace.Change, *workspace.Pending[i]);
  }
  for (std::size_t i = 0; i < this->Filters.size() && decision.IsAccepted(); ++i)
  {
    decision = this->Filters[i]->Check(this->CurrentMesh, workspace.Change, *workspace.Pending[i]);
  }
  workspace.Change.Reach = 0.0;
  for (std::size_t i = 0; i < this->Filters.size() && decision.IsAccepted(); ++i)
  {
    workspace.Change.Reach =
      std::max(workspace.Change.Reach, this->Filters[i]->Reach(*workspace.Pending[i]));
  }
  return decision;
}

//------------------------------------------------------------------------------
bool Editor::StillAccepts(EditWorkspace& workspace) const
{
  bool accepts = true;
  for (std::size_t i = 0; i < this->Filters.size() && accepts; ++i)
  {
    accepts =
      this->Filters[i]->StillAccepts(this->CurrentMesh, workspace.Change, *workspace.Pending[i]);
  }
  return accepts;
}
}
