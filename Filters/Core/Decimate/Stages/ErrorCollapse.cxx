// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorCollapse.h"

#include "Base/Parallel.h"

#include <algorithm>
#include <utility>

namespace bonedecimate
{
namespace
{
/// Minimum number of edges to evaluate.
constexpr std::size_t MinEdges = 512;
/// Factor by which the number of edges grows after all were rejected.
constexpr std::size_t MoreEdges = 4;
constexpr Index TargetBlocks = 32;
/// Fewer collapses are not worth blocks.
constexpr std::size_t MinForBlocks = 1024;
}

ErrorCollapse::ErrorCollapse(
  Editor& editor, Samples& samples, OriginalHints& hints, int edgesOfCollapse, int threads)
  : MeshEditor(editor)
  , OriginalSamples(samples)
  , Hints(hints)
  , Errors(editor.Mesh(), samples, hints)
  , EdgesOfCollapse(static_cast<std::size_t>(edgesOfCollapse))
  , Threads(threads)
{
}

//------------------------------------------------------------------------------
bool ErrorCollapse::Run(Index faces, const Monitor& monitor)
{
  constexpr double measuredAt = 0.1;
  constexpr double evaluatedAt = 0.6;
  this->TargetFaces = faces;
  const double blocksAt = this->RemainingCollapses() < MinForBlocks ? evaluatedAt : 0.85;
  if (!this->Errors.MeasureAll(this->Threads, PartOf(monitor, 0.0, measuredAt)))
  {
    return false;
  }
  const HalfEdgeMesh& mesh = this->MeshEditor.Mesh();
  const std::size_t maxEdges = 2 * static_cast<std::size_t>(mesh.NumberOfFaces());
  std::size_t edges = std::max(MinEdges, this->EdgesOfCollapse * this->RemainingCollapses());
  double from = measuredAt; // further rounds report the end
  for (Index before = None; this->RemainingCollapses() > 0; edges *= MoreEdges)
  {
    if (before == mesh.NumberOfFaces() && edges >= maxEdges * MoreEdges)
    {
      break;
    }
    before = mesh.NumberOfFaces();
    if (!this->EvaluateCheapest(edges, PartOf(monitor, from, std::max(from, evaluatedAt))) ||
      !this->CollapseBlocks(
        PartOf(monitor, std::max(from, evaluatedAt), std::max(from, blocksAt))) ||
      !this->CollapseRest(PartOf(monitor, std::max(from, blocksAt), 1.0)))
    {
      return false;
    }
    from = 1.0;
  }
  return true;
}

//------------------------------------------------------------------------------
std::size_t ErrorCollapse::RemainingCollapses() const
{
  const Index tooMany = this->MeshEditor.Mesh().NumberOfFaces() - this->TargetFaces;
  return tooMany > 0 ? static_cast<std::size_t>((tooMany + 1) / 2) : 0;
}

//------------------------------------------------------------------------------
bool ErrorCollapse::EvaluateCheapest(std::size_t count, const Monitor& monitor)
{
  constexpr double foundAt = 0.1;
  std::vector<RatedEdge> edges;
  if (!FindCheapest(
        this->MeshEditor.Mesh(), count, this->Threads, PartOf(monitor, 0.0, foundAt), edges))
  {
    return false;
  }
  this->MaxQuadricCost = edges.empty() ? 0.0F : std::max_element(edges.begin(), edges.end())->Cost;
  this->Edges.resize(edges.size());
  const bool done = ForEachChunk(edges.size(), this->Threads, PartOf(monitor, foundAt, 1.0),
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      ErrorQueue evaluator(this->MeshEditor, this->OriginalSamples, this->Hints, this->Errors, {});
      for (std::size_t i = first; i < last; ++i)
      {
        this->Edges[i].Edge = None;
        evaluator.Evaluate(edges[i], this->Edges[i]);
      }
    });
  this->Edges.erase(std::remove_if(this->Edges.begin(), this->Edges.end(),
                      [](const EvaluatedEdge& edge) { return edge.Edge == None; }),
    this->Edges.end());
  return done;
}

