// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VertexEdges.h"

#include "Memory/Prefetch.h"

#include <algorithm>
#include <limits>

namespace bonedecimate
{
namespace
{
constexpr float Never = std::numeric_limits<float>::infinity();

/// An open border moves only along itself; what is pinned stays.
Freedom FreedomOf(VertexKind first, VertexKind second, bool isBorderEdge)
{
  const bool leavesBorder = first != VertexKind::Inside && second != VertexKind::Inside;
  if (second >= VertexKind::Locked || (leavesBorder && !isBorderEdge))
  {
    return Freedom::Nowhere;
  }
  if (first == second)
  {
    return first == VertexKind::Inside ? Freedom::Space
      : first == VertexKind::Border    ? Freedom::Edge
                                       : Freedom::Nowhere;
  }
  return first > second ? Freedom::First : Freedom::Second;
}
}

//------------------------------------------------------------------------------
void VertexEdges::Gather(
  const HalfEdgeMesh& mesh, const VertexKeys& known, Index vertex, VertexRange block)
{
  const VertexKind kind = mesh.Kind(vertex);
  const float* memories = known.Memories.data();
  const float memory = memories[vertex];
  this->Middle = vertex;
  this->Used = 0;
  bool inside = true;
  Batch* batch = nullptr;
  int at = EdgeBatch::Size;
  mesh.VisitNeighbours(vertex,
    [&](Index h, Index other)
    {
      inside = inside && block.Contains(other);
      if (!inside)
      {
        return; // It may be changing just now.
      }
      if (at == EdgeBatch::Size)
      {
        batch = &this->Begin(this->Used++, mesh, known.CostFactor);
        batch->Asked.First = &mesh.Record(vertex);
        at = 0;
      }
      const VertexRecord* record = &mesh.Record(other);
      Prefetch(record);
      EdgeBatch& asked = batch->Asked;
      asked.Others[at] = record;
      asked.Freedoms[at] =
        static_cast<std::int32_t>(FreedomOf(kind, mesh.Kind(other), mesh.Twin(h) == None));
      asked.Memories[at] = std::max(memory, memories[other]);
      batch->Edges[at] = h;
      asked.Count = ++at;
    });
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
  EdgeBatch& asked = this->Batches[batch].Asked;
  asked.Count = 0;
  std::fill_n(asked.Freedoms, EdgeBatch::Size, static_cast<std::int32_t>(Freedom::Nowhere));
  asked.PerUnit = 1.0 / mesh.Unit();
  asked.CostFactor = costFactor;
  return this->Batches[batch];
}

//------------------------------------------------------------------------------
void VertexEdges::Judge(const Kernels& kernels)
{
  for (std::size_t i = 0; i < this->Used; ++i)
  {
    kernels.JudgeEdges(this->Batches[i].Asked, this->Batches[i].Answers);
  }
}

//------------------------------------------------------------------------------
float VertexEdges::LeastCost() const
{
  float least = Never;
  for (std::size_t i = 0; i < this->Used; ++i)
  {
    least = std::min(least, this->Batches[i].Answers.Least);
  }
  return least;
}

//------------------------------------------------------------------------------
VertexEdges::Candidate VertexEdges::TakeCheapest()
{
  const float least = this->LeastCost();
  Candidate taken;
  for (std::size_t i = 0; i < this->Used && least < Never; ++i)
  {
    EdgeAnswers& answers = this->Batches[i].Answers;
    float* at = std::find(answers.Costs, answers.Costs + EdgeBatch::Size, least);
    if (at != answers.Costs + EdgeBatch::Size)
    {
      const std::ptrdiff_t lane = at - answers.Costs;
      taken.Edge = this->Batches[i].Edges[lane];
      for (int k = 0; k < 3; ++k)
      {
        taken.Move[k] = answers.Moves[k][lane];
      }
      *at = Never;
      answers.Least = *std::min_element(answers.Costs, answers.Costs + EdgeBatch::Size);
      break;
    }
  }
  return taken;
}
}
