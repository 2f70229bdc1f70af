// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FastLoop.h"

#include "Gate.h"
#include "Geometry/TriangleGeometry.h"
#include "Mesh/MeanEdgeLength.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bonedecimate
{
namespace
{
constexpr Index RenewBelowShare = 50;
/// A refused edge is asked for again when everything else costs 16 times as much.
constexpr LevelQueue::Level LevelsAfterRefusal = 4 * LevelQueue::LevelsOfOctave;

/// An open border moves only along itself.
VertexQuadrics::Freedom FreedomOf(VertexKind first, VertexKind second)
{
  using Freedom = VertexQuadrics::Freedom;
  if (first == VertexKind::Border)
  {
    return second == VertexKind::Border ? Freedom::Edge : Freedom::First;
  }
  return second == VertexKind::Border ? Freedom::Second : Freedom::Space;
}
}

FastLoop::FastLoop(Editor& editor, const Stops& stops)
  : Work(editor)
  , End(editor, stops)
  , Quadrics(editor.Mesh(), editor.Areas(), MeanEdgeLength(editor.Mesh()))
  , Queue(editor.Mesh().NumberOfVertexSlots())
  , RenewBelow(editor.Mesh().NumberOfFaces() / RenewBelowShare)
{
}

//------------------------------------------------------------------------------
StopReason FastLoop::Run(const Monitor& monitor)
{
  std::int64_t editsWhenFilled = -1;
  while (!this->End.IsReached())
  {
    const LevelQueue::Entry entry = this->Queue.Pop();
    if (entry.Vertex != None)
    {
      this->CollapseAt(entry);
    }
    else if (this->Work.NumberOfEdits() == editsWhenFilled)
    {
      return StopReason::NothingLeft;
    }
    else
    {
      editsWhenFilled = this->Work.NumberOfEdits();
      this->Fill();
    }
    if (!this->End.Tell(monitor))
    {
      return StopReason::Aborted;
    }
  }
  return this->End.Reason();
}

//------------------------------------------------------------------------------
void FastLoop::Fill()
{
  for (Index v = 0; v < this->Work.Mesh().NumberOfVertexSlots(); ++v)
  {
    if (this->Work.Mesh().Outgoing(v) != None)
    {
      this->PutOnLevel(v);
    }
  }
}

//------------------------------------------------------------------------------
/// Fills Candidates with the edges at the vertex that may be collapsed at all, cheapest first.
void FastLoop::FindCandidates(Index vertex)
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  this->Candidates.clear();
  mesh.VisitEdges(vertex,
    [&](Index h)
    {
      if (JudgeEnds(mesh, h) == Verdict::Allowed)
      {
        const Index other = mesh.Across(h, vertex);
        const VertexQuadrics::Freedom freedom = FreedomOf(mesh.Kind(vertex), mesh.Kind(other));
        this->Candidates.push_back({ this->Quadrics.Evaluate(vertex, other, freedom), h });
      }
    });
  std::sort(this->Candidates.begin(), this->Candidates.end(),
    [](const Candidate& a, const Candidate& b)
    { return a.Answer.Cost != b.Answer.Cost ? a.Answer.Cost < b.Answer.Cost : a.Edge < b.Edge; });
}

//------------------------------------------------------------------------------
void FastLoop::PutOnLevel(Index vertex)
{
  if (this->Work.Mesh().Kind(vertex) == VertexKind::Locked)
  {
    return;
  }
  this->FindCandidates(vertex);
  if (this->Candidates.empty())
  {
    this->Queue.Remove(vertex);
  }
  else
  {
    this->Queue.Set(vertex, LevelQueue::LevelOf(this->Candidates.front().Answer.Cost));
  }
}

//------------------------------------------------------------------------------
void FastLoop::CollapseAt(const LevelQueue::Entry& entry)
{
  this->FindCandidates(entry.Vertex);
  LevelQueue::Level next = entry.At + LevelsAfterRefusal;
  for (const Candidate& candidate : this->Candidates)
  {
    const LevelQueue::Level level = LevelQueue::LevelOf(candidate.Answer.Cost);
    if (level > entry.At)
    {
      next = std::min(next, level);
      break;
    }
    if (this->CollapseEdge(candidate))
    {
      return; // which has put what is left of the vertex on its level, and may have changed Candidates
    }
  }
  if (!this->Candidates.empty())
  {
    this->Queue.Set(entry.Vertex, next);
  }
}

//------------------------------------------------------------------------------
bool FastLoop::CollapseEdge(const Candidate& candidate)
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  const Edit edit = this->EditOf(candidate);
  const Index gone = mesh.Across(edit.Edge, edit.Keep);
  const Vector3 keptAt = mesh.Position(edit.Keep);
  const Vector3 goneAt = mesh.Position(gone);
  if (this->Work.Apply(edit) != Verdict::Allowed)
  {
    return false;
  }
  this->Queue.Remove(gone);
  this->Quadrics.Remember(edit.Keep,
    std::max(this->Quadrics.MemoryOf(edit.Keep) + this->DistanceToFan(keptAt, edit.Keep),
      this->Quadrics.MemoryOf(gone) + this->DistanceToFan(goneAt, edit.Keep)));
  this->Quadrics.Update(edit.Keep);
  mesh.VisitEdges(edit.Keep, [&](Index h) { this->Quadrics.Update(mesh.Across(h, edit.Keep)); });
  this->PutOnLevel(edit.Keep);
  if (mesh.NumberOfFaces() < this->RenewBelow)
  {
    mesh.VisitEdges(edit.Keep, [&](Index h) { this->PutOnLevel(mesh.Across(h, edit.Keep)); });
  }
  return true;
}

//------------------------------------------------------------------------------
/// To the best place, or onto the border vertex where an inside edge leads to one.
Edit FastLoop::EditOf(const Candidate& candidate) const
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  const Index start = mesh.Origin(candidate.Edge);
  const Index end = mesh.Target(candidate.Edge);
  const bool startOnBorder = mesh.Kind(start) == VertexKind::Border;
  if (startOnBorder != (mesh.Kind(end) == VertexKind::Border))
  {
    const Index border = startOnBorder ? start : end;
    return { candidate.Edge, border, mesh.Position(border), true };
  }
  return { candidate.Edge, start, candidate.Answer.Position, false };
}

//------------------------------------------------------------------------------
/// From p to the faces around the vertex, mm.
double FastLoop::DistanceToFan(const Vector3& p, Index vertex) const
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  double least = std::numeric_limits<double>::infinity(); // mm^2
  for (const Index h : mesh.OutgoingOf(vertex))
  {
    const Vector3& third = mesh.Position(mesh.Origin(HalfEdgeMesh::Previous(h)));
    least = std::min(least,
      NearestOnTriangle(p, mesh.Position(vertex), mesh.Position(mesh.Target(h)), third)
        .SquaredDistance);
  }
  return std::sqrt(least);
}
}
