// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockSweep.h"

#include "Gate.h"
#include "Memory/Prefetch.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
constexpr int KeysAfterRefusal = 4 * KeysOfOctave;

/// Where a merged vertex may go if the best place cannot be proved, seen from the middle of its edge.
struct OtherPlace
{
  double TowardsBest;
  double TowardsStart; // of the edge; -1: to its end

  Vector3 Of(const Vector3& best, const Vector3& start, const Vector3& end) const
  {
    const Vector3 middle = 0.5 * (start + end);
    return middle + this->TowardsBest * (best - middle) + this->TowardsStart * (start - middle);
  }
};
/// The first few are what most is won by for what they cost: the middle and the ends are soon refused.
constexpr std::array<OtherPlace, BlockTask::MostPlaces - 1> OtherPlaces = { { { 0.0, 0.0 },
  { 0.0, 1.0 }, { 0.0, -1.0 }, { 1.0, 0.3 }, { 1.0, -0.3 }, { 0.5, 0.0 }, { 1.5, 0.0 },
  { 2.0, 0.0 }, { 0.5, 0.3 }, { 0.5, -0.3 }, { 1.5, 0.3 }, { 1.5, -0.3 } } };
}

//------------------------------------------------------------------------------
void BlockSweep::RenewAll(Index first, Index last)
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  this->Task = {};
  this->Task.Vertices.Last = mesh.NumberOfVertexSlots();
  for (Index v = first; v < last; ++v)
  {
    if (mesh.Outgoing(v) != None && !mesh.IsFixed(v) && this->Known.TakeChange(v))
    {
      this->Renew(v);
    }
  }
}

//------------------------------------------------------------------------------
/// Gives the vertex the key of its cheapest edge.
void BlockSweep::Renew(Index vertex)
{
  this->Merged.Gather(this->Work.Mesh(), this->Known, vertex, this->Task.Vertices);
  this->Merged.Judge(this->Compute);
  this->SetKey(vertex, KeyOf(this->Merged.LeastCost()));
}

//------------------------------------------------------------------------------
/// The last vertex first, since lists are read backwards.
void BlockSweep::ListVertices()
{
  constexpr Index step = 32; // looked at together: later rounds find few
  this->Levels.Clear();
  const CostKey* keys = this->Known.Keys.data();
  const CostKey limit = this->Task.Limit;
  for (Index end = this->Task.Vertices.Last; end > this->Task.Vertices.First; end -= step)
  {
    const Index first = std::max(this->Task.Vertices.First, end - step);
    const bool hasAny = CountUpTo(limit, keys + first, keys + end) > 0;
    for (Index v = end; hasAny && v-- > first;)
    {
      if (keys[v] <= limit)
      {
        this->Levels.Add(v, keys[v]);
      }
    }
  }
}

//------------------------------------------------------------------------------
/// Goes round the next vertices of the list ahead of Gather, a face of each at a time, so that each wait overlaps with
/// work.
void BlockSweep::LookAhead(std::size_t at)
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  const std::size_t size = this->Ready.size();
  if (at + Ahead < size)
  {
    Prefetch(&mesh.Record(this->Ready[at + Ahead]));
  }
  if (at + Ahead - 1 < size)
  {
    Index& cursor = this->Cursors[(at + Ahead - 1) % Ahead];
    cursor = mesh.Outgoing(this->Ready[at + Ahead - 1]);
    Prefetch(mesh.RecordOfFace(std::max(0, cursor)));
  }
  for (std::size_t i = at + 2; i < std::min(at + Ahead - 1, size); ++i)
  {
    Index& cursor = this->Cursors[i % Ahead];
    if (cursor != None && mesh.Origin(cursor) == this->Ready[i])
    {
      Prefetch(&mesh.Record(mesh.Target(cursor)));
      cursor = mesh.Twin(HalfEdgeMesh::Previous(cursor));
      Prefetch(mesh.RecordOfFace(std::max(0, cursor)));
    }
  }
}

