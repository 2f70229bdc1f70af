// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// What an Editor does to collapse an edge, move vertices and flip edges near it as one edit.
#include "Editor.h"
#include "FlipAndMoveRules.h"
#include "PatchRules.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// From the first to the second vertex; None if they have no edge.
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

//------------------------------------------------------------------------------
/// The parts of the edit, without rules.
void Editor::ApplyTogether(const Edit& edit, const NearbyEdits& nearby, const Workspace& work)
{
  this->Half.Collapse(work.Around, edit.Keep, edit.Position);
  for (const VertexMove& move : nearby.Moves)
  {
    this->Half.Move(move.Vertex, move.Position);
  }
  for (const EdgeFlip& flip : nearby.Flips)
  {
    this->Half.Flip(FindHalfEdge(this->Half, flip));
  }
}

//------------------------------------------------------------------------------
/// One after the other; the faces are saved and added to the old ones.
Decision Editor::TryFlips(
  const std::vector<EdgeFlip>& flips, std::vector<Index>& oldFaces, HalfEdgeMesh::Saved& saved)
{
  for (const EdgeFlip& flip : flips)
  {
    const HalfEdgeId edge = FindHalfEdge(this->Half, flip);
    if (edge == None || this->Half.Twin(edge) == None)
    {
      return Rejection::Boundary;
    }
    const std::array<Index, 4> corners = CornersAround(this->Half, edge);
    const Rejection topology = CheckFlipTopology(this->Half, corners);
    const Decision decision = topology != Rejection::NotRejected ? Decision(topology)
      : this->Half.HasPatches() ? CheckNewEdge(this->Half, corners[2], corners[3], {})
                                : Decision::Accept();
    if (!decision.IsAccepted())
    {
      return decision;
    }
    for (const Index face : { HalfEdgeMesh::Face(edge), HalfEdgeMesh::Face(this->Half.Twin(edge)) })
    {
      this->SaveOnce(face, oldFaces, saved);
    }
    this->Half.Flip(edge);
  }
  return Decision::Accept();
}

//------------------------------------------------------------------------------
void Editor::SaveOnce(FaceId face, std::vector<Index>& oldFaces, HalfEdgeMesh::Saved& saved) const
{
  if (std::find(oldFaces.begin(), oldFaces.end(), face) == oldFaces.end())
  {
    oldFaces.push_back(face);
    this->Half.Save(face, saved);
  }
}

//------------------------------------------------------------------------------
/// Makes the edit, reads the new faces and undoes it.
Decision Editor::FillTogether(const Edit& edit, const NearbyEdits& nearby, Workspace& work)
{
  SurfaceChange& change = work.Proposed.Change;
  change.FillCollapse(this->Half, work.Around, edit);
  HalfEdgeMesh::Saved saved;
  for (const Index face : change.OldFaces)
  {
    this->Half.Save(face, saved);
  }
  for (const VertexMove& move : nearby.Moves)
  {
    for (const HalfEdgeId h : this->Half.OutgoingOf(move.Vertex))
    {
      this->SaveOnce(HalfEdgeMesh::Face(h), change.OldFaces, saved);
    }
  }
  this->ApplyTogether(edit, { nearby.Moves, {} }, work);
  const Decision decision = this->TryFlips(nearby.Flips, change.OldFaces, saved);
  change.TakeNewFaces(this->Half);
  this->Half.Restore(saved);
  return decision;
}

//------------------------------------------------------------------------------
Decision Editor::CollapseAndMove(
  const Edit& requested, const NearbyEdits& requestedNearby, Workspace& work)
{
  Edit edit = requested;
  edit.Position = this->Rounded(edit.Position);
  NearbyEdits nearby = requestedNearby;
  for (VertexMove& move : nearby.Moves)
  {
    move.Position = this->Rounded(move.Position);
  }
  const auto movesFreely = [this](VertexId v) { return this->Half.MovesFreely(v); };
  if (!movesFreely(this->Half.Origin(edit.Edge)) || !movesFreely(this->Half.Target(edit.Edge)) ||
    !std::all_of(nearby.Moves.begin(), nearby.Moves.end(),
      [&](const VertexMove& move) { return movesFreely(move.Vertex); }))
  {
    return Rejection::Boundary;
  }
  Decision decision = this->CheckEdge(edit.Edge, work);
  if (!decision.IsAccepted())
  {
    return decision;
  }
  ProposedEdit& proposed = this->Propose(edit, edit.Keep, 0.0, work, 1);
  proposed.OtherGoneFace = work.Around.GoneFaces[1];
  decision = this->FillTogether(edit, nearby, work);
  if (decision.IsAccepted())
  {
    decision = CheckNewFaces(this->Half, proposed.Change, proposed.VolumeChange);
  }
  if (decision.IsAccepted())
  {
    decision = this->RunFilters(work);
  }
  if (decision.IsAccepted())
  {
    this->CommitTogether(edit, nearby, work);
  }
  return decision;
}

//------------------------------------------------------------------------------
void Editor::CommitTogether(const Edit& edit, const NearbyEdits& nearby, Workspace& work)
{
  const VertexId gone = this->Half.Across(edit.Edge, edit.Keep);
  const std::vector<SurfaceChange::Face>& made = work.Proposed.Change.NewFaces;
  for (const SurfaceChange::Face& face : made)
  {
    this->KeepFirstNormal(face.Id);
  }
  this->ApplyTogether(edit, nearby, work);
  this->Commit(work);
  this->UpdateBookkeeping(edit, gone, work);
  this->Settle(work.Counted);
  if (this->Recorder)
  {
    this->Recorder->AddNearby(
      nearby.Moves, nearby.Flips.empty() ? std::vector<SurfaceChange::Face>() : made);
  }
}
}
