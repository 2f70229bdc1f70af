// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShortLoops.h"

#include "Base/Parallel.h"
#include "Base/WorkspacePool.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <memory>
#include <queue>
#include <tuple>
#include <utility>

namespace bonedecimate
{
namespace
{
/// The search from one seed. Its memory is proportional to the surface, so one object serves many
/// seeds.
class LoopSearch
{
public:
  LoopSearch(const EdgeGraph& graph, std::size_t points, double maxLength)
    : Graph(graph)
    , MaxLength(maxLength)
    , Reached(points)
  {
  }

  void FindFrom(Index seed, std::vector<ShortLoop>& loops)
  {
    ++this->Search;
    this->Closings.clear();
    this->Reach(seed, 0.0, 0, None);
    while (!this->Queue.empty())
    {
      const auto [distance, point] = this->Queue.top();
      this->Queue.pop();
      if (!this->At(point).IsSettled && distance == this->At(point).Distance)
      {
        this->Settle(point);
      }
    }
    for (const Closing& closing : this->Closings)
    {
      loops.push_back(this->LoopOf(closing));
    }
  }

private:
  struct Visit
  {
    double Distance = 0.0; // mm from the seed
    std::uint64_t Signature = 0;
    Index Previous = None;
    std::uint32_t Search = 0; // the search that reached it
    bool IsSettled = false;
  };
  /// An edge that closes a loop.
  struct Closing
  {
    double Length;
    std::uint64_t Signature;
    Index A;
    Index B;
  };

  Visit& At(Index point) { return this->Reached[static_cast<std::size_t>(point)]; }

  void Reach(Index point, double distance, std::uint64_t signature, Index from)
  {
    this->At(point) = { distance, signature, from, this->Search, false };
    this->Queue.emplace(distance, point);
  }

  void Settle(Index point)
  {
    const Visit here = this->At(point);
    this->At(point).IsSettled = true;
    for (const GraphSpoke* spoke = this->Graph.Begin(point); spoke != this->Graph.End(point);
         ++spoke)
    {
      const GraphEdge& edge = this->Graph.Edges()[static_cast<std::size_t>(spoke->Edge)];
      const Visit& there = this->At(spoke->To);
      const bool isReached = there.Search == this->Search;
      const double distance = here.Distance + edge.Length;
      if (isReached && there.IsSettled)
      {
        const std::uint64_t signature = here.Signature ^ there.Signature ^ edge.Signature;
        const double length = distance + there.Distance;
        if (signature != 0 && length <= this->MaxLength)
        {
          this->Keep({ length, signature, point, spoke->To });
        }
      }
      else if (2.0 * distance <= this->MaxLength && (!isReached || distance < there.Distance))
      {
        this->Reach(spoke->To, distance, here.Signature ^ edge.Signature, point);
      }
    }
  }

  void Keep(const Closing& closing)
  {
    const auto same = std::find_if(this->Closings.begin(), this->Closings.end(),
      [&closing](const Closing& kept) { return kept.Signature == closing.Signature; });
    if (same == this->Closings.end() && this->Closings.size() < MaxLoopsOfSeed)
    {
      this->Closings.push_back(closing);
      return;
    }
    Closing& worst = same != this->Closings.end()
      ? *same
      : *std::max_element(this->Closings.begin(), this->Closings.end(),
          [](const Closing& a, const Closing& b) { return a.Length < b.Length; });
    worst = closing.Length < worst.Length ? closing : worst;
  }

  std::vector<Index> PathTo(Index point)
  {
    std::vector<Index> path;
    for (Index at = point; at != None; at = this->At(at).Previous)
    {
      path.push_back(at);
    }
    std::reverse(path.begin(), path.end());
    return path;
  }

