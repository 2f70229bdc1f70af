// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeOrder.h"

#include "Base/Parallel.h"
#include "Mesh/EdgeNeighborhood.h"

#include <algorithm>
#include <limits>

namespace bonedecimate
{
namespace
{
bool MayRate(const HalfEdgeMesh& mesh, VertexId vertex)
{
  return mesh.Outgoing(vertex) != None && mesh.MovesFreely(vertex);
}

/// Evaluates the edges of the batch and empties it.
void Evaluate(const HalfEdgeMesh& mesh, VertexId vertex, EdgeBatch& batch, const Index* halfEdges,
  std::vector<RatedEdge>& edges)
{
  EdgeResults results;
  BestKernels().EvaluateEdges(batch, results);
  for (int i = 0; i < batch.Count; ++i)
  {
    if (results.Costs[i] < std::numeric_limits<float>::infinity())
    {
      const Vector3 move(results.Moves[0][i], results.Moves[1][i], results.Moves[2][i]);
      edges.push_back(
        { results.Costs[i], halfEdges[i], mesh.Position(vertex) + mesh.Unit() * move });
    }
  }
  batch.Count = 0;
}
}

void RateEdges(
  const HalfEdgeMesh& mesh, VertexId vertex, bool isOneWay, std::vector<RatedEdge>& edges)
{
  EdgeBatch batch;
  std::array<Index, EdgeBatch::Size> halfEdges{};
  batch.First = &mesh.Record(vertex);
  batch.PerUnit = 1.0 / mesh.Unit();
  for (const HalfEdgeId h : mesh.OutgoingOf(vertex))
  {
    const VertexId other = mesh.Target(h);
    if (!MayRate(mesh, other) || (isOneWay && other < vertex))
    {
      continue;
    }
    batch.Others[batch.Count] = &mesh.Record(other);
    batch.Freedoms[batch.Count] = static_cast<std::int32_t>(Freedom::Space);
    halfEdges[static_cast<std::size_t>(batch.Count++)] = h;
    if (batch.Count == EdgeBatch::Size)
    {
      Evaluate(mesh, vertex, batch, halfEdges.data(), edges);
    }
  }
  if (batch.Count > 0)
  {
    Evaluate(mesh, vertex, batch, halfEdges.data(), edges);
  }
}

//------------------------------------------------------------------------------
bool FindCheapest(const HalfEdgeMesh& mesh, std::size_t count, int threads, const Monitor& monitor,
  std::vector<RatedEdge>& edges)
{
  const std::size_t vertices = static_cast<std::size_t>(mesh.NumberOfVertexSlots());
  std::vector<std::vector<RatedEdge>> parts(NumberOfChunks(vertices));
  const bool done = ForEachChunk(vertices, threads, monitor,
    [&](std::size_t chunk, std::size_t first, std::size_t last)
    {
      for (VertexId v = static_cast<Index>(first); v < static_cast<Index>(last); ++v)
      {
        if (MayRate(mesh, v) && !IsHub(mesh, v))
        {
          RateEdges(mesh, v, true, parts[chunk]);
        }
      }
    });
  edges.clear();
  for (const std::vector<RatedEdge>& part : parts)
  {
    edges.insert(edges.end(), part.begin(), part.end());
  }
  if (edges.size() > count)
  {
    std::nth_element(
      edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(count), edges.end());
    edges.resize(count);
  }
  return done;
}
}
