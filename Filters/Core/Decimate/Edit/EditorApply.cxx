// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// How an Editor makes an edit that was accepted, and undoes collapses of a draft.
#include "Draft.h"
#include "Editor.h"
#include "Geometry/TriangleGeometry.h"
#include "RingQuadrics.h"

#include <cassert>

namespace bonedecimate
{
Decision Editor::Try(const Edit& edit, Workspace& work)
{
  Edit chosen = edit;
  if (edit.Kind == EditKind::Split && !this->PrepareSplit(chosen))
  {
    return Rejection::Shape;
  }
  const Decision decision = this->Check(chosen, work);
  if (decision.IsAccepted())
  {
    this->Apply(work);
  }
  return decision;
}

//------------------------------------------------------------------------------
void Editor::Apply(Workspace& work)
{
  const Edit edit = work.Change.Requested;
  switch (edit.Kind)
  {
    case EditKind::Collapse:
      this->MakeCollapse(edit, work);
      return;
    case EditKind::Split:
      this->MakeSplit(edit, work);
      break;
    case EditKind::Flip:
      this->KeepFirstNormals(work.Change.OldFaces);
      this->Half.Flip(edit.Edge);
      this->Commit(work);
      break;
    case EditKind::Move:
      this->KeepFirstNormals(work.Change.OldFaces);
      this->Half.Move(edit.Keep, edit.Position);
      this->Commit(work);
      break;
  }
  this->CallHook(edit, work);
}

//------------------------------------------------------------------------------
void Editor::MakeCollapse(const Edit& edit, Workspace& work)
{
  const VertexId gone = this->Half.Across(edit.Edge, edit.Keep);
  const Vector3 origin = this->Half.Position(work.Around.Start);
  this->CollapseEdge(edit, work);
  this->Commit(work);
  if (this->KeepsQuadrics)
  {
    ExchangeRingQuadrics(this->Half, work.Around, edit.Keep, origin, work.Faces.Current());
  }
  this->NoteCollapse(edit, gone, work);
}

//------------------------------------------------------------------------------
/// Changes the mesh at the edge that was gathered last.
void Editor::CollapseEdge(const Edit& edit, Workspace& work)
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
void Editor::NoteCollapse(const Edit& edit, VertexId gone, Workspace& work)
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
  this->CallHook(edit, work);
}

//------------------------------------------------------------------------------
void Editor::CallHook(const Edit& edit, Workspace& work)
{
  if (this->AfterEdit)
  {
    this->Settle(&work.Counted);
    this->AfterEdit(*this, edit);
  }
}

//------------------------------------------------------------------------------
void Editor::KeepFirstNormals(const std::vector<Index>& faces)
{
  for (const FaceId face : faces)
  {
    const auto [a, b, c] = PositionsOf(this->Half, face);
    this->Half.KeepFirstNormal(face, AreaVector(a, b, c));
  }
}

//------------------------------------------------------------------------------
/// Commits the edit that all filters accepted and that has been applied to the mesh.
void Editor::Commit(Workspace& work)
{
  for (std::size_t i = 0; i < this->Filters.size(); ++i)
  {
    this->Filters[i]->Commit(this->Half, work.Change, *work.Pending[i], work.Counted);
  }
}

//------------------------------------------------------------------------------
bool Editor::PrepareSplits()
{
  if (this->Recorder)
  {
    return false;
  }
  this->VertexSlots.emplace(FreeVertices(this->Half));
  this->FaceSlots.emplace(FreeFaces(this->Half));
  this->Source.BeginSplits();
  return true;
}

//------------------------------------------------------------------------------
/// Chooses the ids of what is made, near those at the edge. False if there are not enough.
bool Editor::PrepareSplit(Edit& edit)
{
  assert(this->VertexSlots);
  const VertexId start = this->Half.Origin(edit.Edge);
  const HalfEdgeId twin = this->Half.Twin(edit.Edge);
  if (this->VertexSlots->Count() == 0 || this->FaceSlots->Count() < (twin == None ? 1 : 2))
  {
    return false;
  }
  edit.Keep = this->VertexSlots->FindNearest(start);
  edit.Made[0] = this->FaceSlots->FindNearest(HalfEdgeMesh::Face(edit.Edge));
  if (twin != None)
  {
    edit.Made[1] = this->FaceSlots->FindNearest(HalfEdgeMesh::Face(twin), edit.Made[0]);
  }
  const VertexId like = this->Half.IsStationary(start) ? this->Half.Target(edit.Edge) : start;
  for (const std::shared_ptr<EditFilter>& filter : this->Filters)
  {
    filter->Adopt(edit.Keep, like);
  }
  return true;
}

//------------------------------------------------------------------------------
/// Quadrics are not updated.
void Editor::MakeSplit(const Edit& edit, Workspace& work)
{
  const VertexId start = this->Half.Origin(edit.Edge);
  const VertexId end = this->Half.Target(edit.Edge);
  this->KeepFirstNormals(work.Change.OldFaces);
  this->Half.Split(edit);
  this->VertexSlots->Take(edit.Keep);
  for (const SurfaceChange::Face& face : work.Change.NewFaces)
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
  ++this->Total.Splits;
}

//------------------------------------------------------------------------------
/// Nothing that is left depends on it.
void Editor::Undo(EditJournal& journal, Index edit)
{
  const JournalEntry& entry = journal.Entry(edit);
  for (Index i = 0; i < entry.NumberOfFaces; ++i)
  {
    const FaceVersion& face = journal.OldFace(edit, i);
    this->Half.RestoreCorners(face.Face, journal.VerticesOf(face));
    if (face.MadeBy == None && !journal.HadFirstNormal(face.Face))
    {
      this->Half.ForgetFirstNormal(face.Face);
    }
  }
  this->Half.RestoreOutgoing(entry.Keep, entry.Outgoing[0]);
  this->Half.RestoreOutgoing(entry.Gone, entry.Outgoing[1]);
  for (Index i = 0; i < JournalEntry::NumberOfGoneFaces; ++i)
  {
    const FaceVersion& face = journal.OldFace(edit, i);
    const auto side = static_cast<std::size_t>(i);
    this->Half.RestoreTwins(face.Face, entry.Twins[side]);
    for (const VertexId v : journal.VerticesOf(face))
    {
      if (v != entry.Keep && v != entry.Gone)
      {
        this->Half.RestoreOutgoing(v, entry.Outgoing[2 + side]);
      }
    }
  }
  this->Half.Move(entry.Keep, journal.OldPosition(entry));
  this->Half.CountRemovedFaces(-JournalEntry::NumberOfGoneFaces);
  this->Source.Unmerge(entry.Gone);
  --this->Total.Collapses;
  journal.Remove(edit);
}

//------------------------------------------------------------------------------
bool Editor::MakeDraft(int threads, const std::function<bool()>& collapse, const Monitor& monitor)
{
  const bool canDraft = this->Total.Draft.Status == DraftStatus::NotUsed && !this->AfterEdit &&
    (!this->Guard || this->KnowsAround);
  if (!canDraft)
  {
    return true;
  }
  Draft draft(*this, threads);
  const bool goesOn = collapse();
  if (!goesOn)
  {
    draft.Undo();
  }
  return goesOn && draft.Prove(monitor);
}
}
