// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// What an Editor does to split an edge.
#include "Editor.h"
#include "FlipAndMoveRules.h"
#include "SplitRules.h"

#include <cassert>

namespace bonedecimate
{
bool Editor::BeginSplits()
{
  if (this->Recorder || this->Drafted)
  {
    return false;
  }
  this->VertexSlots.emplace(FreeVertices(this->Half));
  this->FaceSlots.emplace(FreeFaces(this->Half));
  this->Source.BeginSplits();
  return true;
}

//------------------------------------------------------------------------------
/// False if there are not enough ids.
bool Editor::ChooseSlots(Edit& edit)
{
  const HalfEdgeId twin = this->Half.Twin(edit.Edge);
  const Index faces = twin == None ? 1 : 2;
  if (this->VertexSlots->Count() == 0 || this->FaceSlots->Count() < faces)
  {
    return false;
  }
  edit.Keep = this->VertexSlots->FindNearest(this->Half.Origin(edit.Edge));
  edit.Made[0] = this->FaceSlots->FindNearest(HalfEdgeMesh::Face(edit.Edge));
  if (twin != None)
  {
    edit.Made[1] = this->FaceSlots->FindNearest(HalfEdgeMesh::Face(twin), edit.Made[0]);
  }
  return true;
}

//------------------------------------------------------------------------------
/// Quadrics are not updated.
void Editor::ApplySplit(const Edit& edit, Workspace& work)
{
  const VertexId start = this->Half.Origin(edit.Edge);
  const VertexId end = this->Half.Target(edit.Edge);
  for (const Index face : work.Proposed.Change.OldFaces)
  {
    this->KeepFirstNormal(face);
  }
  this->Half.Split(edit);
  this->VertexSlots->Take(edit.Keep);
  for (const SurfaceChange::Face& face : work.Proposed.Change.NewFaces)
  {
    if (face.SplitFrom != None)
    {
      this->FaceSlots->Take(face.Id);
      --work.Counted.RemovedFaces;
    }
    if (this->FaceGeometry)
    {
      this->FaceGeometry->Update(this->Half, face.Id);
    }
  }
  this->Commit(work);
  this->Source.Make(edit.Keep, start, end, edit.Position);
  ++this->NumberOfSplitEdges;
  if (this->AfterEdit)
  {
    this->Settle(work.Counted);
    this->AfterEdit(*this, edit);
  }
}

//------------------------------------------------------------------------------
Decision Editor::Split(HalfEdgeId edge, const Vector3& position, Workspace& work)
{
  assert(this->VertexSlots && !this->Drafted);
  const Rejection rule = CheckSplit(this->Half, edge);
  if (rule != Rejection::NotRejected)
  {
    return rule;
  }
  Edit edit;
  edit.Kind = EditKind::Split;
  edit.Edge = edge;
  edit.Position = this->Rounded(position);
  if (!this->ChooseSlots(edit))
  {
    return Rejection::Shape;
  }
  const VertexId start = this->Half.Origin(edge);
  const VertexId end = this->Half.Target(edge);
  const VertexId like = this->Half.IsStationary(start) ? end : start;
  ProposedEdit& proposed = this->Propose(edit, start, 0.0, work, 1);
  proposed.Change.FillSplit(this->Half, edit);
  const Rejection rejection = CheckNewFaces(this->Half, proposed.Change, proposed.VolumeChange);
  if (rejection != Rejection::NotRejected)
  {
    return rejection;
  }
  for (const std::shared_ptr<EditFilter>& filter : this->Filters)
  {
    filter->Adopt(edit.Keep, like);
  }
  const Decision decision = this->RunFilters(work);
  if (decision.IsAccepted())
  {
    this->ApplySplit(edit, work);
  }
  return decision;
}
}
