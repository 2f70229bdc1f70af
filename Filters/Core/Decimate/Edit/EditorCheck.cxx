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
Decision Count(Decision decision, Workspace& work)
{
  if (decision.IsRejected())
  {
    ++work.Counted.Rejections[static_cast<std::size_t>(decision.Reason())];
  }
  return decision;
}
}

Decision Editor::CheckEdge(HalfEdgeId edge, Workspace& work) const
{
  const Rejection ends = CheckEnds(this->Half, edge);
  if (ends != Rejection::NotRejected)
  {
    return ends;
  }
  Decision topology = work.Around.Gather(this->Half, edge) ? CheckTopology(this->Half, work.Around)
                                                           : Rejection::Valence;
  if (topology.IsAccepted() && this->Half.HasPatches())
  {
    topology = CheckPatches(this->Half, work.Around, work.Change.Range);
  }
  if (!topology.IsAccepted())
  {
    work.Around.Edge = None;
    return topology;
  }
  FillFan(
    this->Half, work.Around, work.Faces.Reserve(static_cast<int>(work.Around.Corners.size())));
  return Decision::Accept();
}

//------------------------------------------------------------------------------
Decision Editor::Gather(HalfEdgeId edge, Workspace& work) const
{
  return Count(this->CheckEdge(edge, work), work);
}

//------------------------------------------------------------------------------
Decision Editor::Check(const Edit& edit, Workspace& work) const
{
  this->Propose(edit, work);
  Decision decision = edit.Kind == EditKind::Collapse ? this->CheckCollapse(work)
    : edit.Kind == EditKind::Flip                     ? this->CheckFlipOf(work)
                                                      : this->CheckNewPosition(work);
  if (decision.IsAccepted())
  {
    decision = this->RunFilters(work);
  }
  return edit.Kind == EditKind::Collapse ? Count(decision, work) : decision;
}

//------------------------------------------------------------------------------
/// With the position where the point will be when it has been written: only then the error bound
/// can be proved.
SurfaceChange& Editor::Propose(const Edit& edit, Workspace& work) const
{
  SurfaceChange& change = work.Change;
  change.Requested = edit;
  if (this->BoundFilter && !edit.KeepStays && edit.Kind != EditKind::Flip)
  {
    change.Requested.Position = this->BoundFilter->Rounded(edit.Position);
  }
  change.Vertex = edit.Keep;
  change.VolumeChange = 0.0;
  change.Unsettled = &work.Counted.Volumes;
  return change;
}

//------------------------------------------------------------------------------
Decision Editor::CheckCollapse(Workspace& work) const
{
  SurfaceChange& change = work.Change;
  if (work.Around.Edge != change.Requested.Edge)
  {
    const Decision decision = this->CheckEdge(change.Requested.Edge, work);
    if (!decision.IsAccepted())
    {
      return decision;
    }
  }
  change.OtherGoneFace = work.Around.GoneFaces[1];
  const Rejection rejection = CheckPosition(this->Half, work.Around, work.Faces.Current(), change);
  if (rejection == Rejection::NotRejected && this->NeedsSurfaceChange)
  {
    change.Fill(this->Half, work.Around);
  }
  return rejection;
}

//------------------------------------------------------------------------------
Decision Editor::CheckFlipOf(Workspace& work) const
{
  SurfaceChange& change = work.Change;
  change.Vertex = this->Half.Origin(change.Requested.Edge);
  Decision decision = CheckFlip(this->Half, change);
  if (decision.IsAccepted() && this->Half.HasPatches())
  {
    const std::array<Index, 4> corners = CornersAround(this->Half, change.Requested.Edge);
    decision = CheckNewEdge(this->Half, corners[2], corners[3], change.Range);
  }
  if (decision.IsAccepted())
  {
    change.Fill(this->Half, work.Around);
  }
  return decision;
}

//------------------------------------------------------------------------------
/// Checks a move or a split.
Decision Editor::CheckNewPosition(Workspace& work) const
{
  SurfaceChange& change = work.Change;
  const bool isSplit = change.Requested.Kind == EditKind::Split;
  const Rejection rejection =
    isSplit ? CheckSplit(this->Half, change.Requested.Edge) : CheckMove(this->Half, change);
  if (rejection != Rejection::NotRejected)
  {
    return rejection;
  }
  change.Fill(this->Half, work.Around);
  if (!isSplit)
  {
    return Decision::Accept();
  }
  change.Vertex = this->Half.Origin(change.Requested.Edge);
  return CheckNewFaces(this->Half, change);
}

//------------------------------------------------------------------------------
Decision Editor::RunFilters(Workspace& work) const
{
  if (work.Pending.empty())
  {
    for (const std::shared_ptr<EditFilter>& filter : this->Filters)
    {
      work.Pending.push_back(filter->MakePending());
    }
  }
  Decision decision = Decision::Accept();
  for (std::size_t i = 0; i < this->Filters.size() && decision.IsAccepted(); ++i)
  {
    decision = this->Filters[i]->Screen(this->Half, work.Change, *work.Pending[i]);
  }
  for (std::size_t i = 0; i < this->Filters.size() && decision.IsAccepted(); ++i)
  {
    decision = this->Filters[i]->Check(this->Half, work.Change, *work.Pending[i]);
  }
  work.Change.Reach = 0.0;
  for (std::size_t i = 0; i < this->Filters.size() && decision.IsAccepted(); ++i)
  {
    work.Change.Reach = std::max(work.Change.Reach, this->Filters[i]->Reach(*work.Pending[i]));
  }
  return decision;
}

//------------------------------------------------------------------------------
bool Editor::StillAccepts(Workspace& work) const
{
  bool accepts = true;
  for (std::size_t i = 0; i < this->Filters.size() && accepts; ++i)
  {
    accepts = this->Filters[i]->StillAccepts(this->Half, work.Change, *work.Pending[i]);
  }
  return accepts;
}
}
