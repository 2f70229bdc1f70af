// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BatchSweep.h"

#include <algorithm>
#include <utility>

namespace bonedecimate
{
namespace
{
/// Vertices of a batch.
constexpr std::size_t MinBatch = 8;
constexpr std::size_t FirstBatch = 32;
constexpr std::size_t MaxBatch = 128;
/// A batch shrinks if more than one collapse in this many was found in vain, and grows if less than
/// one in four times as many.
constexpr std::size_t CollapsesForOneInVain = 8;
/// Vertices that wait, in batches: no list is read while there are more.
constexpr std::size_t BatchesThatWait = 4;
}

BatchSweep::BatchSweep(
  Editor& editor, const EdgeEvaluator& evaluate, VertexBuckets& buckets, int threads)
  : MeshEditor(editor)
  , Evaluate(evaluate)
  , Known(buckets)
  , Lists(editor.Mesh(), evaluate, buckets)
  , Team(static_cast<int>(std::min<std::size_t>(ThreadsToUse(threads), MaxBatch)))
  , Candidates(MaxBatch)
  , MaxInBatch(FirstBatch)
  , ReservedBy(buckets.Buckets.size(), 0)
{
}

//------------------------------------------------------------------------------
bool BatchSweep::Run(const BlockTask& task, StopCriterion& end, const Monitor& monitor)
{
  this->Task = task;
  this->Lists.Fill(task);
  Index left = task.Collapses;
  while (left > 0 && !end.IsReached())
  {
    if (!end.TellNow(monitor))
    {
      return false;
    }
    this->FillBatch();
    if (this->Size == 0)
    {
      return true;
    }
    this->Team.Run(this->Size, [this](std::size_t i) { this->SearchAt(this->Candidates[i]); });
    this->Changed.clear();
    const std::size_t waiting = this->Waiting.size();
    for (std::size_t i = 0; i < this->Size && left > 0 && !end.IsReached(); ++i)
    {
      if (this->Commit(this->Candidates[i]))
      {
        --left;
        if (!end.Tell(monitor))
        {
          return false;
        }
      }
    }
    this->ChangeBatchSize(this->Changed.size(), this->Waiting.size() - waiting);
  }
  return true;
}

//------------------------------------------------------------------------------
/// Those that waited first.
void BatchSweep::FillBatch()
{
  this->Size = 0;
  ++this->Batch;
  this->Retried.swap(this->Waiting);
  this->Waiting.clear();
  for (const Listed& listed : this->Retried)
  {
    this->Take(listed);
  }
  while (this->Size < this->MaxInBatch && this->Waiting.size() < BatchesThatWait * this->MaxInBatch)
  {
    if (this->NextReady == this->Ready.size())
    {
      this->MaxOfReady = this->Lists.TakeLowest(this->Ready);
      this->NextReady = 0;
    }
    if (this->Ready.empty())
    {
      return;
    }
    this->Take({ this->Ready[this->NextReady++], this->MaxOfReady });
  }
}

//------------------------------------------------------------------------------
/// Adds the vertex to the batch or to those that wait, unless its bucket has risen since it was
/// listed.
void BatchSweep::Take(const Listed& listed)
{
  if (this->Known.Buckets[listed.Vertex] > listed.Highest)
  {
    return;
  }
  if (this->Size == this->MaxInBatch || !this->ReserveRing(listed.Vertex))
  {
    this->Waiting.push_back(listed);
    return;
  }
  this->Candidates[this->Size++].At = listed;
}

//------------------------------------------------------------------------------
/// False if the batch has a vertex of the closed ring already.
bool BatchSweep::ReserveRing(VertexId vertex)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  bool isFree = this->ReservedBy[vertex] != this->Batch;
  mesh.VisitNeighbors(vertex,
    [&](HalfEdgeId, Index other) { isFree = isFree && this->ReservedBy[other] != this->Batch; });
  if (isFree)
  {
    this->ReservedBy[vertex] = this->Batch;
    mesh.VisitNeighbors(
      vertex, [this](HalfEdgeId, Index other) { this->ReservedBy[other] = this->Batch; });
  }
  return isFree;
}