//------------------------------------------------------------------------------
/// The cost with no more than that many edges up to it.
double ErrorCollapse::LimitFor(std::size_t collapses) const
{
  std::vector<double> costs;
  costs.reserve(this->Edges.size());
  for (const EvaluatedEdge& edge : this->Edges)
  {
    costs.push_back(edge.Cost);
  }
  const std::size_t last = std::min(collapses, costs.size()) - 1;
  std::nth_element(costs.begin(), costs.begin() + static_cast<std::ptrdiff_t>(last), costs.end());
  return costs[last];
}

//------------------------------------------------------------------------------
std::vector<ErrorBlock> ErrorCollapse::Blocks(Index size, Index shift) const
{
  const Index slots = this->MeshEditor.Mesh().NumberOfVertexSlots();
  const double limit = this->LimitFor(this->RemainingCollapses());
  std::vector<ErrorBlock> blocks;
  for (Index first = -shift; first < slots; first += size)
  {
    blocks.push_back({ std::max(0, first), std::min(slots, first + size), limit,
      this->MaxQuadricCost, TargetBlocks });
  }
  return blocks;
}

//------------------------------------------------------------------------------
/// Collapses in blocks, then in blocks shifted by half.
bool ErrorCollapse::CollapseBlocks(const Monitor& monitor)
{
  const Index size = this->MeshEditor.Mesh().NumberOfVertexSlots() / TargetBlocks + 2;
  bool shouldContinue = true;
  for (const bool again : { false, true })
  {
    if (shouldContinue && this->RemainingCollapses() >= MinForBlocks && !this->Edges.empty())
    {
      shouldContinue = this->CollapseRound(
        size, again ? size / 2 : 0, again ? PartOf(monitor, 0.7, 1.0) : PartOf(monitor, 0.0, 0.7));
    }
  }
  return shouldContinue;
}

//------------------------------------------------------------------------------
bool ErrorCollapse::CollapseRound(Index size, Index shift, const Monitor& monitor)
{
  const std::vector<ErrorBlock> blocks = this->Blocks(size, shift);
  std::vector<std::vector<EvaluatedEdge>> edges(blocks.size());
  std::vector<EvaluatedEdge> left;
  for (const EvaluatedEdge& edge : this->Edges)
  {
    const std::size_t block = static_cast<std::size_t>((edge.Start + shift) / size);
    const bool isInside = blocks[block].Contains(edge.End) && edge.Cost <= blocks[block].Limit;
    (isInside ? edges[block] : left).push_back(edge);
  }
  std::vector<Tally> counted(blocks.size());
  const bool done = ForEachPart(blocks.size(), this->Threads, monitor,
    [&](std::size_t i)
    {
      ErrorQueue queue(
        this->MeshEditor, this->OriginalSamples, this->Hints, this->Errors, blocks[i]);
      for (const EvaluatedEdge& edge : edges[i])
      {
        queue.Add(edge);
      }
      const std::int64_t allowed = static_cast<std::int64_t>(edges[i].size());
      queue.Run([&](std::int64_t collapses) { return collapses < allowed; });
      counted[i] = std::exchange(queue.Counts(), {});
      edges[i] = queue.RemainingEdges();
    });
  this->MeshEditor.Settle(counted.data(), counted.size());
  for (const std::vector<EvaluatedEdge>& rest : edges)
  {
    left.insert(left.end(), rest.begin(), rest.end());
  }
  this->Edges = std::move(left);
  return done;
}

//------------------------------------------------------------------------------
bool ErrorCollapse::CollapseRest(const Monitor& monitor)
{
  constexpr std::size_t edgesPerReport = 8;
  ErrorBlock whole;
  whole.MaxQuadricCost = this->MaxQuadricCost;
  ErrorQueue queue(this->MeshEditor, this->OriginalSamples, this->Hints, this->Errors, whole);
  for (const EvaluatedEdge& edge : this->Edges)
  {
    queue.Add(edge);
  }
  const double first = static_cast<double>(std::max<std::size_t>(1, this->RemainingCollapses()));
  bool shouldContinue = true;
  std::size_t turn = 0;
  queue.Run(
    [&](std::int64_t)
    {
      this->MeshEditor.Settle(&queue.Counts());
      const double left = static_cast<double>(this->RemainingCollapses());
      shouldContinue = ++turn % edgesPerReport != 0 || monitor(1.0 - left / first);
      return shouldContinue && left > 0.0;
    });
  this->MeshEditor.Settle(&queue.Counts());
  return shouldContinue;
}
}
