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
    Workspace& work = this->ManifoldPatches[i];
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
    Workspace& work = this->ManifoldPatches[i];
    FillFan(
      this->Half, work.Around, work.Faces.Reserve(static_cast<int>(work.Around.Corners.size())));
    rejection =
      CheckPosition(this->Half, work.Around, work.Faces.Current(), this->Propose(edits[i], work));
  }
  return rejection;
}

//------------------------------------------------------------------------------
/// As one edit, with the first workspace.
Decision Editor::FilterTogether(const std::vector<Edit>& edits)
{
  Workspace& first = this->ManifoldPatches[0];
  first.Change.OtherGoneFace = first.Around.GoneFaces[1];
  if (this->NeedsSurfaceChange)
  {
    first.Change.Fill(this->Half, first.Around);
  }
  for (std::size_t i = 1; i < edits.size(); ++i)
  {
    const Workspace& other = this->ManifoldPatches[i];
    first.Change.VolumeChange += other.Change.VolumeChange;
    if (this->NeedsSurfaceChange)
    {
      first.Change.AddCollapse(this->Half, other.Around, edits[i]);
    }
  }
  return this->RunFilters(first);
}

//------------------------------------------------------------------------------
Decision Editor::Try(const std::vector<Edit>& edits)
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
    this->Total.Rejections[static_cast<std::size_t>(decision.Reason())] += decision.IsRejected();
    return decision;
  }
  std::vector<Index> gone;
  std::vector<Vector3> origins; // mm, of the fans
  for (std::size_t i = 0; i < edits.size(); ++i)
  {
    gone.push_back(this->Half.Across(edits[i].Edge, edits[i].Keep));
    origins.push_back(this->Half.Position(this->ManifoldPatches[i].Around.Start));
    this->CollapseEdge(edits[i], this->ManifoldPatches[i]);
  }
  this->Commit(this->ManifoldPatches[0]);
  for (std::size_t i = 0; i < edits.size(); ++i)
  {
    Workspace& work = this->ManifoldPatches[i];
    if (this->KeepsQuadrics)
    {
      ExchangeRingQuadrics(
        this->Half, work.Around, edits[i].Keep, origins[i], work.Faces.Current());
    }
    this->NoteCollapse(edits[i], gone[i], work);
    this->Settle(&work.Counted);
  }
  this->Total.Collapses -= static_cast<std::int64_t>(edits.size()) - 1; // one point was removed
  return Decision::Accept();
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
  SurfaceChange& change = work.Change;
  change.Fill(this->Half, work.Around);
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
Decision Editor::Try(const Edit& collapse, const NearbyEdits& requested, Workspace& work)
{
  SurfaceChange& change = this->Propose(collapse, work);
  const Edit edit = change.Requested;
  NearbyEdits nearby = requested;
  for (VertexMove& move : nearby.Moves)
  {
    move.Position = this->BoundFilter ? this->BoundFilter->Rounded(move.Position) : move.Position;
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
  change.OtherGoneFace = work.Around.GoneFaces[1];
  decision = this->FillTogether(edit, nearby, work);
  if (decision.IsAccepted())
  {
    decision = CheckNewFaces(this->Half, change);
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
  const std::vector<SurfaceChange::Face>& made = work.Change.NewFaces;
  std::vector<Index> faces(made.size());
  std::transform(made.begin(), made.end(), faces.begin(),
    [](const SurfaceChange::Face& face) { return face.Id; });
  this->KeepFirstNormals(faces);
  this->ApplyTogether(edit, nearby, work);
  this->Commit(work);
  this->NoteCollapse(edit, gone, work);
  this->Settle(&work.Counted);
  if (this->Recorder)
  {
    this->Recorder->AddNearby(
      nearby.Moves, nearby.Flips.empty() ? std::vector<SurfaceChange::Face>() : made);
  }
}
}
