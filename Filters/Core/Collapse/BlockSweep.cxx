// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockSweep.h"

#include "Gate.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace bonedecimate
{
namespace
{
constexpr int KeysAfterRefusal = 4 * KeysOfOctave;

CostKey KeyOf(float cost)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &cost, sizeof(bits));
  return static_cast<CostKey>(std::min<std::uint32_t>(bits >> 15U, NeverKey - 1));
}

/// An open border moves only along itself.
Freedom FreedomOf(VertexKind first, VertexKind second, bool isBorderEdge)
{
  if (second == VertexKind::Locked)
  {
    return Freedom::Nowhere;
  }
  if (first == VertexKind::Border)
  {
    return second != VertexKind::Border ? Freedom::First
      : isBorderEdge                    ? Freedom::Edge
                                        : Freedom::Nowhere;
  }
  return second == VertexKind::Border ? Freedom::Second : Freedom::Space;
}
}

//------------------------------------------------------------------------------
/// Fills Candidates with the edges at the vertex that may be collapsed at all. False if one leaves the block.
bool BlockSweep::FindCandidates(Index vertex)
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  const VertexKind kind = mesh.Kind(vertex);
  this->Candidates.clear();
  this->Batch.First = &mesh.Record(vertex);
  this->Batch.Count = 0;
  bool isInside = true;
  mesh.VisitEdges(vertex,
    [&](Index h)
    {
      const Index other = mesh.Across(h, vertex);
      if (!this->IsInside(other))
      {
        isInside = false;
        return;
      }
      const int at = this->Batch.Count++;
      this->Batch.Others[at] = &mesh.Record(other);
      this->Batch.Freedoms[at] =
        static_cast<std::int32_t>(FreedomOf(kind, mesh.Kind(other), mesh.Twin(h) == None));
      this->Batch.Memories[at] =
        std::max(this->Known.Memories[vertex], this->Known.Memories[other]);
      this->BatchEdges[at] = h;
      if (this->Batch.Count == EdgeBatch::Size)
      {
        this->JudgeBatch();
      }
    });
  if (isInside && this->Batch.Count > 0)
  {
    this->JudgeBatch();
  }
  return isInside;
}

//------------------------------------------------------------------------------
void BlockSweep::JudgeBatch()
{
  this->Batch.PerUnit = this->PerUnit;
  this->Batch.CostFactor = this->Known.CostFactor;
  EdgeAnswers answers;
  this->Compute.JudgeEdges(this->Batch, answers);
  for (int i = 0; i < this->Batch.Count; ++i)
  {
    if (answers.Costs[i] < std::numeric_limits<float>::infinity())
    {
      this->Candidates.push_back({ answers.Costs[i], this->BatchEdges[i],
        { answers.Moves[0][i], answers.Moves[1][i], answers.Moves[2][i] } });
    }
  }
  this->Batch.Count = 0;
}

//------------------------------------------------------------------------------
void BlockSweep::RenewAll(Index first, Index last)
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  this->Task = {};
  this->Task.Last = mesh.NumberOfVertexSlots();
  for (Index v = first; v < last; ++v)
  {
    if (mesh.Outgoing(v) != None && mesh.Kind(v) != VertexKind::Locked)
    {
      this->Renew(v);
    }
  }
}

//------------------------------------------------------------------------------
/// Gives the vertex the key of its cheapest edge.
void BlockSweep::Renew(Index vertex)
{
  this->FindCandidates(vertex);
  float least = std::numeric_limits<float>::infinity();
  for (const Candidate& candidate : this->Candidates)
  {
    least = std::min(least, candidate.Cost);
  }
  this->Known.Keys[vertex] = this->Candidates.empty() ? NeverKey : KeyOf(least);
}

//------------------------------------------------------------------------------
/// Lists the vertices whose keys are not above the level; returns the least of the other keys.
int BlockSweep::FindReady(int level)
{
  constexpr Index Stride = 64; // counted without branches first
  this->Ready.clear();
  CostKey next = NeverKey;
  const CostKey* keys = this->Known.Keys.data();
  const CostKey highest = static_cast<CostKey>(level);
  for (Index first = this->Task.First; first < this->Task.Last; first += Stride)
  {
    const Index last = std::min(this->Task.Last, first + Stride);
    CostKey found = 0;
    for (Index v = first; v < last; ++v)
    {
      const CostKey above = keys[v] > highest ? keys[v] : NeverKey;
      next = std::min(next, above);
      found = static_cast<CostKey>(found | (keys[v] <= highest ? 1 : 0));
    }
    for (Index v = first; v < last && found != 0; ++v)
    {
      if (keys[v] <= highest)
      {
        this->Ready.push_back(v);
      }
    }
  }
  return next;
}

