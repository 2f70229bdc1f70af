// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SlackMover.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// Maximum ratio after a shift.
constexpr double MaxOfShift = 0.97;
}

SlackMover::Proposal SlackMover::Evaluate(VertexId vertex)
{
  const SlackFit::Value before = this->Gather(vertex);
  // below it, the vertex does not limit anything
  constexpr double minRatio = 0.5;
  if (!(before.MaxRatio > minRatio))
  {
    return {};
  }
  Vector3 position = this->MeshEditor.Mesh().Position(vertex);
  const SlackFit::Value after = this->Slack.TryStep(position, before);
  return after.Error < before.Error
    ? Proposal{ vertex, position, after.Hint, this->Ring, this->Slack.Members() }
    : Proposal();
}

//------------------------------------------------------------------------------
SlackMover::Proposal SlackMover::Shift(VertexId vertex, const Vector3& step)
{
  const SlackFit::Value before = this->Gather(vertex);
  const Vector3 position = this->Slack.OnGrid(this->MeshEditor.Mesh().Position(vertex) + step);
  const SlackFit::Value after = this->Slack.Evaluate(position, before.Hint);
  return after.MaxRatio <= std::max(MaxOfShift, before.MaxRatio)
    ? Proposal{ vertex, position, after.Hint, this->Ring, this->Slack.Members() }
    : Proposal();
}

//------------------------------------------------------------------------------
bool SlackMover::Apply(const Proposal& proposal, EditWorkspace& workspace) const
{
  if (!this->MeshEditor.Try(MoveTo(proposal.Vertex, proposal.Position), workspace).IsAccepted())
  {
    return false;
  }
  this->Hints.Set(proposal.Vertex, proposal.Hint);
  this->OriginalSamples.HandOver(proposal.Ring, proposal.Samples);
  return true;
}

//------------------------------------------------------------------------------
SlackFit::Value SlackMover::Gather(VertexId vertex)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  this->Slack.Clear();
  this->Ring.clear();
  for (const HalfEdgeId h : mesh.OutgoingOf(vertex))
  {
    const FaceId face = HalfEdgeMesh::Face(h);
    this->Slack.AddSamples(face, this->Ring.size());
    this->Slack.AddFace(mesh.Position(mesh.Target(h)), mesh.Position(mesh.Apex(h)));
    this->Ring.push_back(face);
  }
  return this->Slack.Evaluate(mesh.Position(vertex), this->Hints.Of(vertex));
}
}