//------------------------------------------------------------------------------
void BlockSweep::SetKey(Index vertex, CostKey key)
{
  this->Known.Keys[vertex] = key;
  if (key <= this->Task.Limit)
  {
    this->Levels.Add(vertex, key);
  }
}

//------------------------------------------------------------------------------
/// Of the vertex at that place of the list, judged. Those of the next are gathered first, to arrive meanwhile.
VertexEdges& BlockSweep::EdgesOfReady(std::size_t at, CostKey highest)
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  VertexEdges& edges = this->Gathered[at % 2];
  if (edges.Vertex() != this->Ready[at])
  {
    edges.Gather(mesh, this->Known, this->Ready[at], this->Task.Vertices);
  }
  if (at + 1 < this->Ready.size() && this->Known.Keys[this->Ready[at + 1]] <= highest)
  {
    this->Gathered[(at + 1) % 2].Gather(
      mesh, this->Known, this->Ready[at + 1], this->Task.Vertices);
  }
  if (edges.AreInside())
  {
    edges.Judge(this->Compute);
  }
  return edges;
}

//------------------------------------------------------------------------------
BlockSweep::Outcome BlockSweep::CollapseAt(VertexEdges& edges, CostKey highest)
{
  const Index vertex = edges.Vertex();
  edges.Forget();
  if (!edges.AreInside())
  {
    this->PutOff(vertex);
    return Outcome::Elsewhere;
  }
  CostKey refusedUntil = NeverKey;
  bool crosses = false;
  CostKey key = KeyOf(edges.LeastCost());
  for (; key <= highest; key = KeyOf(edges.LeastCost()))
  {
    const Outcome outcome = this->TryEdge(vertex, edges.TakeCheapest(), CostOf(highest));
    if (outcome == Outcome::TooFar && this->Task.TriesAll())
    {
      continue;
    }
    if (outcome == Outcome::TooFar)
    {
      this->SetKey(vertex, NeverKey);
      return Outcome::TooFar;
    }
    if (outcome != Outcome::Dearer && outcome != Outcome::Crossing)
    {
      return outcome;
    }
    crosses = crosses || outcome == Outcome::Crossing;
    refusedUntil = static_cast<CostKey>(std::min<int>(highest + KeysAfterRefusal, NeverKey));
  }
  // With no edge left that was not tried, to try again and again until the end of the pass would cost more than the pass.
  const bool waits = crosses && key == NeverKey;
  this->SetKey(vertex, waits ? NeverKey : std::min(key, refusedUntil));
  return Outcome::Dearer;
}

//------------------------------------------------------------------------------
/// Whether all edges of the vertex were tried at all places, and nothing has changed since.
bool BlockSweep::WasTried(Index vertex) const
{
  return this->Task.TriesAll() && this->Known.Keys[vertex] == NeverKey &&
    !this->Known.Changed[vertex];
}

//------------------------------------------------------------------------------
/// Dearer means refused, or a peak whose turn has not come; refused because it would cross something, it is Crossing.
BlockSweep::Outcome BlockSweep::TryEdge(
  Index vertex, const VertexEdges::Candidate& candidate, float mostCost)
{
  if (this->WasTried(this->Work.Mesh().Across(candidate.Edge, vertex)))
  {
    return Outcome::TooFar;
  }
  const Verdict verdict = this->Work.Examine(candidate.Edge, this->Space);
  if (verdict != Verdict::Allowed && verdict != Verdict::Elsewhere)
  {
    return this->Task.TriesAll() ? Outcome::TooFar : Outcome::Dearer;
  }
  const std::vector<Index>& ring = this->Space.Around.Ring;
  if (verdict == Verdict::Elsewhere ||
    !std::all_of(ring.begin(), ring.end(), [this](Index v) { return this->IsInside(v); }))
  {
    this->PutOff(vertex);
    return Outcome::Elsewhere;
  }
  const Outcome outcome = this->ApplyWherever(this->EditOf(vertex, candidate), mostCost);
  if (outcome == Outcome::Elsewhere)
  {
    this->PutOff(vertex);
  }
  return outcome;
}