//------------------------------------------------------------------------------
BlockSweep::Outcome BlockSweep::CollapseAt(Index vertex, int level)
{
  if (!this->FindCandidates(vertex))
  {
    this->PutOff(vertex);
    return Outcome::Elsewhere;
  }
  int refusedAt = level;
  while (!this->Candidates.empty())
  {
    const auto best = std::min_element(this->Candidates.begin(), this->Candidates.end(),
      [](const Candidate& a, const Candidate& b) { return a.Cost < b.Cost; });
    const CostKey key = KeyOf(best->Cost);
    if (key > level)
    {
      this->Known.Keys[vertex] =
        refusedAt > level ? std::min<CostKey>(key, static_cast<CostKey>(refusedAt)) : key;
      return Outcome::Dearer;
    }
    const Outcome outcome = this->TryEdge(vertex, *best);
    if (outcome != Outcome::Dearer)
    {
      return outcome;
    }
    refusedAt = std::min(level + KeysAfterRefusal, NeverKey - 1);
    this->Candidates.erase(best);
  }
  this->Known.Keys[vertex] = refusedAt > level ? static_cast<CostKey>(refusedAt) : NeverKey;
  return Outcome::Dearer;
}

//------------------------------------------------------------------------------
/// Dearer means refused.
BlockSweep::Outcome BlockSweep::TryEdge(Index vertex, const Candidate& candidate)
{
  if (this->Work.Examine(candidate.Edge, this->Space) != Verdict::Allowed)
  {
    return Outcome::Dearer;
  }
  const std::vector<Index>& ring = this->Space.Around.Ring;
  if (!std::all_of(ring.begin(), ring.end(), [this](Index v) { return this->IsInside(v); }))
  {
    this->PutOff(vertex);
    return Outcome::Elsewhere;
  }
  const Edit edit = this->EditOf(vertex, candidate);
  const Index gone = this->Work.Mesh().Across(edit.Edge, edit.Keep);
  if (this->Work.Apply(edit, this->Space, this->Task.Workers) != Verdict::Allowed)
  {
    return Outcome::Dearer;
  }
  this->AfterCollapse(edit, gone);
  return Outcome::Collapsed;
}

//------------------------------------------------------------------------------
/// To the best place, or onto the border vertex where an inside edge leads to one.
Edit BlockSweep::EditOf(Index vertex, const Candidate& candidate) const
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  const Index other = mesh.Across(candidate.Edge, vertex);
  const bool onBorder = mesh.Kind(vertex) == VertexKind::Border;
  if (onBorder != (mesh.Kind(other) == VertexKind::Border))
  {
    const Index border = onBorder ? vertex : other;
    return { candidate.Edge, border, mesh.Position(border), true };
  }
  const Vector3 move(candidate.Move[0], candidate.Move[1], candidate.Move[2]);
  return { candidate.Edge, vertex, mesh.Position(vertex) + move * mesh.Unit(), false };
}

//------------------------------------------------------------------------------
void BlockSweep::AfterCollapse(const Edit& edit, Index gone)
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  std::vector<float>& memories = this->Known.Memories;
  const double unit = mesh.Unit();
  const double left = this->Compute.LeaveBehind(this->Space.Faces.Current(),
    unit * memories[this->Space.Around.Start], unit * memories[this->Space.Around.End]);
  memories[edit.Keep] = static_cast<float>(left * this->PerUnit);
  this->Known.Keys[gone] = NeverKey;
  this->Renew(edit.Keep);
  if (this->Task.RenewsRing)
  {
    mesh.VisitEdges(edit.Keep,
      [&](Index h)
      {
        const Index other = mesh.Across(h, edit.Keep);
        if (mesh.Kind(other) != VertexKind::Locked)
        {
          this->Renew(other);
        }
      });
  }
}

//------------------------------------------------------------------------------
void BlockSweep::PutOff(Index vertex)
{
  this->Postponed.push_back({ vertex, this->Known.Keys[vertex] });
  this->Known.Keys[vertex] = NeverKey;
}

//------------------------------------------------------------------------------
/// What was put off, and has not been collapsed since, gets its key back.
void BlockSweep::Restore()
{
  for (const OldKey& old : this->Postponed)
  {
    const bool isThere = this->Work.Mesh().Outgoing(old.Vertex) != None;
    if (isThere && this->Known.Keys[old.Vertex] == NeverKey)
    {
      this->Known.Keys[old.Vertex] = old.Key;
    }
  }
  this->Postponed.clear();
}
}
