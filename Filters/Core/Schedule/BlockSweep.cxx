// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockSweep.h"

#include "Cost/SpikePenalty.h"
#include "Edit/CollapseRules.h"
#include "Memory/Prefetch.h"
#include "Placement/AlternatePositions.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
constexpr int BucketsAfterRejection = 4 * BucketsPerDoubling;
}

//------------------------------------------------------------------------------
void BlockSweep::RenewAll(Index first, Index last)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  this->Task = {};
  this->Task.Vertices.Last = mesh.NumberOfVertexSlots();
  for (VertexId v = first; v < last; ++v)
  {
    if (mesh.Outgoing(v) != None && !mesh.IsConstrained(v) && this->Known.TakeChange(v))
    {
      this->Renew(v);
    }
  }
}

//------------------------------------------------------------------------------
/// Sets the bucket of the vertex to that of its cheapest edge.
void BlockSweep::Renew(VertexId vertex)
{
  this->Merged.Gather(this->MeshEditor.Mesh(), this->Known, vertex, this->Task.Vertices);
  this->Merged.Evaluate(this->Evaluate);
  this->SetBucket(vertex, BucketOf(this->Merged.LeastCost()));
}

//------------------------------------------------------------------------------
/// The last vertex first, since lists are read backwards.
void BlockSweep::ListVertices()
{
  constexpr Index step =
    32; // counted together: in later rounds most have no vertex below the limit
  this->Lists.Clear();
  const CostBucket* buckets = this->Known.Buckets.data();
  const CostBucket limit = this->Task.Limit;
  for (Index end = this->Task.Vertices.Last; end > this->Task.Vertices.First; end -= step)
  {
    const Index first = std::max(this->Task.Vertices.First, end - step);
    const bool hasAny = CountUpTo(limit, buckets + first, buckets + end) > 0;
    for (Index v = end; hasAny && v-- > first;)
    {
      if (buckets[v] <= limit)
      {
        this->Lists.Add(v, buckets[v]);
      }
    }
  }
}

//------------------------------------------------------------------------------
/// Prefetches the rings of the next vertices of the list before Gather reads them, one face of each at a time, so that
/// memory latency overlaps with computation.
void BlockSweep::LookAhead(std::size_t at)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
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
void BlockSweep::SetBucket(VertexId vertex, CostBucket bucket)
{
  this->Known.Buckets[vertex] = bucket;
  if (bucket <= this->Task.Limit)
  {
    this->Lists.Add(vertex, bucket);
  }
}

//------------------------------------------------------------------------------
/// The evaluated edges of the vertex at that position of the list. Those of the next vertex are gathered first, so that
/// their data is prefetched meanwhile.
VertexEdges& BlockSweep::EdgesOfReady(std::size_t at, CostBucket highest)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  VertexEdges& edges = this->Gathered[at % 2];
  if (edges.Vertex() != this->Ready[at])
  {
    edges.Gather(mesh, this->Known, this->Ready[at], this->Task.Vertices);
  }
  if (at + 1 < this->Ready.size() && this->Known.Buckets[this->Ready[at + 1]] <= highest)
  {
    this->Gathered[(at + 1) % 2].Gather(
      mesh, this->Known, this->Ready[at + 1], this->Task.Vertices);
  }
  if (edges.AreInside())
  {
    edges.Evaluate(this->Evaluate);
  }
  return edges;
}

//------------------------------------------------------------------------------
BlockSweep::Outcome BlockSweep::CollapseAt(VertexEdges& edges, CostBucket highest)
{
  const VertexId vertex = edges.Vertex();
  edges.Forget();
  if (!edges.AreInside())
  {
    this->Defer(vertex);
    return Outcome::Deferred;
  }
  CostBucket rejectedUntil = NeverBucket;
  bool crosses = false;
  CostBucket bucket = BucketOf(edges.LeastCost());
  for (; bucket <= highest; bucket = BucketOf(edges.LeastCost()))
  {
    const Outcome outcome = this->TryEdge(vertex, edges.TakeCheapest(), CostOf(highest));
    if (outcome == Outcome::TooFar && this->Task.TriesAll())
    {
      continue;
    }
    if (outcome == Outcome::TooFar)
    {
      this->SetBucket(vertex, NeverBucket);
      return Outcome::TooFar;
    }
    if (outcome != Outcome::TooCostly && outcome != Outcome::Crossing)
    {
      return outcome;
    }
    crosses = crosses || outcome == Outcome::Crossing;
    rejectedUntil =
      static_cast<CostBucket>(std::min<int>(highest + BucketsAfterRejection, NeverBucket));
  }
  // All edges were tried; trying them again until the end of the pass would cost more than the pass.
  const bool waits = crosses && bucket == NeverBucket;
  this->SetBucket(vertex, waits ? NeverBucket : std::min(bucket, rejectedUntil));
  return Outcome::TooCostly;
}

//------------------------------------------------------------------------------
/// Whether all edges of the vertex were tried with all positions, and nothing has changed since.
bool BlockSweep::WasTried(VertexId vertex) const
{
  return this->Task.TriesAll() && this->Known.Buckets[vertex] == NeverBucket &&
    !this->Known.Changed[vertex];
}

