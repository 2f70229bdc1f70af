// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SlackCollapse.h"

#include <algorithm>
#include <limits>

namespace bonedecimate
{
SlackCollapse::SlackCollapse(Editor& editor, Samples& samples, OriginalHints& hints, int threads)
  : MeshEditor(editor)
  , Fit(samples)
  , Back(hints)
  , Candidates(editor, samples, hints, 1.0, threads)
  , Slack(editor, samples, hints)
  , Touched(static_cast<std::size_t>(editor.Mesh().NumberOfVertexSlots()), 0)
{
}

//------------------------------------------------------------------------------
bool SlackCollapse::Run(Index faces, const Monitor& monitor)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  constexpr int mostRounds = 4;
  // no further round after one that removes less than one face in this many
  constexpr Index leastOfRound = 256;
  Index before = mesh.NumberOfFaces() + 1;
  for (int round = 0; round < mostRounds && mesh.NumberOfFaces() > faces &&
       before - mesh.NumberOfFaces() > (round == 0 ? 0 : before / leastOfRound);
       ++round)
  {
    before = mesh.NumberOfFaces();
    std::vector<SlackCandidate> candidates;
    if (!this->Candidates.Find(
          PartOf(monitor, static_cast<double>(round) / mostRounds, (round + 1.0) / mostRounds),
          candidates))
    {
      return false;
    }
    std::sort(candidates.begin(), candidates.end());
    std::fill(this->Touched.begin(), this->Touched.end(), 0);
    for (const SlackCandidate& candidate : candidates)
    {
      if (mesh.NumberOfFaces() > faces && this->Collapse(candidate))
      {
        this->MeshEditor.Settle(&this->Space.Counted);
      }
    }
  }
  return monitor(1.0);
}

//------------------------------------------------------------------------------
bool SlackCollapse::IsTouched(const EdgeNeighborhood& around) const
{
  return this->Touched[around.Start] || this->Touched[around.End] ||
    std::any_of(
      around.Ring.begin(), around.Ring.end(), [this](VertexId v) { return this->Touched[v] != 0; });
}

//------------------------------------------------------------------------------
bool SlackCollapse::Collapse(const SlackCandidate& candidate)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  Workspace& work = this->Space;
  if (mesh.Origin(candidate.Edge) != candidate.Start ||
    mesh.Target(candidate.Edge) != candidate.End || this->Touched[candidate.Start] ||
    this->Touched[candidate.End] || !this->MeshEditor.Gather(candidate.Edge, work).IsAccepted())
  {
    return false;
  }
  const EdgeNeighborhood around = work.Around;
  if (this->IsTouched(around))
  {
    return false;
  }
  Edit edit;
  edit.Edge = candidate.Edge;
  edit.Keep = candidate.Start;
  edit.Position = candidate.Position;
  work.Change.Rank = static_cast<float>(candidate.Ratio);
  SlackCandidates::Gather(mesh, around, this->Slack); // while the faces are there
  if (!this->MeshEditor.Try(edit, work).IsAccepted())
  {
    return false;
  }
  this->Back.Set(edit.Keep, candidate.Hint);
  // Finds the face of each sample.
  this->Slack.MaxOfSamples(mesh.Position(around.Start), std::numeric_limits<double>::infinity());
  this->Fit.HandOver(around.Faces(), this->Slack.Members());
  this->Touched[edit.Keep] = 1;
  this->Candidates.NoteChange(edit.Keep);
  for (const VertexId v : around.Ring)
  {
    this->Candidates.NoteChange(v);
  }
  return true;
}
}
