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
    if (mesh.Outgoing(v) != None && !mesh.IsConstrained(v) && this->Known.TakeChange(v))
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
/// The evaluated edges of the vertex at that position of the list. Those of the next vertex are
/// gathered first, so that their data is prefetched meanwhile.
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
/// Whether an edge of the vertex was collapsed.
bool BlockSweep::CollapseAt(VertexEdges& edges, CostBucket highest)
{
  const VertexId vertex = edges.Vertex();
  const CollapseSearch::Result found = this->Search.Find(edges, highest, this->Task, this->Space);
  if (found.Of == CollapseSearch::Outcome::Accepted)
  {
    const Edit edit = this->Space.Change.Requested;
    const VertexId gone = this->MeshEditor.Mesh().Across(edit.Edge, edit.Keep);
    this->MeshEditor.Apply(this->Space);
    this->ForgetChanged();
    this->Lists.Update(edit, gone, found.AccumulatedError, this->Space.Around);
  }
  else if (found.Of == CollapseSearch::Outcome::Deferred)
  {
    this->Defer(vertex);
  }
  else
  {
    this->Lists.Reject(vertex, found.Bucket, found.IsLasting);
  }
  return found.Of == CollapseSearch::Outcome::Accepted;
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
