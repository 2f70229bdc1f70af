// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Changes of an Editor that are several edits at once: the collapse of an edge of a feature curve,
// which is one edge in several manifold patches, and a collapse with moves and flips near it.
#include "CollapseRules.h"
#include "Editor.h"
#include "FlipAndMoveRules.h"
#include "PatchRules.h"
#include "RingQuadrics.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// The half-edge from the first to the second vertex; None if they have no edge.
HalfEdgeId FindHalfEdge(const HalfEdgeMesh& mesh, const EdgeFlip& edge)
{
  HalfEdgeId found;
  for (const HalfEdgeId h : mesh.OutgoingOf(edge.From))
  {
    found = mesh.Target(h) == edge.To ? h : found;
  }
  return found;
}
}

PatchBoundaries* Editor::FeatureCurves()
{
  return this->Curves && this->Curves->NumberOfInitialEdges() > 0 ? this->Curves.get() : nullptr;
}

//------------------------------------------------------------------------------
/// Checks the edit in all patches before any of them changes. Their faces have no corner in common
/// that moves or is removed, so each is checked on its own.
Rejection Editor::CheckTogether(const std::vector<Edit>& edits)
{
  std::vector<const EdgeNeighborhood*> around;
  for (std::size_t i = 0; i < edits.size(); ++i)
  {
    EditWorkspace& workspace = this->PatchWorkspaces[i];
    const Rejection topology = workspace.Neighborhood.Gather(this->CurrentMesh, edits[i].Edge)
      ? CheckTopology(this->CurrentMesh, workspace.Neighborhood)
      : Rejection::Valence;
    if (topology != Rejection::NotRejected)
    {
      return topology;
    }
    around.push_back(&workspace.Neighborhood);
  }
  const VertexId gone = this->CurrentMesh.OtherEnd(edits[0].Edge, edits[0].Keep);
  Rejection rejection =
    CheckPatchBoundary(this->CurrentMesh, around, this->CurrentMesh.OriginalVertex(gone));
  for (std::size_t i = 0; i < edits.size() && rejection == Rejection::NotRejected; ++i)
  {
    EditWorkspace& workspace = this->PatchWorkspaces[i];
    FillFan(this->CurrentMesh, workspace.Neighborhood,
      workspace.FanArrays.Reserve(static_cast<int>(workspace.Neighborhood.Corners.size())));
    rejection = CheckPosition(this->CurrentMesh, workspace.Neighborhood,
      workspace.FanArrays.Current(), this->Propose(edits[i], workspace));
  }
  return rejection;
}

//------------------------------------------------------------------------------
/// Runs the filters on all edits as one change, in the first workspace.
Decision Editor::FilterTogether(const std::vector<Edit>& edits)
{
  EditWorkspace& first = this->PatchWorkspaces[0];
  first.Change.SecondRemovedFace = first.Neighborhood.RemovedFaces[1];
  if (this->NeedsSurfaceChange)
  {
    first.Change.Fill(this->CurrentMesh, first.Neighborhood);
  }
  for (std::size_t i = 1; i < edits.size(); ++i)
  {
    const EditWorkspace& other = this->PatchWorkspaces[i];
    first.Change.VolumeChange += other.Change.VolumeChange;
    if (this->NeedsSurfaceChange)
    {
      first.Change.AddCollapse(this->CurrentMesh, other.Neighborhood, edits[i]);
    }
  }
  return this->RunFilters(first);
}

//------------------------------------------------------------------------------
Decision Editor::Try(const std::vector<Edit>& edits)
{
  if (this->PatchWorkspaces.size() < edits.size())
  {
    this->PatchWorkspaces.resize(edits.size());
  }
  Decision decision = this->CheckTogether(edits);
  if (decision.IsAccepted())
  {
    decision = this->FilterTogether(edits);
  }
  if (!decision.IsAccepted())
  {
    this->Total.Rejections[static_cast<std::size_t>(decision.Reason())] += decision.IsRejected();
    return decision;
  }
  std::vector<Index> gone;
  std::vector<Vector3> origins; // mm, of the fans
  for (std::size_t i = 0; i < edits.size(); ++i)
  {
    gone.push_back(this->CurrentMesh.OtherEnd(edits[i].Edge, edits[i].Keep));
    origins.push_back(this->CurrentMesh.Position(this->PatchWorkspaces[i].Neighborhood.Start));
    this->CollapseEdge(edits[i], this->PatchWorkspaces[i]);
  }
  this->Commit(this->PatchWorkspaces[0]);
  for (std::size_t i = 0; i < edits.size(); ++i)
  {
    EditWorkspace& workspace = this->PatchWorkspaces[i];
    if (this->KeepsQuadrics)
    {
      ExchangeRingQuadrics(this->CurrentMesh, workspace.Neighborhood, edits[i].Keep, origins[i],
        workspace.FanArrays.Current());
    }
    this->NoteCollapse(edits[i], gone[i], workspace);
    this->Settle(&workspace.Counts);
  }
  this->Total.Collapses -= static_cast<std::int64_t>(edits.size()) - 1; // one point was removed
  return Decision::Accept();
}

//------------------------------------------------------------------------------
/// Applies the parts of the edit without checks.
void Editor::ApplyTogether(
  const Edit& edit, const NearbyEdits& nearby, const EditWorkspace& workspace)
{
  this->CurrentMesh.Collapse(workspace.Neighborhood, edit.Keep, edit.Position);
  for (const VertexMove& move : nearby.Moves)
  {
    this->CurrentMesh.Move(move.Vertex, move.Position);
  }
  for (const EdgeFlip& flip : nearby.Flips)
  {
    this->CurrentMesh.Flip(FindHalfEdge(this->CurrentMesh, flip));
  }
}

