// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// What an Editor does to flip an edge.
#include "Editor.h"
#include "FlipAndMoveRules.h"
#include "PatchRules.h"

namespace bonedecimate
{
Decision Editor::Flip(HalfEdgeId edge, Workspace& work, int workers)
{
  double volumeChange = 0.0; // mm^3
  Decision decision = CheckFlip(this->Half, edge, volumeChange);
  if (decision.IsAccepted() && this->Half.HasPatches())
  {
    const std::array<Index, 4> corners = CornersAround(this->Half, edge);
    decision = CheckNewEdge(this->Half, corners[2], corners[3], work.Range);
  }
  if (!decision.IsAccepted())
  {
    return decision;
  }
  Edit edit;
  edit.Kind = EditKind::Flip;
  edit.Edge = edge;
  ProposedEdit& proposed =
    this->Propose(edit, this->Half.Origin(edge), volumeChange, work, workers);
  if (this->NeedsSurfaceChange)
  {
    proposed.Change.FillFlip(this->Half, edit);
  }
  decision = this->RunFilters(work);
  if (!decision.IsAccepted())
  {
    return decision;
  }
  this->KeepFirstNormal(HalfEdgeMesh::Face(edge));
  this->KeepFirstNormal(HalfEdgeMesh::Face(this->Half.Twin(edge)));
  this->Half.Flip(edge);
  this->Commit(work);
  if (this->AfterEdit)
  {
    this->AfterEdit(*this, edit);
  }
  return decision;
}
}
