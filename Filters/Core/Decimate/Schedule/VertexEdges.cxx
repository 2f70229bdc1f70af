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
/// A vertex with more batches has more than MaxFacesOfEdit faces and no edge to collapse.
constexpr std::size_t MaxBatches = MaxFacesOfEdit / EdgeBatch::Size + 1;
}

//------------------------------------------------------------------------------
void VertexEdges::Gather(
  const HalfEdgeMesh& mesh, const SweepData& data, VertexId vertex, VertexRange block)
{
  const VertexConstraint constraint = mesh.Constraint(vertex);
  const float* errors = data.AccumulatedErrors.data();
  const float error = errors[vertex];
  this->Center = vertex;
  this->UsedBatches = 0;
  bool inside = true;
  Batch* batch = nullptr;
  int at = EdgeBatch::Size;
  mesh.VisitNeighbors(vertex,
    [&](HalfEdgeId h, Index other)
    {
      inside = inside && block.Contains(other);
      if (!inside || this->UsedBatches > MaxBatches)
      {
        return false; // other workers may be changing the next vertices
      }
      if (at == EdgeBatch::Size)
      {
        batch = &this->BeginBatch(this->UsedBatches++, mesh, data.CostFactor);
        batch->Input.First = &mesh.Record(vertex);
        at = 0;
      }
      const VertexRecord* record = &mesh.Record(other);
      Prefetch(record);
      EdgeBatch& input = batch->Input;
      input.Others[at] = record;
      input.Freedoms[at] = static_cast<std::int32_t>(
        FreedomOf(constraint, mesh.Constraint(other), mesh.Twin(h) == None));
      input.AccumulatedErrors[at] = std::max(error, errors[other]);
      batch->Edges[at] = h;
      input.Count = ++at;
      return true;
    });
  this->UsedBatches = this->UsedBatches > MaxBatches ? 0 : this->UsedBatches;
  this->IsInside = inside;
}

//------------------------------------------------------------------------------
VertexEdges::Batch& VertexEdges::BeginBatch(
  std::size_t batch, const HalfEdgeMesh& mesh, float costFactor)
{
  if (batch == this->Batches.size())
  {
    this->Batches.emplace_back();
  }
  EdgeBatch& input = this->Batches[batch].Input;
  input.Count = 0;
  std::fill_n(input.Freedoms, EdgeBatch::Size, static_cast<std::int32_t>(Freedom::Nowhere));
  input.PerUnit = 1.0 / mesh.Unit();
  input.CostFactor = costFactor;
  return this->Batches[batch];
}

//------------------------------------------------------------------------------
void VertexEdges::Evaluate(const EdgeEvaluator& evaluate)
{
  for (std::size_t i = 0; i < this->UsedBatches; ++i)
  {
    evaluate(this->Batches[i].Input, this->Batches[i].Results);
  }
}

//------------------------------------------------------------------------------
float VertexEdges::MinCost() const
{
  float least = Never;
  for (std::size_t i = 0; i < this->UsedBatches; ++i)
  {
    least = std::min(least, this->Batches[i].Results.MinCost);
  }
  return least;
}

//------------------------------------------------------------------------------
VertexEdges::Candidate VertexEdges::TakeCheapest()
{
  const float least = this->MinCost();
  Candidate taken;
  for (std::size_t i = 0; i < this->UsedBatches && least < Never; ++i)
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
      results.MinCost = Never;
      for (const float cost : results.Costs)
      {
        results.MinCost = std::min(results.MinCost, cost);
      }
      break;
    }
  }
  return taken;
}
}
