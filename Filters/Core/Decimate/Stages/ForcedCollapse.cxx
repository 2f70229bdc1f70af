// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ForcedCollapse.h"

#include "Base/Parallel.h"

#include <algorithm>
#include <utility>

namespace bonedecimate
{
ForcedCollapse::ForcedCollapse(
  Editor& editor, Samples& samples, OriginalHints& hints, ForcedReach reach, int threads)
  : MeshEditor(editor)
  , OriginalSamples(samples)
  , Hints(hints)
  , Candidates(editor, samples, hints, reach.MaxRatio, threads)
  , Reach(reach)
  , Threads(threads)
  , IsTaken(static_cast<std::size_t>(editor.Mesh().NumberOfVertexSlots()), 0)
{
}

//------------------------------------------------------------------------------
bool ForcedCollapse::Run(Index faces, const Monitor& monitor)
{
  constexpr int maxRounds = 40;
  constexpr double evaluatedAt = 0.4; // of a round
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  for (int round = 0; round < maxRounds && mesh.NumberOfFaces() > faces; ++round)
  {
    const Monitor tell = StepOf(monitor, round, maxRounds);
    this->DropChanged();
    if (!this->Candidates.Find(PartOf(tell, 0.0, evaluatedAt), this->WaitingCandidates))
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
      const bool isMade = trial.Fit.IsWithin && mesh.NumberOfFaces() > faces && this->Apply(trial);
      this->Figures.Made += isMade ? 1 : 0;
    }
    this->MeshEditor.PrepareCollapses(this->Threads);
  }
  return monitor(1.0);
}

//------------------------------------------------------------------------------
/// Drops candidates near changes; Find() adds them again.
void ForcedCollapse::DropChanged()
{
  const auto isChanged = [this](const SlackCandidate& candidate)
  {
    return this->Candidates.IsChanged(candidate.Start) || this->Candidates.IsChanged(candidate.End);
  };
  this->WaitingCandidates.erase(
    std::remove_if(this->WaitingCandidates.begin(), this->WaitingCandidates.end(), isChanged),
    this->WaitingCandidates.end());
}

//------------------------------------------------------------------------------
/// Takes candidates without a common neighborhood from the waiting ones.
std::vector<ForcedCollapse::Trial> ForcedCollapse::Choose()
{
  std::sort(this->WaitingCandidates.begin(), this->WaitingCandidates.end());
  std::fill(this->IsTaken.begin(), this->IsTaken.end(), 0);
  std::vector<Trial> trials;
  std::vector<SlackCandidate> left;
  for (const SlackCandidate& candidate : this->WaitingCandidates)
  {
    Trial trial = { candidate };
    if (!this->Gather(candidate, trial.Vertices))
    {
      continue;
    }
    const bool isFree = std::none_of(trial.Vertices.begin(), trial.Vertices.end(),
      [this](Index v) { return this->IsTaken[v] != 0; });
    if (!isFree)
    {
      left.push_back(candidate);
      continue;
    }
    for (const Index v : trial.Vertices)
    {
      this->IsTaken[v] = 1;
    }
    trials.push_back(std::move(trial));
  }
  this->WaitingCandidates = std::move(left);
  return trials;
}

//------------------------------------------------------------------------------
/// Gathers the vertices of all faces that may change, sorted. False if the edge cannot be
/// collapsed.
bool ForcedCollapse::Gather(const SlackCandidate& candidate, std::vector<Index>& vertices)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  if (!this->MeshEditor.Gather(candidate.Edge, this->Workspace).IsAccepted())
  {
    return false;
  }
  const std::vector<Index>& ring = this->Workspace.Neighborhood.Ring;
  vertices.assign(ring.begin(), ring.end());
  vertices.push_back(candidate.Start);
  vertices.push_back(candidate.End);
  for (int i = 0; i < this->Reach.Rings; ++i)
  {
    const std::size_t count = vertices.size();
    for (std::size_t k = 0; k < count; ++k)
    {
      if (MayMove(mesh, vertices[k]))
      {
        mesh.VisitNeighbors(
          vertices[k], [&](HalfEdgeId, Index other) { vertices.push_back(other); });
      }
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  }
  return true;
}

//------------------------------------------------------------------------------
bool ForcedCollapse::TryAll(std::vector<Trial>& trials, const Monitor& monitor)
{
  return ForEachPart(trials.size(), this->Threads, monitor,
    [&](std::size_t i)
    {
      EditWorkspace workspace;
      PatchFit patch(this->MeshEditor, this->OriginalSamples, this->Hints, this->Reach.Rings);
      if (this->MeshEditor.Gather(trials[i].Candidate.Edge, workspace).IsAccepted())
      {
        trials[i].Fit = patch.Fit(workspace.Neighborhood, trials[i].Candidate);
      }
    });
}

//------------------------------------------------------------------------------
bool ForcedCollapse::Apply(const Trial& trial)
{
  const PatchFit::Result& found = trial.Fit;
  Edit edit;
  edit.Edge = trial.Candidate.Edge;
  edit.Keep = trial.Candidate.Start;
  edit.Position = found.Position;
  if (!this->MeshEditor.Try(edit, found.Nearby, this->Workspace).IsAccepted())
  {
    return false;
  }
  for (const Index face : found.Faces)
  {
    this->OriginalSamples.Take(face);
  }
  for (const PatchFit::Result::SampleOfFace& sample : found.Samples)
  {
    this->OriginalSamples.Put(sample.Sample, sample.Face);
  }
  for (const PatchFit::Result::Hint& hint : found.Hints)
  {
    this->Hints.Set(hint.Vertex, hint.Triangle);
  }
  for (const Index v : trial.Vertices)
  {
    this->Candidates.NoteChange(v);
  }
  return true;
}
}
