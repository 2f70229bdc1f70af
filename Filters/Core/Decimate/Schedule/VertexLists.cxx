// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VertexLists.h"

namespace bonedecimate
{
/// Adds the last vertex first, because lists are read backwards.
void VertexLists::Fill(const BlockTask& task)
{
  // Counts blocks of vertices, because in later rounds most blocks have no vertex below the limit.
  constexpr Index step = 32;
  this->Task = task;
  this->Lists.Clear();
  const CostBucket* buckets = this->Data.Buckets.data();
  for (Index end = task.Vertices.End; end > task.Vertices.First; end -= step)
  {
    const Index first = std::max(task.Vertices.First, end - step);
    const bool hasAny = CountUpTo(task.Limit, buckets + first, buckets + end) > 0;
    for (Index v = end; hasAny && v-- > first;)
    {
      if (buckets[v] <= task.Limit)
      {
        this->Lists.Add(v, buckets[v]);
      }
    }
  }
}

//------------------------------------------------------------------------------
void VertexLists::Reject(VertexId vertex, CostBucket bucket, bool isLasting)
{
  if (isLasting)
  {
    this->Data.NoteRejection(vertex);
  }
  this->SetBucket(vertex, bucket);
}

//------------------------------------------------------------------------------
void VertexLists::SetBucket(VertexId vertex, CostBucket bucket)
{
  this->Data.Buckets[vertex] = bucket;
  if (bucket <= this->Task.Limit)
  {
    this->Lists.Add(vertex, bucket);
  }
}

//------------------------------------------------------------------------------
void VertexLists::Renew(VertexId vertex, VertexRange within)
{
  this->Edges.Gather(this->Mesh, this->Data, vertex, within);
  this->Edges.Evaluate(this->Evaluate);
  this->SetBucket(vertex, BucketOf(this->Edges.MinCost()));
}

//------------------------------------------------------------------------------
void VertexLists::Update(
  const Edit& edit, VertexId gone, double accumulatedError, const EdgeNeighborhood& around)
{
  this->Data.AccumulatedErrors[edit.Keep] = static_cast<float>(accumulatedError);
  this->Data.Buckets[gone] = NeverBucket;
  this->Renew(edit.Keep, this->Task.Vertices);
  this->Data.NoteChange(around.Ring);
  this->Data.NoteChange({ edit.Keep });
  if (this->Task.RenewsRing)
  {
    this->Mesh.VisitEdges(edit.Keep,
      [&](HalfEdgeId h)
      {
        const VertexId other = this->Mesh.OtherEnd(h, edit.Keep);
        if (!this->Mesh.IsConstrained(other))
        {
          this->Renew(other, this->Task.Vertices);
        }
      });
  }
}
}
