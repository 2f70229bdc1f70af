// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BatchSweep.h"

#include <algorithm>
#include <utility>

namespace bonedecimate
{
namespace
{
/// Number of vertices in a batch.
constexpr std::size_t MinBatch = 8;
constexpr std::size_t FirstBatch = 32;
constexpr std::size_t MaxBatch = 128;
/// A batch shrinks if more than one search was wasted for this many collapses, and grows if less
/// than one was for four times as many.
constexpr std::size_t CollapsesPerWasted = 8;
/// Maximum number of waiting vertices, in batches. With more, no list is read.
constexpr std::size_t MaxWaitingBatches = 4;
}

BatchSweep::BatchSweep(Editor& editor, const EdgeEvaluator& evaluate, SweepData& data, int threads)
  : MeshEditor(editor)
  , Evaluate(evaluate)
  , Data(data)
  , Lists(editor.Mesh(), evaluate, data)
  , Team(static_cast<int>(std::min<std::size_t>(ThreadsToUse(threads), MaxBatch)))
  , Candidates(MaxBatch)
  , MaxBatchSize(FirstBatch)
  , ReservedBy(data.Buckets.size(), 0)
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
    if (!end.ReportNow(monitor))
    {
      return false;
    }
    this->FillBatch();
    if (this->BatchSize == 0)
    {
      return true;
    }
    this->Team.Run(this->BatchSize, [this](std::size_t i) { this->SearchAt(this->Candidates[i]); });
    this->ChangedBoxes.clear();
    const std::size_t waiting = this->WaitingVertices.size();
    for (std::size_t i = 0; i < this->BatchSize && left > 0 && !end.IsReached(); ++i)
    {
      if (this->Commit(this->Candidates[i]))
      {
        --left;
        if (!end.Report(monitor))
        {
          return false;
        }
      }
    }
    this->ChangeBatchSize(this->ChangedBoxes.size(), this->WaitingVertices.size() - waiting);
  }
  return true;
}

//------------------------------------------------------------------------------
/// Waiting vertices come first.
void BatchSweep::FillBatch()
{
  this->BatchSize = 0;
  ++this->BatchNumber;
  this->RetriedVertices.swap(this->WaitingVertices);
  this->WaitingVertices.clear();
  for (const ListedVertex& listed : this->RetriedVertices)
  {
    this->Take(listed);
  }
  while (this->BatchSize < this->MaxBatchSize &&
    this->WaitingVertices.size() < MaxWaitingBatches * this->MaxBatchSize)
  {
    if (this->NextInList == this->List.size())
    {
      this->MaxBucketOfList = this->Lists.TakeLowest(this->List);
      this->NextInList = 0;
    }
    if (this->List.empty())
    {
      return;
    }
    this->Take({ this->List[this->NextInList++], this->MaxBucketOfList });
  }
}

//------------------------------------------------------------------------------
/// Adds the vertex to the batch or to the waiting vertices, unless its bucket has risen since it
/// was listed.
void BatchSweep::Take(const ListedVertex& listed)
{
  if (this->Data.Buckets[listed.Vertex] > listed.Highest)
  {
    return;
  }
  if (this->BatchSize == this->MaxBatchSize || !this->ReserveRing(listed.Vertex))
  {
    this->WaitingVertices.push_back(listed);
    return;
  }
  this->Candidates[this->BatchSize++].Listed = listed;
}

//------------------------------------------------------------------------------
/// False if the batch contains a vertex of the closed ring already.
bool BatchSweep::ReserveRing(VertexId vertex)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  bool isFree = this->ReservedBy[vertex] != this->BatchNumber;
  mesh.VisitNeighbors(vertex,
    [&](HalfEdgeId, Index other)
    { isFree = isFree && this->ReservedBy[other] != this->BatchNumber; });
  if (isFree)
  {
    this->ReservedBy[vertex] = this->BatchNumber;
    mesh.VisitNeighbors(
      vertex, [this](HalfEdgeId, Index other) { this->ReservedBy[other] = this->BatchNumber; });
  }
  return isFree;
}

//------------------------------------------------------------------------------
/// Runs in parallel for all candidates of a batch.
void BatchSweep::SearchAt(Candidate& candidate) const
{
  candidate.Workspace.Change.Rank = candidate.Listed.Highest;
  candidate.Workspace.Change.Range = this->Task.Vertices;
  candidate.Edges.Gather(
    this->MeshEditor.Mesh(), this->Data, candidate.Listed.Vertex, this->Task.Vertices);
  candidate.Edges.Evaluate(this->Evaluate);
  candidate.SearchResult =
    CollapseSearch(this->MeshEditor, this->Data)
      .Find(candidate.Edges, candidate.Listed.Highest, this->Task, candidate.Workspace);
  if (candidate.SearchResult.Kind == CollapseSearch::Outcome::Accepted)
  {
    this->FindBox(candidate);
  }
}

//------------------------------------------------------------------------------
/// All corners of faces that change are on the ring or ends of the edge.
void BatchSweep::FindBox(Candidate& candidate) const
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  const EdgeNeighborhood& around = candidate.Workspace.Neighborhood;
  Box& box = candidate.ChangedBox;
  box.Low = box.High = candidate.Workspace.Change.Requested.Position;
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
/// Whether the data that the search read is unchanged.
bool BatchSweep::IsUpToDate(Candidate& candidate) const
{
  const Box& own = candidate.ChangedBox;
  const double reach = candidate.Workspace.Change.Reach;
  const auto isApart = [&own, reach](const Box& other) {
    return (other.Low - own.High).maxCoeff() > reach || (own.Low - other.High).maxCoeff() > reach;
  };
  return std::all_of(this->ChangedBoxes.begin(), this->ChangedBoxes.end(), isApart) &&
    this->MeshEditor.StillAccepts(candidate.Workspace);
}

//------------------------------------------------------------------------------
/// Whether an edge was collapsed.
bool BatchSweep::Commit(Candidate& candidate)
{
  const bool isAccepted = candidate.SearchResult.Kind == CollapseSearch::Outcome::Accepted;
  const bool isCollapsed = isAccepted && this->IsUpToDate(candidate);
  if (isCollapsed)
  {
    this->Collapse(candidate);
  }
  else if (isAccepted)
  {
    this->WaitingVertices.push_back(candidate.Listed);
  }
  else
  {
    this->Lists.Reject(
      candidate.Listed.Vertex, candidate.SearchResult.Bucket, candidate.SearchResult.IsLasting);
  }
  this->MeshEditor.Settle(&candidate.Workspace.Counts);
  return isCollapsed;
}

//------------------------------------------------------------------------------
void BatchSweep::Collapse(Candidate& candidate)
{
  const Edit edit = candidate.Workspace.Change.Requested;
  const VertexId gone = this->MeshEditor.Mesh().OtherEnd(edit.Edge, edit.Keep);
  this->MeshEditor.Apply(candidate.Workspace);
  this->Lists.Update(
    edit, gone, candidate.SearchResult.AccumulatedError, candidate.Workspace.Neighborhood);
  this->ChangedBoxes.push_back(candidate.ChangedBox);
}

//------------------------------------------------------------------------------
void BatchSweep::ChangeBatchSize(std::size_t collapses, std::size_t wasted)
{
  if (wasted * CollapsesPerWasted > collapses)
  {
    this->MaxBatchSize = std::max(MinBatch, this->MaxBatchSize / 2);
  }
  else if (wasted * 4 * CollapsesPerWasted <= collapses)
  {
    this->MaxBatchSize = std::min(MaxBatch, this->MaxBatchSize + this->MaxBatchSize / 4);
  }
}
}
