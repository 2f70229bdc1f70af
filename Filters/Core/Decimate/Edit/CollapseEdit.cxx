// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// What an Editor does to collapse an edge.
#include "CollapseRules.h"
#include "Editor.h"
#include "PatchRules.h"
#include "RingQuadrics.h"

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
    topology = CheckPatches(this->Half, work.Around, work.Range);
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
Decision Editor::Validate(HalfEdgeId edge)
{
  const Decision decision = this->Validate(edge, this->Own);
  this->Settle(this->Own.Counted);
  return decision;
}

//------------------------------------------------------------------------------
Decision Editor::Validate(HalfEdgeId edge, Workspace& work) const
{
  return Count(this->CheckEdge(edge, work), work);
}

//------------------------------------------------------------------------------
Decision Editor::Collapse(const Edit& edit)
{
  const Decision decision = this->Collapse(edit, this->Own, 1);
  this->Settle(this->Own.Counted);
  return decision;
}

//------------------------------------------------------------------------------
Decision Editor::Collapse(const Edit& edit, Workspace& work, int workers)
{
  const Decision decision = this->CheckCollapse(edit, work, workers);
  if (decision.IsAccepted())
  {
    this->ApplyCollapse(work);
  }
  return decision;
}

//------------------------------------------------------------------------------
Decision Editor::CheckCollapse(const Edit& requested, Workspace& work, int workers) const
{
  Edit edit = requested;
  edit.Position = edit.KeepStays ? edit.Position : this->Rounded(edit.Position);
  if (work.Around.Edge != edit.Edge)
  {
    const Decision decision = this->Validate(edit.Edge, work);
    if (!decision.IsAccepted())
    {
      return decision;
    }
  }
  double volumeChange = 0.0; // mm^3
  const Rejection rejection =
    CheckPosition(this->Half, work.Around, edit, work.Faces.Current(), volumeChange);
  if (rejection != Rejection::NotRejected)
  {
    return Count(rejection, work);
  }
  ProposedEdit& proposed = this->Propose(edit, edit.Keep, volumeChange, work, workers);
  proposed.OtherGoneFace = work.Around.GoneFaces[1];
  proposed.Rank = work.Rank;
  proposed.AccumulatedError = work.AccumulatedError;
  if (this->NeedsSurfaceChange)
  {
    proposed.Change.FillCollapse(this->Half, work.Around, edit);
  }
  return Count(this->RunFilters(work), work);
}

//------------------------------------------------------------------------------
void Editor::ApplyCollapse(Workspace& work)
{
  const Edit edit = work.Proposed.Requested;
  const VertexId gone = this->Half.Across(edit.Edge, edit.Keep);
  const Vector3 origin = this->Half.Position(work.Around.Start);
  this->ChangeMesh(edit, work);
  this->Commit(work);
  if (this->KeepsQuadrics)
  {
    ExchangeRingQuadrics(this->Half, work.Around, edit.Keep, origin, work.Faces.Current());
  }
  this->UpdateBookkeeping(edit, gone, work);
}

//------------------------------------------------------------------------------
double Editor::Reach(const Workspace& work) const
{
  double reach = 0.0;
  for (std::size_t i = 0; i < this->Filters.size(); ++i)
  {
    reach = std::max(reach, this->Filters[i]->Reach(*work.Pending[i]));
  }
  return reach;
}

//------------------------------------------------------------------------------
bool Editor::StillAccepts(Workspace& work) const
{
  bool accepts = true;
  for (std::size_t i = 0; i < this->Filters.size() && accepts; ++i)
  {
    accepts = this->Filters[i]->StillAccepts(this->Half, work.Proposed, *work.Pending[i]);
  }
  return accepts;
}

//------------------------------------------------------------------------------
/// The edge validated last with this workspace.
void Editor::ChangeMesh(const Edit& edit, Workspace& work)
{
  const Fan& fan = work.Faces.Current();
  for (std::size_t i = 0; i < work.Around.Corners.size(); ++i)
  {
    const Vector3 twice(fan.OldArea[0][i], fan.OldArea[1][i], fan.OldArea[2][i]); // mm^2
    this->Half.KeepFirstNormal(HalfEdgeMesh::Face(work.Around.Corners[i]), 0.5 * twice);
  }
  this->Half.Collapse(work.Around, edit.Keep, edit.Position);
}

//------------------------------------------------------------------------------
void Editor::UpdateBookkeeping(const Edit& edit, VertexId gone, Workspace& work)
{
  if (this->FaceGeometry)
  {
    for (const HalfEdgeId h : work.Around.Corners)
    {
      this->FaceGeometry->Update(this->Half, HalfEdgeMesh::Face(h));
    }
  }
  this->Source.Merge(edit.Keep, gone, edit.Position);
  work.Counted.RemovedFaces += work.Around.NumberOfGoneFaces;
  work.Around.Edge = None;
  ++work.Counted.Edits;
  if (this->AfterEdit)
  {
    this->Settle(work.Counted);
    this->AfterEdit(*this, edit);
  }
}
}