  /// The loop without the part that both paths from the seed have in common.
  ShortLoop LoopOf(const Closing& closing)
  {
    const std::vector<Index> a = this->PathTo(closing.A);
    const std::vector<Index> b = this->PathTo(closing.B);
    std::size_t common = 0;
    while (common + 1 < std::min(a.size(), b.size()) && a[common + 1] == b[common + 1])
    {
      ++common;
    }
    std::vector<Index> points(a.begin() + static_cast<std::ptrdiff_t>(common), a.end());
    points.insert(points.end(), b.rbegin(), b.rend() - static_cast<std::ptrdiff_t>(common) - 1);
    std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
    if (points.back() < points[1])
    {
      std::reverse(points.begin() + 1, points.end());
    }
    const double length = this->LengthOf(points);
    return { length, closing.Signature, std::move(points) };
  }

  /// mm; the same bits whatever the seed was.
  double LengthOf(const std::vector<Index>& points) const
  {
    double length = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const Index to = points[(i + 1) % points.size()];
      const GraphSpoke* spoke = std::find_if(this->Graph.Begin(points[i]),
        this->Graph.End(points[i]), [to](const GraphSpoke& each) { return each.To == to; });
      length += this->Graph.Edges()[static_cast<std::size_t>(spoke->Edge)].Length;
    }
    return length;
  }

  const EdgeGraph& Graph;
  double MaxLength; // mm
  std::vector<Visit> Reached;
  std::uint32_t Search = 0;
  using Waiting = std::pair<double, Index>;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> Queue;
  std::vector<Closing> Closings;
};

/// Points that cover all edges with a signature, ascending.
std::vector<Index> SeedsOf(const EdgeGraph& graph, std::size_t points)
{
  std::vector<Index> degree(points, 0); // edges with a signature
  for (const GraphEdge& edge : graph.Edges())
  {
    const Index counted = edge.Signature != 0 ? 1 : 0;
    degree[static_cast<std::size_t>(edge.Ends[0])] += counted;
    degree[static_cast<std::size_t>(edge.Ends[1])] += counted;
  }
  std::vector<bool> isSeed(points, false);
  for (const GraphEdge& edge : graph.Edges())
  {
    const auto a = static_cast<std::size_t>(edge.Ends[0]);
    const auto b = static_cast<std::size_t>(edge.Ends[1]);
    if (edge.Signature != 0 && !isSeed[a] && !isSeed[b])
    {
      isSeed[degree[a] < degree[b] ? b : a] = true;
    }
  }
  std::vector<Index> seeds;
  for (std::size_t p = 0; p < points; ++p)
  {
    if (isSeed[p])
    {
      seeds.push_back(static_cast<Index>(p));
    }
  }
  return seeds;
}

void SortAndMerge(std::vector<ShortLoop>& loops)
{
  std::sort(loops.begin(), loops.end(),
    [](const ShortLoop& a, const ShortLoop& b)
    { return std::tie(a.Length, a.Points) < std::tie(b.Length, b.Points); });
  loops.erase(std::unique(loops.begin(), loops.end(),
                [](const ShortLoop& a, const ShortLoop& b) { return a.Points == b.Points; }),
    loops.end());
}
}

std::vector<ShortLoop> FindShortLoops(
  const EdgeGraph& graph, std::size_t points, double maxLength, int threads, const Monitor& monitor)
{
  const std::vector<Index> seeds = SeedsOf(graph, points);
  std::vector<std::vector<ShortLoop>> found(NumberOfChunks(seeds.size()));
  WorkspacePool<LoopSearch> pool;
  ForEachChunk(seeds.size(), threads, monitor,
    [&](std::size_t chunk, std::size_t first, std::size_t last)
    {
      const auto search =
        pool.Borrow([&] { return std::make_unique<LoopSearch>(graph, points, maxLength); });
      for (std::size_t i = first; i < last; ++i)
      {
        search->FindFrom(seeds[i], found[chunk]);
      }
      SortAndMerge(found[chunk]);
    });
  std::vector<ShortLoop> loops;
  for (std::vector<ShortLoop>& part : found)
  {
    std::move(part.begin(), part.end(), std::back_inserter(loops));
  }
  SortAndMerge(loops);
  return loops;
}
}
