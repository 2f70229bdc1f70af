// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CollapseSearch.h"

#include "Decimate/Cost/SpikePenalty.h"
#include "Decimate/Edit/CollapseRules.h"
#include "Decimate/Placement/AlternatePositions.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
constexpr int BucketsAfterRejection = 4 * BucketsPerDoubling;
}

CollapseSearch::Result CollapseSearch::Find(
  VertexEdges& edges, CostBucket highest, const BlockTask& task, EditWorkspace& workspace)
{
  this->Task = &task;
  this->Workspace = &workspace;
  this->IsLasting = true;
  const VertexId vertex = edges.Vertex();
  edges.Forget();
  if (!edges.AreInside())
  {
    return { Outcome::Deferred, NeverBucket, 0.0, false };
  }
  CostBucket rejectedUntil = NeverBucket;
  bool crosses = false;
  CostBucket bucket = BucketOf(edges.MinCost());
  for (; this->Data.IsRejected(vertex) && bucket < this->Data.Buckets[vertex];
       bucket = BucketOf(edges.MinCost()))
  {
    edges.TakeCheapest();
  }
  for (; bucket <= highest; bucket = BucketOf(edges.MinCost()))
  {
    const Trial trial = this->TryEdge(vertex, edges.TakeCheapest(), CostOf(highest));
    if (trial == Trial::TooFar && task.TriesAll())
    {
      continue;
    }
    if (trial != Trial::TooCostly && trial != Trial::Crossing)
    {
      return { trial == Trial::Accepted ? Outcome::Accepted
          : trial == Trial::Deferred    ? Outcome::Deferred
                                        : Outcome::Rejected,
        NeverBucket, this->AccumulatedError, this->IsLasting && trial != Trial::Deferred };
    }
    crosses = crosses || trial == Trial::Crossing;
    rejectedUntil =
      static_cast<CostBucket>(std::min<int>(highest + BucketsAfterRejection, NeverBucket));
  }
  // All edges were tried. Trying them again until the end of the pass would take longer than the
  // pass.
  const bool waits = crosses && bucket == NeverBucket;
  return { Outcome::Rejected, waits ? NeverBucket : std::min(bucket, rejectedUntil), 0.0,
    this->IsLasting };
}

//------------------------------------------------------------------------------
/// Whether all edges of the vertex were tried with all positions, and nothing has changed since.
bool CollapseSearch::WasTried(VertexId vertex) const
{
  return this->Task->TriesAll() && this->Data.Buckets[vertex] == NeverBucket &&
    this->Data.IsRejected(vertex);
}

//------------------------------------------------------------------------------
/// TooFar: not proved, or rejected while all positions are tried. TooCostly: rejected for another
/// reason than Crossing, or the spike penalty is above the current bucket.
CollapseSearch::Trial CollapseSearch::TryEdge(
  VertexId vertex, const VertexEdges::Candidate& candidate, float maxCost)
{
  // An edge also depends on the surroundings of its other end.
  if (this->Data.IsRejected(vertex) &&
    this->WasTried(this->MeshEditor.Mesh().OtherEnd(candidate.Edge, vertex)))
  {
    return Trial::TooFar;
  }
  const Decision decision = this->MeshEditor.Gather(candidate.Edge, *this->Workspace);
  if (decision.IsRejected())
  {
    return this->Task->TriesAll() ? Trial::TooFar : Trial::TooCostly;
  }
  const std::vector<Index>& ring = this->Workspace->Neighborhood.Ring;
  const bool isDeferred = decision.IsDeferred() ||
    !std::all_of(
      ring.begin(), ring.end(), [this](VertexId v) { return this->Task->Vertices.Contains(v); });
  return isDeferred ? Trial::Deferred
                    : this->TryPositions(this->EditOf(vertex, candidate), maxCost);
}

//------------------------------------------------------------------------------
/// Tries the best position and, if that cannot be proved and all are tried, the alternatives.
CollapseSearch::Trial CollapseSearch::TryPositions(const Edit& best, float maxCost)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  const VertexId other = mesh.OtherEnd(best.Edge, best.Keep);
  const Vector3 start = mesh.Position(best.Keep);
  const Vector3 end = mesh.Position(other);
  const int count = best.KeepStays ? 1 : this->Task->PositionsTried;
  Decision decision = Rejection::ErrorBound;
  for (int i = 0; i < count && !decision.IsDeferred(); ++i)
  {
    Edit edit = best;
    edit.Position =
      i == 0 ? best.Position : AlternatePositions[i - 1].Of(best.Position, start, end);
    this->AccumulatedError = this->AccumulatedErrorAfter(edit);
    if (SpikePenalty(this->Data.SpikeFactor, mesh.NumberOfFaces(), this->AccumulatedError) >
      maxCost)
    {
      this->IsLasting = false; // the penalty may be below the next bucket
      return Trial::TooCostly;
    }
    this->Workspace->Change.AccumulatedError = this->AccumulatedError * mesh.Unit();
    decision = this->MeshEditor.Check(edit, *this->Workspace);
    if (decision.IsAccepted())
    {
      return Trial::Accepted;
    }
  }
  const Rejection reason = decision.Reason();
  // With several workers, each has a part of the volume that a fragment may lose.
  this->IsLasting = this->IsLasting && (reason != Rejection::Fragment || this->Task->Workers == 1);
  const bool isTooFar = reason == Rejection::ErrorBound || reason == Rejection::VoxelLabel;
  return decision.IsDeferred()           ? Trial::Deferred
    : isTooFar || this->Task->TriesAll() ? Trial::TooFar
    : reason == Rejection::Intersection  ? Trial::Crossing
                                         : Trial::TooCostly;
}

//------------------------------------------------------------------------------
/// The accumulated error after the edit, units.
double CollapseSearch::AccumulatedErrorAfter(const Edit& edit)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  const EdgeNeighborhood& around = this->Workspace->Neighborhood;
  const double unit = mesh.Unit();
  Fan& fan = this->Workspace->FanArrays.Current();
  const Vector3 position = edit.Position - mesh.Position(around.Start);
  for (int k = 0; k < 3; ++k)
  {
    fan.Position[k] = position[k];
  }
  return this->KernelSet.AccumulateError(fan, unit * this->Data.AccumulatedErrors[around.Start],
           unit * this->Data.AccumulatedErrors[around.End]) /
    unit;
}

//------------------------------------------------------------------------------
/// Collapses to the best position, or onto the vertex with the higher constraint if the constraints
/// of the ends differ.
Edit CollapseSearch::EditOf(VertexId vertex, const VertexEdges::Candidate& candidate) const
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  const VertexId other = mesh.OtherEnd(candidate.Edge, vertex);
  if (mesh.Constraint(vertex) != mesh.Constraint(other))
  {
    const VertexId stays =
      Outranks(mesh.Constraint(vertex), mesh.Constraint(other)) ? vertex : other;
    return { candidate.Edge, stays, mesh.Position(stays), true };
  }
  const Vector3 move(candidate.Move[0], candidate.Move[1], candidate.Move[2]);
  return { candidate.Edge, vertex, mesh.Position(vertex) + move * mesh.Unit(), false };
}
}
