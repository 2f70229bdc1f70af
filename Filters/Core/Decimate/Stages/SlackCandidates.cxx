// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SlackCandidates.h"

#include "Base/Parallel.h"

#include <algorithm>
#include <array>

namespace bonedecimate
{
namespace
{
constexpr Index VerticesOfPart = 64;
/// Beyond this ratio of the samples at the start, moving the vertex does not help; nor beyond the
/// largest ratio of a candidate plus this excess.
constexpr double MaxRatioOfStart = 1.6;
constexpr double MaxExcessOfStart = 0.2;
constexpr int MovesOfCandidate = 4;
/// Points on the faces are evaluated only up to this ratio of the samples, relative to the largest
/// ratio of a candidate.
constexpr double MaxRelativeRatioOfSamples = 1.02;
}

SlackCandidates::SlackCandidates(const Editor& editor, const Samples& samples,
  const OriginalHints& hints, double maxRatio, int threads)
  : MeshEditor(editor)
  , OriginalSamples(samples)
  , Hints(hints)
  , MaxRatio(maxRatio)
  , Threads(threads)
  , Changed(static_cast<std::size_t>(editor.Mesh().NumberOfVertexSlots()), 1)
{
}

//------------------------------------------------------------------------------
bool SlackCandidates::Find(const Monitor& monitor, std::vector<SlackCandidate>& candidates)
{
  const Index vertices = this->MeshEditor.Mesh().NumberOfVertexSlots();
  std::vector<Index> alive;
  for (VertexId v = 0; v < vertices; ++v)
  {
    if (this->MeshEditor.Mesh().Outgoing(v) != None && this->MeshEditor.Mesh().MovesFreely(v))
    {
      alive.push_back(v);
    }
  }
  const Index count = static_cast<Index>(alive.size());
  std::vector<std::vector<SlackCandidate>> found(
    static_cast<std::size_t>((count + VerticesOfPart - 1) / VerticesOfPart));
  const bool done = ForEachPart(found.size(), this->Threads, monitor,
    [&](std::size_t i)
    {
      Evaluator evaluator = { SlackFit(this->MeshEditor, this->OriginalSamples, this->Hints), {},
        {} };
      const Index first = static_cast<Index>(i) * VerticesOfPart;
      const Index last = std::min(count, first + VerticesOfPart);
      for (Index k = first; k < last; ++k)
      {
        this->EvaluateAt(alive[k], evaluator, found[i]);
      }
    });
  for (const std::vector<SlackCandidate>& part : found)
  {
    candidates.insert(candidates.end(), part.begin(), part.end());
  }
  std::fill(this->Changed.begin(), this->Changed.end(), 0);
  return done;
}

//------------------------------------------------------------------------------
void SlackCandidates::EvaluateAt(
  VertexId vertex, Evaluator& evaluator, std::vector<SlackCandidate>& found) const
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  evaluator.Edges.clear();
  RateEdges(mesh, vertex, true, evaluator.Edges);
  for (const RatedEdge& edge : evaluator.Edges)
  {
    SlackCandidate candidate;
    if ((this->Changed[mesh.Origin(edge.Edge)] || this->Changed[mesh.Target(edge.Edge)]) &&
      this->EvaluateEdge(edge, evaluator, candidate) && candidate.Ratio <= this->MaxRatio)
    {
      found.push_back(candidate);
    }
  }
}

//------------------------------------------------------------------------------
/// False if the edge cannot be collapsed, or its samples are too far.
bool SlackCandidates::EvaluateEdge(
  const RatedEdge& edge, Evaluator& evaluator, SlackCandidate& candidate) const
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  if (!this->MeshEditor.Gather(edge.Edge, evaluator.Workspace).IsAccepted())
  {
    return false;
  }
  const EdgeNeighborhood& around = evaluator.Workspace.Neighborhood;
  SlackFit& slack = evaluator.Slack;
  Gather(mesh, around, slack);
  const Vector3& start = mesh.Position(around.Start);
  const Vector3& end = mesh.Position(around.End);
  const std::array<Vector3, 4> positions = { edge.Position, 0.5 * (start + end), start, end };
  const double maxRatioOfStart = std::max(MaxRatioOfStart, this->MaxRatio + MaxExcessOfStart);
  double least = maxRatioOfStart;
  for (const Vector3& position : positions)
  {
    const double ratio = slack.MaxRatioOfSamples(position, least);
    if (ratio < least)
    {
      least = ratio;
      candidate.Position = position;
    }
  }
  if (!(least < maxRatioOfStart))
  {
    return false;
  }
  const Index hint = this->Hints.Of(around.Start);
  slack.SetTerms(SlackFit::ErrorTerms::Samples);
  const bool isNear = slack.Improve(candidate.Position, hint, MovesOfCandidate).MaxRatio <
    MaxRelativeRatioOfSamples * this->MaxRatio;
  slack.SetTerms(SlackFit::ErrorTerms::All);
  if (!isNear)
  {
    return false;
  }
  const SlackFit::Value value = slack.Improve(candidate.Position, hint, MovesOfCandidate);
  candidate.Ratio = value.MaxRatio;
  candidate.Edge = edge.Edge;
  candidate.Start = around.Start;
  candidate.End = around.End;
  candidate.Hint = value.Hint;
  return true;
}

//------------------------------------------------------------------------------
void SlackCandidates::Gather(
  const HalfEdgeMesh& mesh, const EdgeNeighborhood& around, SlackFit& slack)
{
  slack.Clear();
  for (std::size_t i = 0; i < around.Corners.size(); ++i)
  {
    slack.AddFace(mesh.Position(around.Ring[i]), mesh.Position(around.RingAfter(i)));
    slack.AddSamples(HalfEdgeMesh::Face(around.Corners[i]), i);
  }
  for (std::size_t k = 0; k < 2; ++k)
  {
    slack.AddSamples(around.RemovedFaces[k], around.SlotAtApex(k));
  }
}
}
