// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// What an Editor does to move a vertex.
#include "Editor.h"
#include "FlipAndMoveRules.h"

namespace bonedecimate
{
Decision Editor::Move(VertexId vertex, const Vector3& position, Workspace& work, int workers)
{
  Edit edit;
  edit.Kind = EditKind::Move;
  edit.Keep = vertex;
  edit.Position = this->Rounded(position);
  double volumeChange = 0.0; // mm^3
  const Rejection rejection = CheckMove(this->Half, vertex, edit.Position, volumeChange);
  if (rejection != Rejection::NotRejected)
  {
    return rejection;
  }
  ProposedEdit& proposed = this->Propose(edit, vertex, volumeChange, work, workers);
  if (this->NeedsSurfaceChange)
  {
    proposed.Change.FillMove(this->Half, edit);
  }
  const Decision decision = this->RunFilters(work);
  if (!decision.IsAccepted())
  {
    return decision;
  }
  for (const HalfEdgeId h : this->Half.OutgoingOf(vertex))
  {
    this->KeepFirstNormal(HalfEdgeMesh::Face(h));
  }
  this->Half.Move(vertex, edit.Position);
  this->Commit(work);
  if (this->AfterEdit)
  {
    this->AfterEdit(*this, edit);
  }
  return decision;
}
}