//------------------------------------------------------------------------------
/// Called at the same time for all candidates of a batch.
void BatchSweep::SearchAt(Candidate& candidate) const
{
  candidate.Space.Change.Rank = candidate.At.Highest;
  candidate.Space.Change.Range = this->Task.Vertices;
  candidate.Edges.Gather(
    this->MeshEditor.Mesh(), this->Known, candidate.At.Vertex, this->Task.Vertices);
  candidate.Edges.Evaluate(this->Evaluate);
  candidate.Found = CollapseSearch(this->MeshEditor, this->Known)
                      .Find(candidate.Edges, candidate.At.Highest, this->Task, candidate.Space);
  if (candidate.Found.Of == CollapseSearch::Outcome::Accepted)
  {
    this->FindBox(candidate);
  }
}

//------------------------------------------------------------------------------
/// All faces that change have their corners on the ring or at the ends.
void BatchSweep::FindBox(Candidate& candidate) const
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  const EdgeNeighborhood& around = candidate.Space.Around;
  Box& box = candidate.Changes;
  box.Low = box.High = candidate.Space.Change.Requested.Position;
  const auto add = [&](VertexId v)
  {
    box.Low = box.Low.cwiseMin(mesh.Position(v));
    box.High = box.High.cwiseMax(mesh.Position(v));
  };
  add(around.Start);
  add(around.End);
  std::for_each(around.Ring.begin(), around.Ring.end(), add);
}

//------------------------------------------------------------------------------
/// Whether what the search read is as it was.
bool BatchSweep::IsUpToDate(Candidate& candidate) const
{
  const Box& own = candidate.Changes;
  const double reach = candidate.Space.Change.Reach;
  const auto isApart = [&own, reach](const Box& other) {
    return (other.Low - own.High).maxCoeff() > reach || (own.Low - other.High).maxCoeff() > reach;
  };
  return std::all_of(this->Changed.begin(), this->Changed.end(), isApart) &&
    this->MeshEditor.StillAccepts(candidate.Space);
}

//------------------------------------------------------------------------------
/// Whether an edge was collapsed.
bool BatchSweep::Commit(Candidate& candidate)
{
  const bool isAccepted = candidate.Found.Of == CollapseSearch::Outcome::Accepted;
  const bool isCollapsed = isAccepted && this->IsUpToDate(candidate);
  if (isCollapsed)
  {
    this->Collapse(candidate);
  }
  else if (isAccepted)
  {
    this->Waiting.push_back(candidate.At);
  }
  else
  {
    this->Lists.Reject(candidate.At.Vertex, candidate.Found.Bucket, candidate.Found.IsLasting);
  }
  this->MeshEditor.Settle(&candidate.Space.Counted);
  return isCollapsed;
}

//------------------------------------------------------------------------------
void BatchSweep::Collapse(Candidate& candidate)
{
  const Edit edit = candidate.Space.Change.Requested;
  const VertexId gone = this->MeshEditor.Mesh().Across(edit.Edge, edit.Keep);
  this->MeshEditor.Apply(candidate.Space);
  this->Lists.Update(edit, gone, candidate.Found.AccumulatedError, candidate.Space.Around);
  this->Changed.push_back(candidate.Changes);
}

//------------------------------------------------------------------------------
void BatchSweep::ChangeBatchSize(std::size_t collapses, std::size_t inVain)
{
  if (inVain * CollapsesForOneInVain > collapses)
  {
    this->MaxInBatch = std::max(MinBatch, this->MaxInBatch / 2);
  }
  else if (inVain * 4 * CollapsesForOneInVain <= collapses)
  {
    this->MaxInBatch = std::min(MaxBatch, this->MaxInBatch + this->MaxInBatch / 4);
  }
}
}