//------------------------------------------------------------------------------
/// At the best place or, if that cannot be proved and all are tried, at another.
BlockSweep::Outcome BlockSweep::ApplyWherever(const Edit& best, float mostCost)
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  const Index other = mesh.Across(best.Edge, best.Keep);
  const Vector3 start = mesh.Position(best.Keep);
  const Vector3 end = mesh.Position(other);
  const int count = best.KeepStays ? 1 : this->Task.Places;
  Verdict verdict = Verdict::TooFar;
  for (int i = 0; i < count && verdict != Verdict::Elsewhere; ++i)
  {
    Edit edit = best;
    edit.Position = i == 0 ? best.Position : OtherPlaces[i - 1].Of(best.Position, start, end);
    const double left = this->LeaveBehind(edit);
    if (this->CostOfPeak(left) > mostCost)
    {
      return Outcome::Dearer;
    }
    verdict = this->Work.Apply(edit, this->Space, this->Task.Workers);
    if (verdict == Verdict::Allowed)
    {
      this->Known.Memories[edit.Keep] = static_cast<float>(left);
      this->AfterCollapse(edit, other);
      return Outcome::Collapsed;
    }
  }
  return verdict == Verdict::Elsewhere                    ? Outcome::Elsewhere
    : verdict == Verdict::TooFar || this->Task.TriesAll() ? Outcome::TooFar
    : verdict == Verdict::Crossing                        ? Outcome::Crossing
                                                          : Outcome::Dearer;
}

//------------------------------------------------------------------------------
/// How far the edit would leave the surface behind, with what was left behind before, units.
double BlockSweep::LeaveBehind(const Edit& edit)
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  const Neighbourhood& around = this->Space.Around;
  const double unit = mesh.Unit();
  Fan& fan = this->Space.Faces.Current();
  const Vector3 place = edit.Position - mesh.Position(around.Start);
  for (int k = 0; k < 3; ++k)
  {
    fan.Place[k] = place[k];
  }
  return this->Compute.LeaveBehind(fan, unit * this->Known.Memories[around.Start],
           unit * this->Known.Memories[around.End]) /
    unit;
}

//------------------------------------------------------------------------------
/// @param distance Units.
double BlockSweep::CostOfPeak(double distance) const
{
  return this->Known.PeakFactor / this->Work.Mesh().NumberOfFaces() * distance *
    std::sqrt(distance);
}

//------------------------------------------------------------------------------
/// To the best place, or onto the vertex that stays, where an inside edge leads to the border, or any to a pinned one.
Edit BlockSweep::EditOf(Index vertex, const VertexEdges::Candidate& candidate) const
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  const Index other = mesh.Across(candidate.Edge, vertex);
  if (mesh.Kind(vertex) != mesh.Kind(other))
  {
    const Index stays = mesh.Kind(vertex) > mesh.Kind(other) ? vertex : other;
    return { candidate.Edge, stays, mesh.Position(stays), true };
  }
  const Vector3 move(candidate.Move[0], candidate.Move[1], candidate.Move[2]);
  return { candidate.Edge, vertex, mesh.Position(vertex) + move * mesh.Unit(), false };
}

//------------------------------------------------------------------------------
void BlockSweep::AfterCollapse(const Edit& edit, Index gone)
{
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  this->Known.Keys[gone] = NeverKey;
  this->ForgetChanged();
  this->Renew(edit.Keep);
  this->Known.NoteChange(this->Space.Around.Ring);
  if (this->Task.RenewsRing)
  {
    mesh.VisitEdges(edit.Keep,
      [&](Index h)
      {
        const Index other = mesh.Across(h, edit.Keep);
        if (!mesh.IsFixed(other))
        {
          this->Renew(other);
        }
      });
  }
}

//------------------------------------------------------------------------------
/// What was gathered ahead may have lost an edge.
void BlockSweep::ForgetChanged()
{
  const Neighbourhood& around = this->Space.Around;
  for (VertexEdges& edges : this->Gathered)
  {
    const Index v = edges.Vertex();
    if (v == around.Start || v == around.End ||
      std::find(around.Ring.begin(), around.Ring.end(), v) != around.Ring.end())
    {
      edges.Forget();
    }
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
