// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SlackCollapse.h"

#include <algorithm>

namespace bonedecimate
{
SlackCollapse::SlackCollapse(Editor& editor, Samples& samples, OriginalHints& hints, int threads)
  : MeshEditor(editor)
  , OriginalSamples(samples)
  , Hints(hints)
  , Candidates(editor, samples, hints, 1.0, threads)
  , Slack(editor, samples, hints)
  , TouchedVertices(static_cast<std::size_t>(editor.Mesh().NumberOfVertexSlots()), 0)
{
}

//------------------------------------------------------------------------------
bool SlackCollapse::Run(Index faces, const Monitor& monitor)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  constexpr int maxRounds = 4;
  // no further round after one that removes less than one face in this many
  constexpr Index facesPerRemoved = 256;
  Index before = mesh.NumberOfFaces() + 1;
  for (int round = 0; round < maxRounds && mesh.NumberOfFaces() > faces &&
       before - mesh.NumberOfFaces() > (round == 0 ? 0 : before / facesPerRemoved);
       ++round)
  {
    before = mesh.NumberOfFaces();
    std::vector<SlackCandidate> candidates;
    if (!this->Candidates.Find(StepOf(monitor, round, maxRounds), candidates))
    {
      return false;
    }
    std::sort(candidates.begin(), candidates.end());
    std::fill(this->TouchedVertices.begin(), this->TouchedVertices.end(), 0);
    for (const SlackCandidate& candidate : candidates)
    {
      if (mesh.NumberOfFaces() > faces && this->Collapse(candidate))
      {
        this->MeshEditor.Settle(&this->Workspace.Counts);
      }
    }
  }
  return monitor(1.0);
}

//------------------------------------------------------------------------------
bool SlackCollapse::IsTouched(const EdgeNeighborhood& around) const
{
  return this->TouchedVertices[around.Start] || this->TouchedVertices[around.End] ||
    std::any_of(around.Ring.begin(), around.Ring.end(),
      [this](VertexId v) { return this->TouchedVertices[v] != 0; });
}

//------------------------------------------------------------------------------
bool SlackCollapse::Collapse(const SlackCandidate& candidate)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  EditWorkspace& workspace = this->Workspace;
  if (mesh.Origin(candidate.Edge) != candidate.Start ||
    mesh.Target(candidate.Edge) != candidate.End || this->TouchedVertices[candidate.Start] ||
    this->TouchedVertices[candidate.End] ||
    !this->MeshEditor.Gather(candidate.Edge, workspace).IsAccepted())
  {
    return false;
  }
  const EdgeNeighborhood around = workspace.Neighborhood;
  if (this->IsTouched(around))
  {
    return false;
  }
  Edit edit;
  edit.Edge = candidate.Edge;
  edit.Keep = candidate.Start;
  edit.Position = candidate.Position;
  workspace.Change.Rank = static_cast<float>(candidate.Ratio);
  SlackCandidates::Gather(mesh, around, this->Slack); // before the faces are removed
  if (!this->MeshEditor.Try(edit, workspace).IsAccepted())
  {
    return false;
  }
  this->Hints.Set(edit.Keep, candidate.Hint);
  // Finds the face of each sample.
  this->Slack.MaxRatioOfSamples(mesh.Position(around.Start), Infinity);
  this->OriginalSamples.HandOver(around.Faces(), this->Slack.Members());
  this->TouchedVertices[edit.Keep] = 1;
  this->Candidates.NoteChange(edit.Keep);
  for (const VertexId v : around.Ring)
  {
    this->Candidates.NoteChange(v);
  }
  return true;
}
}