//------------------------------------------------------------------------------
/// Makes the flips one after the other. Saves their faces and adds them to the old ones.
Decision Editor::TryFlips(
  const std::vector<EdgeFlip>& flips, std::vector<Index>& oldFaces, HalfEdgeMesh::Saved& saved)
{
  for (const EdgeFlip& flip : flips)
  {
    const HalfEdgeId edge = FindHalfEdge(this->CurrentMesh, flip);
    if (edge == None || this->CurrentMesh.Twin(edge) == None)
    {
      return Rejection::Boundary;
    }
    const std::array<Index, 4> corners = CornersAround(this->CurrentMesh, edge);
    const Rejection topology = CheckFlipTopology(this->CurrentMesh, corners);
    const Decision decision = topology != Rejection::NotRejected ? Decision(topology)
      : this->CurrentMesh.HasPatches() ? CheckNewEdge(this->CurrentMesh, corners[2], corners[3], {})
                                       : Decision::Accept();
    if (!decision.IsAccepted())
    {
      return decision;
    }
    for (const Index face :
      { HalfEdgeMesh::Face(edge), HalfEdgeMesh::Face(this->CurrentMesh.Twin(edge)) })
    {
      this->SaveOnce(face, oldFaces, saved);
    }
    this->CurrentMesh.Flip(edge);
  }
  return Decision::Accept();
}

//------------------------------------------------------------------------------
void Editor::SaveOnce(FaceId face, std::vector<Index>& oldFaces, HalfEdgeMesh::Saved& saved) const
{
  if (std::find(oldFaces.begin(), oldFaces.end(), face) == oldFaces.end())
  {
    oldFaces.push_back(face);
    this->CurrentMesh.Save(face, saved);
  }
}

//------------------------------------------------------------------------------
/// Fills the change: makes the edit, reads the new faces, and undoes the edit.
Decision Editor::FillTogether(const Edit& edit, const NearbyEdits& nearby, EditWorkspace& workspace)
{
  SurfaceChange& change = workspace.Change;
  change.Fill(this->CurrentMesh, workspace.Neighborhood);
  HalfEdgeMesh::Saved saved;
  for (const Index face : change.OldFaces)
  {
    this->CurrentMesh.Save(face, saved);
  }
  for (const VertexMove& move : nearby.Moves)
  {
    for (const HalfEdgeId h : this->CurrentMesh.OutgoingOf(move.Vertex))
    {
      this->SaveOnce(HalfEdgeMesh::Face(h), change.OldFaces, saved);
    }
  }
  this->ApplyTogether(edit, { nearby.Moves, {} }, workspace);
  const Decision decision = this->TryFlips(nearby.Flips, change.OldFaces, saved);
  change.TakeNewFaces(this->CurrentMesh);
  this->CurrentMesh.Restore(saved);
  return decision;
}

//------------------------------------------------------------------------------
Decision Editor::Try(const Edit& collapse, const NearbyEdits& requested, EditWorkspace& workspace)
{
  SurfaceChange& change = this->Propose(collapse, workspace);
  const Edit edit = change.Requested;
  NearbyEdits nearby = requested;
  for (VertexMove& move : nearby.Moves)
  {
    move.Position = this->BoundFilter ? this->BoundFilter->Rounded(move.Position) : move.Position;
  }
  const auto movesFreely = [this](VertexId v) { return this->CurrentMesh.MovesFreely(v); };
  if (!movesFreely(this->CurrentMesh.Origin(edit.Edge)) ||
    !movesFreely(this->CurrentMesh.Target(edit.Edge)) ||
    !std::all_of(nearby.Moves.begin(), nearby.Moves.end(),
      [&](const VertexMove& move) { return movesFreely(move.Vertex); }))
  {
    return Rejection::Boundary;
  }
  Decision decision = this->CheckEdge(edit.Edge, workspace);
  if (!decision.IsAccepted())
  {
    return decision;
  }
  change.SecondRemovedFace = workspace.Neighborhood.RemovedFaces[1];
  decision = this->FillTogether(edit, nearby, workspace);
  if (decision.IsAccepted())
  {
    decision = CheckNewFaces(this->CurrentMesh, change);
  }
  if (decision.IsAccepted())
  {
    decision = this->RunFilters(workspace);
  }
  if (decision.IsAccepted())
  {
    this->CommitTogether(edit, nearby, workspace);
  }
  return decision;
}

//------------------------------------------------------------------------------
void Editor::CommitTogether(const Edit& edit, const NearbyEdits& nearby, EditWorkspace& workspace)
{
  const VertexId gone = this->CurrentMesh.OtherEnd(edit.Edge, edit.Keep);
  const std::vector<SurfaceChange::Face>& made = workspace.Change.NewFaces;
  std::vector<Index> faces(made.size());
  std::transform(made.begin(), made.end(), faces.begin(),
    [](const SurfaceChange::Face& face) { return face.Id; });
  this->StoreInitialNormals(faces);
  this->ApplyTogether(edit, nearby, workspace);
  this->Commit(workspace);
  this->NoteCollapse(edit, gone, workspace);
  this->Settle(&workspace.Counts);
  if (this->Recorder)
  {
    this->Recorder->AddNearby(
      nearby.Moves, nearby.Flips.empty() ? std::vector<SurfaceChange::Face>() : made);
  }
}
}
