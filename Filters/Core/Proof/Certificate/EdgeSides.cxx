// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeSides.h"

#include "Base/Parallel.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <numeric>

namespace bonedecimate::certificate
{
namespace
{
/// A hash of the coordinates; the same for both zeros.
std::uint64_t HashOf(const Vector3& p)
{
  std::uint64_t hash = 0;
  for (const double coordinate : { p.x() + 0.0, p.y() + 0.0, p.z() + 0.0 })
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &coordinate, sizeof(bits));
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15U; // 2^64 / golden ratio
    hash ^= hash >> 32;
  }
  return hash;
}

/// For each point the least id of the points with the same coordinates.
std::vector<Index> FirstPointAtEachPosition(const std::vector<Vector3>& points)
{
  std::size_t size = 1;
  while (size < 2 * points.size())
  {
    size *= 2;
  }
  std::vector<Index> table(size, None);
  std::vector<Index> same(points.size());
  for (std::size_t point = 0; point < points.size(); ++point)
  {
    std::size_t at = HashOf(points[point]) & (size - 1);
    while (table[at] != None && points[table[at]] != points[point])
    {
      at = (at + 1) & (size - 1);
    }
    table[at] = table[at] != None ? table[at] : static_cast<Index>(point);
    same[point] = table[at];
  }
  return same;
}

/// Matches the sides of triangles whose ends of lower id are in a range. Point p has the id ids[p].
class EdgeMatch
{
public:
  EdgeMatch(const std::vector<Triangle>& triangles, const std::vector<Index>& ids, EdgeSides& sides)
    : Triangles(triangles)
    , Ids(ids)
    , Sides(sides)
  {
  }

  void Run(Index first, Index last)
  {
    std::vector<std::uint32_t> starts(static_cast<std::size_t>(last - first) + 2, 0);
    this->ForEachSide(first, last, [&](Index low, const HalfEdge&) { ++starts[low - first + 2]; });
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    std::vector<HalfEdge> halfEdges(starts.back()); // of each point those to points of higher ids
    this->ForEachSide(first, last,
      [&](Index low, const HalfEdge& half) { halfEdges[starts[low - first + 1]++] = half; });
    const auto at = [&](Index low)
    { return halfEdges.begin() + static_cast<std::ptrdiff_t>(starts[low - first]); };
    for (Index low = first; low < last; ++low)
    {
      this->MatchAt(at(low), at(low + 1));
    }
  }

private:
  /// A side of a triangle, stored at its end of lower id.
  struct HalfEdge
  {
    Index High;
    std::uint32_t Slot; // 3 * triangle + side
  };
  using Iterator = std::vector<HalfEdge>::iterator;

  template <typename Visit>
  void ForEachSide(Index first, Index last, const Visit& visit) const
  {
    for (std::size_t t = 0; t < this->Triangles.size(); ++t)
    {
      const auto& [a, b, c] = this->Triangles[t];
      const Triangle ids = { this->Ids[a], this->Ids[b], this->Ids[c] };
      if (ids[0] == ids[1] || ids[1] == ids[2] || ids[2] == ids[0])
      {
        continue;
      }
      for (std::uint32_t side = 0; side < 3; ++side)
      {
        const auto [low, high] = std::minmax(ids[side], ids[(side + 1) % 3]);
        if (low >= first && low < last)
        {
          visit(low, HalfEdge{ high, static_cast<std::uint32_t>(3 * t) + side });
        }
      }
    }
  }

  void MatchAt(Iterator first, Iterator last)
  {
    std::sort(first, last, [](const HalfEdge& a, const HalfEdge& b) { return a.High < b.High; });
    while (first != last)
    {
      const Iterator end =
        std::find_if(first, last, [&](const HalfEdge& other) { return other.High != first->High; });
      const std::uint32_t one = first->Slot;
      const std::uint32_t other = (end - 1)->Slot;
      if (end - first == 1)
      {
        this->Sides[one / 3][one % 3] = Boundary;
      }
      if (end - first == 2 && this->Begin(one) != this->Begin(other))
      {
        this->Sides[one / 3][one % 3] = static_cast<Index>(other / 3);
        this->Sides[other / 3][other % 3] = static_cast<Index>(one / 3);
      }
      first = end;
    }
  }

  /// The id of the point at which the side begins.
  Index Begin(std::uint32_t slot) const { return this->Ids[this->Triangles[slot / 3][slot % 3]]; }

  const std::vector<Triangle>& Triangles;
  const std::vector<Index>& Ids;
  EdgeSides& Sides;
};

/// Each thread matches the sides of a range of points.
EdgeSides MatchEdges(
  const std::vector<Triangle>& triangles, const std::vector<Index>& ids, int threads)
{
  EdgeSides sides(triangles.size(), { NotRegular, NotRegular, NotRegular });
  const std::size_t parts = std::min<std::size_t>(
    ThreadsToUse(threads), std::max<std::size_t>(1, NumberOfBlocks(ids.size())));
  const auto begin = [&](std::size_t part)
  { return static_cast<Index>(ids.size() * part / parts); };
  ForEachPart(parts, threads, Monitor(),
    [&](std::size_t part) { EdgeMatch(triangles, ids, sides).Run(begin(part), begin(part + 1)); });
  return sides;
}

bool HasBoundaries(const EdgeSides& sides)
{
  return std::any_of(sides.begin(), sides.end(),
    [](const std::array<Index, 3>& of)
    { return std::find(of.begin(), of.end(), Boundary) != of.end(); });
}
}

EdgeSides FindEdgeSides(
  const std::vector<Vector3>& points, const std::vector<Triangle>& triangles, int threads)
{
  std::vector<Index> ids(points.size());
  std::iota(ids.begin(), ids.end(), 0);
  EdgeSides sides = MatchEdges(triangles, ids, threads);
  if (HasBoundaries(sides)) // merging points can only remove boundaries
  {
    std::vector<Index> merged = FirstPointAtEachPosition(points);
    sides = merged == ids ? std::move(sides) : MatchEdges(triangles, merged, threads);
  }
  return sides;
}

std::vector<BoundaryEdge> FindBoundaries(const Surface& surface, const EdgeSides& sides)
{
  std::vector<BoundaryEdge> boundaries;
  for (std::size_t t = 0; t < sides.size(); ++t)
  {
    const Triangle& corners = surface.Triangles[t];
    for (std::size_t side = 0; side < 3; ++side)
    {
      if (sides[t][side] == Boundary)
      {
        boundaries.push_back({ { corners[side], corners[(side + 1) % 3] }, static_cast<Index>(t) });
      }
    }
  }
  return boundaries;
}
}
