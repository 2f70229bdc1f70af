// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ForcedCollapse.h"

#include "Base/Parallel.h"

#include <algorithm>
#include <utility>

namespace bonedecimate
{
namespace
{
}

ForcedCollapse::ForcedCollapse(
  Editor& editor, Samples& samples, BackHints& hints, double farthest, int threads)
  : MeshEditor(editor)
  , Fit(samples)
  , Back(hints)
  , Candidates(editor, samples, hints, farthest, threads)
  , Threads(threads)
  , Taken(static_cast<std::size_t>(editor.Mesh().NumberOfVertexSlots()), 0)
{
}

//------------------------------------------------------------------------------
bool ForcedCollapse::Run(Index faces, const Monitor& monitor)
{
  constexpr int mostRounds = 40;
  constexpr double evaluatedAt = 0.4; // of a round
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  for (int round = 0; round < mostRounds && mesh.NumberOfFaces() > faces; ++round)
  {
    const Monitor tell =
      PartOf(monitor, static_cast<double>(round) / mostRounds, (round + 1.0) / mostRounds);
    this->DropChanged();
    if (!this->Candidates.Find(PartOf(tell, 0.0, evaluatedAt), this->Waiting))
    {
      return false;
    }
    std::vector<Trial> trials = this->Choose();
    this->Figures.Tried += static_cast<std::int64_t>(trials.size());
    if (trials.empty())
    {
      break;
    }
    if (!this->TryAll(trials, PartOf(tell, evaluatedAt, 1.0)))
    {
      return false;
    }
    for (const Trial& trial : trials)
    {
      const bool isMade =
        trial.Found.IsWithin && mesh.NumberOfFaces() > faces && this->Apply(trial);
      this->Figures.Made += isMade ? 1 : 0;
    }
    this->MeshEditor.RenewQuadrics(this->Threads);
  }
  return monitor(1.0);
}

//------------------------------------------------------------------------------
/// Candidates near changes are found again.
void ForcedCollapse::DropChanged()
{
  const auto isChanged = [this](const SlackCandidate& candidate)
  {
    return this->Candidates.IsChanged(candidate.Start) || this->Candidates.IsChanged(candidate.End);
  };
  this->Waiting.erase(
    std::remove_if(this->Waiting.begin(), this->Waiting.end(), isChanged), this->Waiting.end());
}

//------------------------------------------------------------------------------
/// They no longer wait.
std::vector<ForcedCollapse::Trial> ForcedCollapse::Choose()
{
  std::sort(this->Waiting.begin(), this->Waiting.end());
  std::fill(this->Taken.begin(), this->Taken.end(), 0);
  std::vector<Trial> trials;
  std::vector<SlackCandidate> left;
  for (const SlackCandidate& candidate : this->Waiting)
  {
    Trial trial = { candidate };
    if (!this->Gather(candidate, trial.Vertices))
    {
      continue;
    }
    const bool isFree = std::none_of(trial.Vertices.begin(), trial.Vertices.end(),
      [this](Index v) { return this->Taken[v] != 0; });
    if (!isFree)
    {
      left.push_back(candidate);
      continue;
    }
    for (const Index v : trial.Vertices)
    {
      this->Taken[v] = 1;
    }
    trials.push_back(std::move(trial));
  }
  this->Waiting = std::move(left);
  return trials;
}

//------------------------------------------------------------------------------
/// The vertices of all faces that may change. False if the edge may not be collapsed.
bool ForcedCollapse::Gather(const SlackCandidate& candidate, std::vector<Index>& vertices)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  if (!this->MeshEditor.Validate(candidate.Edge, this->Space).IsAccepted())
  {
    return false;
  }
  vertices = { candidate.Start, candidate.End };
  for (const VertexId v : this->Space.Around.Ring)
  {
    vertices.push_back(v);
    if (MayMove(mesh, v))
    {
      mesh.VisitNeighbors(v, [&](HalfEdgeId, Index other) { vertices.push_back(other); });
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool ForcedCollapse::TryAll(std::vector<Trial>& trials, const Monitor& monitor)
{
  return ForEachPart(trials.size(), this->Threads, monitor,
    [&](std::size_t i)
    {
      Workspace work;
      PatchFit patch(this->MeshEditor, this->Fit, this->Back);
      if (this->MeshEditor.Validate(trials[i].Candidate.Edge, work).IsAccepted())
      {
        trials[i].Found = patch.Fit(work.Around, trials[i].Candidate);
      }
    });
}

//------------------------------------------------------------------------------
bool ForcedCollapse::Apply(const Trial& trial)
{
  const PatchFit::Result& found = trial.Found;
  Edit edit;
  edit.Edge = trial.Candidate.Edge;
  edit.Keep = trial.Candidate.Start;
  edit.Position = found.Position;
  if (!this->MeshEditor.CollapseAndMove(edit, found.Moves, this->Space).IsAccepted())
  {
    return false;
  }
  for (const Index face : found.Faces)
  {
    this->Fit.Take(face);
  }
  for (const PatchFit::Result::Held& held : found.Samples)
  {
    this->Fit.Put(held.Sample, held.Face);
  }
  for (const PatchFit::Result::Near& near : found.Hints)
  {
    this->Back.Set(near.Vertex, near.Triangle);
  }
  for (const Index v : trial.Vertices)
  {
    this->Candidates.NoteChange(v);
  }
  return true;
}
}