//------------------------------------------------------------------------------
/// TooFar: not proved, or rejected while all positions are tried. Crossing: rejected because of an intersection. TooCostly:
/// rejected for another reason, or the spike penalty is above the current bucket.
BlockSweep::Outcome BlockSweep::TryEdge(
  VertexId vertex, const VertexEdges::Candidate& candidate, float mostCost)
{
  if (this->WasTried(this->MeshEditor.Mesh().Across(candidate.Edge, vertex)))
  {
    return Outcome::TooFar;
  }
  const Decision decision = this->MeshEditor.Validate(candidate.Edge, this->Space);
  if (decision.IsRejected())
  {
    return this->Task.TriesAll() ? Outcome::TooFar : Outcome::TooCostly;
  }
  const std::vector<Index>& ring = this->Space.Around.Ring;
  if (decision.IsDeferred() ||
    !std::all_of(ring.begin(), ring.end(), [this](VertexId v) { return this->IsInside(v); }))
  {
    this->Defer(vertex);
    return Outcome::Deferred;
  }
  const Outcome outcome = this->ApplyAtPositions(this->EditOf(vertex, candidate), mostCost);
  if (outcome == Outcome::Deferred)
  {
    this->Defer(vertex);
  }
  return outcome;
}

//------------------------------------------------------------------------------
/// Tries the best position and, if that cannot be proved and all are tried, the alternatives.
BlockSweep::Outcome BlockSweep::ApplyAtPositions(const Edit& best, float mostCost)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  const VertexId other = mesh.Across(best.Edge, best.Keep);
  const Vector3 start = mesh.Position(best.Keep);
  const Vector3 end = mesh.Position(other);
  const int count = best.KeepStays ? 1 : this->Task.PositionsTried;
  Decision decision = Rejection::ErrorBound;
  for (int i = 0; i < count && !decision.IsDeferred(); ++i)
  {
    Edit edit = best;
    edit.Position =
      i == 0 ? best.Position : AlternatePositions[i - 1].Of(best.Position, start, end);
    const double accumulated = this->AccumulatedErrorAfter(edit);
    if (SpikePenalty(this->Known.SpikeFactor, mesh.NumberOfFaces(), accumulated) > mostCost)
    {
      return Outcome::TooCostly;
    }
    this->Space.AccumulatedError = accumulated * mesh.Unit();
    decision = this->MeshEditor.Collapse(edit, this->Space, this->Task.Workers);
    if (decision.IsAccepted())
    {
      this->Known.AccumulatedErrors[edit.Keep] = static_cast<float>(accumulated);
      this->AfterCollapse(edit, other);
      return Outcome::Collapsed;
    }
  }
  const Rejection reason = decision.Reason();
  const bool isTooFar = reason == Rejection::ErrorBound || reason == Rejection::VoxelLabel;
  return decision.IsDeferred()          ? Outcome::Deferred
    : isTooFar || this->Task.TriesAll() ? Outcome::TooFar
    : reason == Rejection::Intersection ? Outcome::Crossing
                                        : Outcome::TooCostly;
}

//------------------------------------------------------------------------------
/// The accumulated error after the edit, units.
double BlockSweep::AccumulatedErrorAfter(const Edit& edit)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  const EdgeNeighborhood& around = this->Space.Around;
  const double unit = mesh.Unit();
  Fan& fan = this->Space.Faces.Current();
  const Vector3 position = edit.Position - mesh.Position(around.Start);
  for (int k = 0; k < 3; ++k)
  {
    fan.Position[k] = position[k];
  }
  return this->Compute.LeaveBehind(fan, unit * this->Known.AccumulatedErrors[around.Start],
           unit * this->Known.AccumulatedErrors[around.End]) /
    unit;
}

//------------------------------------------------------------------------------
/// To the best position, or onto the vertex with the higher constraint if the constraints of the ends differ.
Edit BlockSweep::EditOf(VertexId vertex, const VertexEdges::Candidate& candidate) const
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  const VertexId other = mesh.Across(candidate.Edge, vertex);
  if (mesh.Constraint(vertex) != mesh.Constraint(other))
  {
    const VertexId stays =
      Outranks(mesh.Constraint(vertex), mesh.Constraint(other)) ? vertex : other;
    return { candidate.Edge, stays, mesh.Position(stays), true };
  }
  const Vector3 move(candidate.Move[0], candidate.Move[1], candidate.Move[2]);
  return { candidate.Edge, vertex, mesh.Position(vertex) + move * mesh.Unit(), false };
}

//------------------------------------------------------------------------------
void BlockSweep::AfterCollapse(const Edit& edit, VertexId gone)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  this->Known.Buckets[gone] = NeverBucket;
  this->ForgetChanged();
  this->Renew(edit.Keep);
  this->Known.NoteChange(this->Space.Around.Ring);
  if (this->Task.RenewsRing)
  {
    mesh.VisitEdges(edit.Keep,
      [&](HalfEdgeId h)
      {
        const VertexId other = mesh.Across(h, edit.Keep);
        if (!mesh.IsConstrained(other))
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
  const EdgeNeighborhood& around = this->Space.Around;
  for (VertexEdges& edges : this->Gathered)
  {
    const VertexId v = edges.Vertex();
    if (v == around.Start || v == around.End ||
      std::find(around.Ring.begin(), around.Ring.end(), v) != around.Ring.end())
    {
      edges.Forget();
    }
  }
}

//------------------------------------------------------------------------------
void BlockSweep::Defer(VertexId vertex)
{
  this->Postponed.push_back({ vertex, this->Known.Buckets[vertex] });
  this->Known.Buckets[vertex] = NeverBucket;
}

//------------------------------------------------------------------------------
/// Deferred vertices that have not been collapsed since get their bucket back.
void BlockSweep::Restore()
{
  for (const OldBucket& old : this->Postponed)
  {
    const bool isThere = this->MeshEditor.Mesh().Outgoing(old.Vertex) != None;
    if (isThere && this->Known.Buckets[old.Vertex] == NeverBucket)
    {
      this->Known.Buckets[old.Vertex] = old.Bucket;
    }
  }
  this->Postponed.clear();
}
}
