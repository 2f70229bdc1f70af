// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// What an Editor does to collapse an edge and move vertices near it as one edit.
#include "Editor.h"
#include "FlipAndMoveRules.h"

#include <algorithm>

namespace bonedecimate
{
Decision Editor::CollapseAndMove(
  const Edit& requested, const std::vector<VertexMove>& requestedMoves, Workspace& work)
{
  Edit edit = requested;
  edit.Position = this->Rounded(edit.Position);
  std::vector<VertexMove> moves = requestedMoves;
  for (VertexMove& move : moves)
  {
    move.Position = this->Rounded(move.Position);
  }
  const auto movesFreely = [this](VertexId v) { return this->Half.MovesFreely(v); };
  if (!movesFreely(this->Half.Origin(edit.Edge)) || !movesFreely(this->Half.Target(edit.Edge)) ||
    !std::all_of(
      moves.begin(), moves.end(), [&](const VertexMove& move) { return movesFreely(move.Vertex); }))
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
  proposed.Change.FillCollapseAndMoves(this->Half, work.Around, edit, moves);
  const Rejection rejection = CheckNewFaces(this->Half, proposed.Change, proposed.VolumeChange);
  decision = rejection != Rejection::NotRejected ? rejection : this->RunFilters(work);
  if (!decision.IsAccepted())
  {
    return decision;
  }
  const VertexId gone = this->Half.Across(edit.Edge, edit.Keep);
  for (const SurfaceChange::Face& face : proposed.Change.NewFaces)
  {
    this->KeepFirstNormal(face.Id);
  }
  this->Half.Collapse(work.Around, edit.Keep, edit.Position);
  for (const VertexMove& move : moves)
  {
    this->Half.Move(move.Vertex, move.Position);
  }
  this->Commit(work);
  this->UpdateBookkeeping(edit, gone, work);
  this->Settle(work.Counted);
  if (this->Recorder)
  {
    this->Recorder->AddMoves(moves);
  }
  return decision;
}
}
