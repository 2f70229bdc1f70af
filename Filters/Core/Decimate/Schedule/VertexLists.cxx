// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VertexLists.h"

namespace bonedecimate
{
/// The last vertex first, since lists are read backwards.
void VertexLists::Fill(const BlockTask& task)
{
  constexpr Index step =
    32; // counted together: in later rounds most have no vertex below the limit
  this->Task = task;
  this->Lists.Clear();
  const CostBucket* buckets = this->Known.Buckets.data();
  for (Index end = task.Vertices.Last; end > task.Vertices.First; end -= step)
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
    this->Known.NoteRejection(vertex);
  }
  this->SetBucket(vertex, bucket);
}

//------------------------------------------------------------------------------
void VertexLists::SetBucket(VertexId vertex, CostBucket bucket)
{
  this->Known.Buckets[vertex] = bucket;
  if (bucket <= this->Task.Limit)
  {
    this->Lists.Add(vertex, bucket);
  }
}

//------------------------------------------------------------------------------
void VertexLists::Renew(VertexId vertex, VertexRange within)
{
  this->Edges.Gather(this->Mesh, this->Known, vertex, within);
  this->Edges.Evaluate(this->Evaluate);
  this->SetBucket(vertex, BucketOf(this->Edges.MinCost()));
}

//------------------------------------------------------------------------------
void VertexLists::Update(
  const Edit& edit, VertexId gone, double accumulatedError, const EdgeNeighborhood& around)
{
  this->Known.AccumulatedErrors[edit.Keep] = static_cast<float>(accumulatedError);
  this->Known.Buckets[gone] = NeverBucket;
  this->Renew(edit.Keep, this->Task.Vertices);
  this->Known.NoteChange(around.Ring);
  this->Known.NoteChange({ edit.Keep });
  if (this->Task.RenewsRing)
  {
    this->Mesh.VisitEdges(edit.Keep,
      [&](HalfEdgeId h)
      {
        const VertexId other = this->Mesh.Across(h, edit.Keep);
        if (!this->Mesh.IsConstrained(other))
        {
          this->Renew(other, this->Task.Vertices);
        }
      });
  }
}
}
