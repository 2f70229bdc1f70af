// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockSweep.h"

#include "Base/Prefetch.h"

#include <algorithm>

namespace bonedecimate
{
void BlockSweep::RenewAll(Index first, Index last)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  for (VertexId v = first; v < last; ++v)
  {
    if (mesh.Outgoing(v) != None && !mesh.IsConstrained(v) && this->Data.TakeChange(v))
    {
      this->Lists.Renew(v, {});
    }
  }
}

//------------------------------------------------------------------------------
/// Prefetches the rings of the next vertices of the list before Gather reads them, one face of each
/// at a time, so that memory latency overlaps with computation.
void BlockSweep::LookAhead(std::size_t at)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  const std::size_t size = this->List.size();
  if (at + PrefetchDistance < size)
  {
    Prefetch(&mesh.Record(this->List[at + PrefetchDistance]));
  }
  if (at + PrefetchDistance - 1 < size)
  {
    Index& cursor = this->Cursors[(at + PrefetchDistance - 1) % PrefetchDistance];
    cursor = mesh.Outgoing(this->List[at + PrefetchDistance - 1]);
    Prefetch(mesh.RecordOfFace(std::max(0, cursor)));
  }
  for (std::size_t i = at + 2; i < std::min(at + PrefetchDistance - 1, size); ++i)
  {
    Index& cursor = this->Cursors[i % PrefetchDistance];
    if (cursor != None && mesh.Origin(cursor) == this->List[i])
    {
      Prefetch(&mesh.Record(mesh.Target(cursor)));
      cursor = mesh.Twin(HalfEdgeMesh::Previous(cursor));
      Prefetch(mesh.RecordOfFace(std::max(0, cursor)));
    }
  }
}

//------------------------------------------------------------------------------
/// The evaluated edges of the vertex at this position of the list. The edges of the next vertex are
/// gathered first, so that their data is prefetched meanwhile.
VertexEdges& BlockSweep::EvaluatedEdges(std::size_t at, CostBucket highest)
{
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  VertexEdges& edges = this->GatheredEdges[at % 2];
  if (edges.Vertex() != this->List[at])
  {
    edges.Gather(mesh, this->Data, this->List[at], this->Task.Vertices);
  }
  if (at + 1 < this->List.size() && this->Data.Buckets[this->List[at + 1]] <= highest)
  {
    this->GatheredEdges[(at + 1) % 2].Gather(
      mesh, this->Data, this->List[at + 1], this->Task.Vertices);
  }
  if (edges.AreInside())
  {
    edges.Evaluate(this->Evaluate);
  }
  return edges;
}

//------------------------------------------------------------------------------
/// Whether an edge of the vertex was collapsed.
bool BlockSweep::CollapseAt(VertexEdges& edges, CostBucket highest)
{
  const VertexId vertex = edges.Vertex();
  const CollapseSearch::Result found =
    this->Search.Find(edges, highest, this->Task, this->Workspace);
  if (found.Kind == CollapseSearch::Outcome::Accepted)
  {
    const Edit edit = this->Workspace.Change.Requested;
    const VertexId gone = this->MeshEditor.Mesh().OtherEnd(edit.Edge, edit.Keep);
    this->MeshEditor.Apply(this->Workspace);
    this->ForgetChanged();
    this->Lists.Update(edit, gone, found.AccumulatedError, this->Workspace.Neighborhood);
  }
  else if (found.Kind == CollapseSearch::Outcome::Deferred)
  {
    this->Defer(vertex);
  }
  else
  {
    this->Lists.Reject(vertex, found.Bucket, found.IsLasting);
  }
  return found.Kind == CollapseSearch::Outcome::Accepted;
}

//------------------------------------------------------------------------------
/// Discards gathered edges near the collapse, because one of them may be gone.
void BlockSweep::ForgetChanged()
{
  const EdgeNeighborhood& around = this->Workspace.Neighborhood;
  for (VertexEdges& edges : this->GatheredEdges)
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
  this->DeferredVertices.push_back({ vertex, this->Data.Buckets[vertex] });
  this->Data.Buckets[vertex] = NeverBucket;
}

//------------------------------------------------------------------------------
/// Gives deferred vertices that still exist their bucket back.
void BlockSweep::Restore()
{
  for (const OldBucket& old : this->DeferredVertices)
  {
    const bool isThere = this->MeshEditor.Mesh().Outgoing(old.Vertex) != None;
    if (isThere && this->Data.Buckets[old.Vertex] == NeverBucket)
    {
      this->Data.Buckets[old.Vertex] = old.Bucket;
    }
  }
  this->DeferredVertices.clear();
}
}
