// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorCollapse.h"

#include "Parallel.h"

#include <algorithm>
#include <utility>

namespace bonedecimate
{
namespace
{
/// Judged at least.
constexpr std::size_t LeastEdges = 512;
/// If the gate refused them all, that many times more the next time.
constexpr std::size_t MoreEdges = 4;
constexpr Index BlocksWanted = 32;
/// Fewer collapses than that are not worth blocks.
constexpr std::size_t LeastForBlocks = 1024;
}

ErrorCollapse::ErrorCollapse(
  Editor& editor, Samples& samples, BackHints& hints, int edgesOfCollapse, int threads)
  : Work(editor)
  , Fit(samples)
  , Back(hints)
  , Errors(editor.Mesh(), samples, hints)
  , EdgesOfCollapse(static_cast<std::size_t>(edgesOfCollapse))
  , Threads(threads)
{
}

//------------------------------------------------------------------------------
bool ErrorCollapse::Run(Index faces, const Monitor& monitor)
{
  constexpr double measuredAt = 0.1;
  constexpr double judgedAt = 0.6;
  this->Wanted = faces;
  const double blocksAt = this->CollapsesWanted() < LeastForBlocks ? judgedAt : 0.85;
  if (!this->Errors.MeasureAll(this->Threads, PartOf(monitor, 0.0, measuredAt)))
  {
    return false;
  }
  const HalfEdgeMesh& mesh = this->Work.Mesh();
  const std::size_t mostEdges = 2 * static_cast<std::size_t>(mesh.NumberOfFaces());
  std::size_t edges = std::max(LeastEdges, this->EdgesOfCollapse * this->CollapsesWanted());
  double from = measuredAt; // what comes again is told as the end
  for (Index before = None; this->CollapsesWanted() > 0; edges *= MoreEdges)
  {
    if (before == mesh.NumberOfFaces() && edges >= mostEdges * MoreEdges)
    {
      break;
    }
    before = mesh.NumberOfFaces();
    if (!this->JudgeCheapest(edges, PartOf(monitor, from, std::max(from, judgedAt))) ||
      !this->CollapseBlocks(PartOf(monitor, std::max(from, judgedAt), std::max(from, blocksAt))) ||
      !this->CollapseRest(PartOf(monitor, std::max(from, blocksAt), 1.0)))
    {
      return false;
    }
    from = 1.0;
  }
  return true;
}

//------------------------------------------------------------------------------
std::size_t ErrorCollapse::CollapsesWanted() const
{
  const Index tooMany = this->Work.Mesh().NumberOfFaces() - this->Wanted;
  return tooMany > 0 ? static_cast<std::size_t>((tooMany + 1) / 2) : 0;
}

//------------------------------------------------------------------------------
bool ErrorCollapse::JudgeCheapest(std::size_t count, const Monitor& monitor)
{
  constexpr double foundAt = 0.1;
  std::vector<RatedEdge> edges;
  if (!FindCheapest(this->Work.Mesh(), count, this->Threads, PartOf(monitor, 0.0, foundAt), edges))
  {
    return false;
  }
  this->Dearest = edges.empty() ? 0.0F : std::max_element(edges.begin(), edges.end())->Cost;
  this->Edges.resize(edges.size());
  const bool done = ForEachChunk(edges.size(), this->Threads, PartOf(monitor, foundAt, 1.0),
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      ErrorQueue judge(this->Work, this->Fit, this->Back, this->Errors, {});
      for (std::size_t i = first; i < last; ++i)
      {
        this->Edges[i].Edge = None;
        judge.Judge(edges[i], this->Edges[i]);
      }
    });
  this->Edges.erase(std::remove_if(this->Edges.begin(), this->Edges.end(),
                      [](const JudgedEdge& edge) { return edge.Edge == None; }),
    this->Edges.end());
  return done;
}

//------------------------------------------------------------------------------
/// The cost that no more than that many edges stay below or at.
double ErrorCollapse::LimitFor(std::size_t collapses) const
{
  std::vector<double> costs;
  costs.reserve(this->Edges.size());
  for (const JudgedEdge& edge : this->Edges)
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
  const Index slots = this->Work.Mesh().NumberOfVertexSlots();
  const double limit = this->LimitFor(this->CollapsesWanted());
  std::vector<ErrorBlock> blocks;
  for (Index first = -shift; first < slots; first += size)
  {
    blocks.push_back(
      { std::max(0, first), std::min(slots, first + size), limit, this->Dearest, BlocksWanted });
  }
  return blocks;
}

//------------------------------------------------------------------------------
/// Twice, the second time with blocks shifted by half of one.
bool ErrorCollapse::CollapseBlocks(const Monitor& monitor)
{
  const Index size = this->Work.Mesh().NumberOfVertexSlots() / BlocksWanted + 2;
  bool goesOn = true;
  for (const bool again : { false, true })
  {
    if (goesOn && this->CollapsesWanted() >= LeastForBlocks && !this->Edges.empty())
    {
      goesOn = this->CollapseRound(
        size, again ? size / 2 : 0, again ? PartOf(monitor, 0.7, 1.0) : PartOf(monitor, 0.0, 0.7));
    }
  }
  return goesOn;
}

//------------------------------------------------------------------------------
bool ErrorCollapse::CollapseRound(Index size, Index shift, const Monitor& monitor)
{
  const std::vector<ErrorBlock> blocks = this->Blocks(size, shift);
  std::vector<std::vector<JudgedEdge>> edges(blocks.size());
  std::vector<JudgedEdge> left;
  for (const JudgedEdge& edge : this->Edges)
  {
    const std::size_t block = static_cast<std::size_t>((edge.Start + shift) / size);
    const bool isInside = blocks[block].Holds(edge.End) && edge.Cost <= blocks[block].Limit;
    (isInside ? edges[block] : left).push_back(edge);
  }
  std::vector<Tally> counted(blocks.size());
  const bool done = ForEachPart(blocks.size(), this->Threads, monitor,
    [&](std::size_t i)
    {
      ErrorQueue queue(this->Work, this->Fit, this->Back, this->Errors, blocks[i]);
      for (const JudgedEdge& edge : edges[i])
      {
        queue.Add(edge);
      }
      const std::int64_t allowed = static_cast<std::int64_t>(edges[i].size());
      queue.Run([&](std::int64_t collapses) { return collapses < allowed; });
      counted[i] = std::exchange(queue.Counted(), {});
      edges[i] = queue.LeftOver();
    });
  this->Work.Settle(counted);
  for (const std::vector<JudgedEdge>& rest : edges)
  {
    left.insert(left.end(), rest.begin(), rest.end());
  }
  this->Edges = std::move(left);
  return done;
}

//------------------------------------------------------------------------------
bool ErrorCollapse::CollapseRest(const Monitor& monitor)
{
  constexpr std::size_t tellEvery = 8; // edges
  ErrorBlock whole;
  whole.Dearest = this->Dearest;
  ErrorQueue queue(this->Work, this->Fit, this->Back, this->Errors, whole);
  for (const JudgedEdge& edge : this->Edges)
  {
    queue.Add(edge);
  }
  const double first = static_cast<double>(std::max<std::size_t>(1, this->CollapsesWanted()));
  bool goesOn = true;
  std::size_t turn = 0;
  queue.Run(
    [&](std::int64_t)
    {
      this->Work.Settle(queue.Counted());
      const double left = static_cast<double>(this->CollapsesWanted());
      goesOn = ++turn % tellEvery != 0 || monitor(1.0 - left / first);
      return goesOn && left > 0.0;
    });
  this->Work.Settle(queue.Counted());
  return goesOn;
}
}
