// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VertexEdges.h"

#include "Base/Prefetch.h"
#include "Mesh/Edit.h"

#include <algorithm>
#include <limits>

namespace bonedecimate
{
namespace
{
constexpr float Never = std::numeric_limits<float>::infinity();
/// An edge of a vertex with more has more than MaxFacesOfEdit: such a vertex has no edge to collapse.
constexpr std::size_t MaxBatches = MaxFacesOfEdit / EdgeBatch::Size + 1;
}

//------------------------------------------------------------------------------
void VertexEdges::Gather(
  const HalfEdgeMesh& mesh, const VertexBuckets& known, VertexId vertex, VertexRange block)
{
  const VertexConstraint kind = mesh.Constraint(vertex);
  const float* errors = known.AccumulatedErrors.data();
  const float error = errors[vertex];
  this->Middle = vertex;
  this->Used = 0;
  bool inside = true;
  Batch* batch = nullptr;
  int at = EdgeBatch::Size;
  mesh.VisitNeighbors(vertex,
    [&](HalfEdgeId h, Index other)
    {
      inside = inside && block.Contains(other);
      if (!inside || this->Used > MaxBatches)
      {
        return false; // The vertices that follow may be changing just now.
      }
      if (at == EdgeBatch::Size)
      {
        batch = &this->Begin(this->Used++, mesh, known.CostFactor);
        batch->Requested.First = &mesh.Record(vertex);
        at = 0;
      }
      const VertexRecord* record = &mesh.Record(other);
      Prefetch(record);
      EdgeBatch& requested = batch->Requested;
      requested.Others[at] = record;
      requested.Freedoms[at] =
        static_cast<std::int32_t>(FreedomOf(kind, mesh.Constraint(other), mesh.Twin(h) == None));
      requested.AccumulatedErrors[at] = std::max(error, errors[other]);
      batch->Edges[at] = h;
      requested.Count = ++at;
      return true;
    });
  this->Used = this->Used > MaxBatches ? 0 : this->Used;
  this->Inside = inside;
}

//------------------------------------------------------------------------------
VertexEdges::Batch& VertexEdges::Begin(
  std::size_t batch, const HalfEdgeMesh& mesh, float costFactor)
{
  if (batch == this->Batches.size())
  {
    this->Batches.emplace_back();
  }
  EdgeBatch& requested = this->Batches[batch].Requested;
  requested.Count = 0;
  std::fill_n(requested.Freedoms, EdgeBatch::Size, static_cast<std::int32_t>(Freedom::Nowhere));
  requested.PerUnit = 1.0 / mesh.Unit();
  requested.CostFactor = costFactor;
  return this->Batches[batch];
}

//------------------------------------------------------------------------------
void VertexEdges::Evaluate(const EdgeEvaluator& evaluate)
{
  for (std::size_t i = 0; i < this->Used; ++i)
  {
    evaluate(this->Batches[i].Requested, this->Batches[i].Results);
  }
}

//------------------------------------------------------------------------------
float VertexEdges::MinCost() const
{
  float least = Never;
  for (std::size_t i = 0; i < this->Used; ++i)
  {
    least = std::min(least, this->Batches[i].Results.Least);
  }
  return least;
}

//------------------------------------------------------------------------------
VertexEdges::Candidate VertexEdges::TakeCheapest()
{
  const float least = this->MinCost();
  Candidate taken;
  for (std::size_t i = 0; i < this->Used && least < Never; ++i)
  {
    EdgeResults& results = this->Batches[i].Results;
    float* at = std::find(results.Costs, results.Costs + EdgeBatch::Size, least);
    if (at != results.Costs + EdgeBatch::Size)
    {
      const std::ptrdiff_t lane = at - results.Costs;
      taken.Edge = this->Batches[i].Edges[lane];
      for (int k = 0; k < 3; ++k)
      {
        taken.Move[k] = results.Moves[k][lane];
      }
      *at = Never;
      results.Least = Never;
      for (const float cost : results.Costs)
      {
        results.Least = std::min(results.Least, cost);
      }
      break;
    }
  }
  return taken;
}
}
