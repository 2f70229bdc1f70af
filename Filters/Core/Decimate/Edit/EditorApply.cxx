// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// How an Editor applies an accepted edit, and undoes collapses of a draft.
#include "Draft.h"
#include "Editor.h"
#include "Geometry/TriangleGeometry.h"
#include "RingQuadrics.h"

#include <cassert>

namespace bonedecimate
{
Decision Editor::Try(const Edit& edit, EditWorkspace& workspace)
{
  Edit chosen = edit;
  if (edit.Kind == EditKind::Split && !this->PrepareSplit(chosen))
  {
    return Rejection::Shape;
  }
  const Decision decision = this->Check(chosen, workspace);
  if (decision.IsAccepted())
  {
    this->Apply(workspace);
  }
  return decision;
}

//------------------------------------------------------------------------------
void Editor::Apply(EditWorkspace& workspace)
{
  const Edit edit = workspace.Change.Requested;
  switch (edit.Kind)
  {
    case EditKind::Collapse:
      this->MakeCollapse(edit, workspace);
      return;
    case EditKind::Split:
      this->MakeSplit(edit, workspace);
      break;
    case EditKind::Flip:
      this->StoreInitialNormals(workspace.Change.OldFaces);
      this->CurrentMesh.Flip(edit.Edge);
      this->Commit(workspace);
      break;
    case EditKind::Move:
      this->StoreInitialNormals(workspace.Change.OldFaces);
      this->CurrentMesh.Move(edit.Keep, edit.Position);
      this->Commit(workspace);
      break;
  }
  this->CallHook(edit, workspace);
}

//------------------------------------------------------------------------------
void Editor::MakeCollapse(const Edit& edit, EditWorkspace& workspace)
{
  const VertexId gone = this->CurrentMesh.OtherEnd(edit.Edge, edit.Keep);
  const Vector3 origin = this->CurrentMesh.Position(workspace.Neighborhood.Start);
  this->CollapseEdge(edit, workspace);
  this->Commit(workspace);
  if (this->KeepsQuadrics)
  {
    ExchangeRingQuadrics(
      this->CurrentMesh, workspace.Neighborhood, edit.Keep, origin, workspace.FanArrays.Current());
  }
  this->NoteCollapse(edit, gone, workspace);
}

//------------------------------------------------------------------------------
/// Collapses the edge that was gathered last in the mesh.
void Editor::CollapseEdge(const Edit& edit, EditWorkspace& workspace)
{
  const Fan& fan = workspace.FanArrays.Current();
  for (std::size_t i = 0; i < workspace.Neighborhood.Corners.size(); ++i)
  {
    const Vector3 twice(fan.OldArea[0][i], fan.OldArea[1][i], fan.OldArea[2][i]); // mm^2
    this->CurrentMesh.StoreInitialNormal(
      HalfEdgeMesh::Face(workspace.Neighborhood.Corners[i]), 0.5 * twice);
  }
  this->CurrentMesh.Collapse(workspace.Neighborhood, edit.Keep, edit.Position);
}

//------------------------------------------------------------------------------
void Editor::NoteCollapse(const Edit& edit, VertexId gone, EditWorkspace& workspace)
{
  if (this->FaceGeometry)
  {
    for (const HalfEdgeId h : workspace.Neighborhood.Corners)
    {
      this->FaceGeometry->Update(this->CurrentMesh, HalfEdgeMesh::Face(h));
    }
  }
  this->OriginalSurface.Merge(edit.Keep, gone, edit.Position);
  workspace.Counts.RemovedFaces += workspace.Neighborhood.NumberOfRemovedFaces;
  workspace.Neighborhood.Edge = None;
  ++workspace.Counts.Edits;
  this->CallHook(edit, workspace);
}

//------------------------------------------------------------------------------
void Editor::CallHook(const Edit& edit, EditWorkspace& workspace)
{
  if (this->EditHook)
  {
    this->Settle(&workspace.Counts);
    this->EditHook(*this, edit);
  }
}

//------------------------------------------------------------------------------
void Editor::StoreInitialNormals(const std::vector<Index>& faces)
{
  for (const FaceId face : faces)
  {
    const auto [a, b, c] = PositionsOf(this->CurrentMesh, face);
    this->CurrentMesh.StoreInitialNormal(face, AreaVector(a, b, c));
  }
}

//------------------------------------------------------------------------------
/// Commits the edit, which all filters accepted and the mesh contains.
void Editor::Commit(EditWorkspace& workspace)
{
  for (std::size_t i = 0; i < this->Filters.size(); ++i)
  {
    this->Filters[i]->Commit(
      this->CurrentMesh, workspace.Change, *workspace.Pending[i], workspace.Counts);
  }
}

//------------------------------------------------------------------------------
bool Editor::PrepareSplits()
{
  if (this->Recorder)
  {
    return false;
  }
  this->FreeVertexIds.emplace(FreeVertices(this->CurrentMesh));
  this->FreeFaceIds.emplace(FreeFaces(this->CurrentMesh));
  this->OriginalSurface.BeginSplits();
  return true;
}

//------------------------------------------------------------------------------
/// Chooses ids for the new vertex and faces, near those at the edge. False if there are not enough.
bool Editor::PrepareSplit(Edit& edit)
{
  assert(this->FreeVertexIds);
  const VertexId start = this->CurrentMesh.Origin(edit.Edge);
  const HalfEdgeId twin = this->CurrentMesh.Twin(edit.Edge);
  if (this->FreeVertexIds->Count() == 0 || this->FreeFaceIds->Count() < (twin == None ? 1 : 2))
  {
    return false;
  }
  edit.Keep = this->FreeVertexIds->FindNearest(start);
  edit.Made[0] = this->FreeFaceIds->FindNearest(HalfEdgeMesh::Face(edit.Edge));
  if (twin != None)
  {
    edit.Made[1] = this->FreeFaceIds->FindNearest(HalfEdgeMesh::Face(twin), edit.Made[0]);
  }
  const VertexId like =
    this->CurrentMesh.IsStationary(start) ? this->CurrentMesh.Target(edit.Edge) : start;
  for (const std::shared_ptr<EditFilter>& filter : this->Filters)
  {
    filter->Adopt(edit.Keep, like);
  }
  return true;
}

//------------------------------------------------------------------------------
/// Quadrics are not updated.
void Editor::MakeSplit(const Edit& edit, EditWorkspace& workspace)
{
  const VertexId start = this->CurrentMesh.Origin(edit.Edge);
  const VertexId end = this->CurrentMesh.Target(edit.Edge);
  this->StoreInitialNormals(workspace.Change.OldFaces);
  this->CurrentMesh.Split(edit);
  this->FreeVertexIds->Take(edit.Keep);
  for (const SurfaceChange::Face& face : workspace.Change.NewFaces)
  {
    if (face.SplitFrom != None)
    {
      this->FreeFaceIds->Take(face.Id);
      --workspace.Counts.RemovedFaces;
    }
    if (this->FaceGeometry)
    {
      this->FaceGeometry->Update(this->CurrentMesh, face.Id);
    }
  }
  this->Commit(workspace);
  this->OriginalSurface.Make(edit.Keep, start, end, edit.Position);
  ++this->Total.Splits;
}

//------------------------------------------------------------------------------
/// Requires that no remaining edit depends on this one.
void Editor::Undo(EditJournal& journal, Index edit)
{
  const JournalEntry& entry = journal.Entry(edit);
  for (Index i = 0; i < entry.NumberOfFaces; ++i)
  {
    const FaceVersion& face = journal.OldFace(edit, i);
    this->CurrentMesh.RestoreCorners(face.Face, journal.VerticesOf(face));
    if (face.MadeBy == None && !journal.HadInitialNormal(face.Face))
    {
      this->CurrentMesh.ForgetInitialNormal(face.Face);
    }
  }
  this->CurrentMesh.RestoreOutgoing(entry.Keep, entry.Outgoing[0]);
  this->CurrentMesh.RestoreOutgoing(entry.Gone, entry.Outgoing[1]);
  for (Index i = 0; i < JournalEntry::NumberOfRemovedFaces; ++i)
  {
    const FaceVersion& face = journal.OldFace(edit, i);
    const auto side = static_cast<std::size_t>(i);
    this->CurrentMesh.RestoreTwins(face.Face, entry.Twins[side]);
    for (const VertexId v : journal.VerticesOf(face))
    {
      if (v != entry.Keep && v != entry.Gone)
      {
        this->CurrentMesh.RestoreOutgoing(v, entry.Outgoing[2 + side]);
      }
    }
  }
  this->CurrentMesh.Move(entry.Keep, journal.OldPosition(entry));
  this->CurrentMesh.CountRemovedFaces(-JournalEntry::NumberOfRemovedFaces);
  this->OriginalSurface.Unmerge(entry.Gone);
  --this->Total.Collapses;
  journal.Remove(edit);
}

//------------------------------------------------------------------------------
bool Editor::MakeDraft(int threads, const std::function<bool()>& collapse, const Monitor& monitor)
{
  const bool canDraft = this->Total.Draft.Status == DraftStatus::NotUsed && !this->EditHook &&
    (!this->Guard || this->KnowsOriginalNearby);
  if (!canDraft)
  {
    return true;
  }
  Draft draft(*this, threads);
  if (!draft.Begin(monitor))
  {
    return false;
  }
  const bool shouldContinue = collapse();
  if (!shouldContinue)
  {
    draft.Undo();
  }
  return shouldContinue && draft.Prove(monitor);
}
}
