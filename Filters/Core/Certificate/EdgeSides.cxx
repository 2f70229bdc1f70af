// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeSides.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace bonedecimate::certificate
{
namespace
{
/// For each point the least id of the points with the same coordinates.
std::vector<Index> FirstPointAtEachPosition(const std::vector<Vector3>& points)
{
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto isLess = [&](Index a, Index b)
  {
    const Vector3& p = points[a];
    const Vector3& q = points[b];
    return p.x() != q.x() ? p.x() < q.x()
      : p.y() != q.y()    ? p.y() < q.y()
      : p.z() != q.z()    ? p.z() < q.z()
                          : a < b;
  };
  std::sort(order.begin(), order.end(), isLess);
  std::vector<Index> same(points.size());
  Index first = None;
  for (const Index point : order)
  {
    first = first != None && points[first] == points[point] ? first : point;
    same[point] = first;
  }
  return same;
}

/// Matches the sides of triangles along the edges between points, where point p has the id ids[p].
class EdgeMatch
{
public:
  EdgeMatch(const std::vector<Triangle>& triangles, const std::vector<Index>& ids)
    : Triangles(triangles)
    , Ids(ids)
    , Starts(ids.size() + 2, 0)
    , Found(triangles.size(), { NotRegular, NotRegular, NotRegular })
  {
  }

  EdgeSides Run()
  {
    this->ForEachSide([&](Index low, const Half&) { ++this->Starts[low + 2]; });
    std::partial_sum(this->Starts.begin(), this->Starts.end(), this->Starts.begin());
    this->Halves.resize(this->Starts.back());
    this->ForEachSide(
      [&](Index low, const Half& half) { this->Halves[this->Starts[low + 1]++] = half; });
    for (std::size_t low = 0; low + 2 < this->Starts.size(); ++low)
    {
      this->MatchAt(this->Halves.begin() + static_cast<std::ptrdiff_t>(this->Starts[low]),
        this->Halves.begin() + static_cast<std::ptrdiff_t>(this->Starts[low + 1]));
    }
    return std::move(this->Found);
  }

private:
  /// A side of a triangle, stored at its end of lower id.
  struct Half
  {
    Index High;
    std::uint32_t Slot; // 3 * triangle + side
  };
  using Iterator = std::vector<Half>::iterator;

  template <typename Visit>
  void ForEachSide(const Visit& visit) const
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
        visit(low, Half{ high, static_cast<std::uint32_t>(3 * t) + side });
      }
    }
  }

  void MatchAt(Iterator first, Iterator last)
  {
    std::sort(first, last, [](const Half& a, const Half& b) { return a.High < b.High; });
    while (first != last)
    {
      const Iterator end =
        std::find_if(first, last, [&](const Half& other) { return other.High != first->High; });
      const std::uint32_t one = first->Slot;
      const std::uint32_t other = (end - 1)->Slot;
      if (end - first == 1)
      {
        this->Found[one / 3][one % 3] = Boundary;
      }
      if (end - first == 2 && this->Begin(one) != this->Begin(other))
      {
        this->Found[one / 3][one % 3] = static_cast<Index>(other / 3);
        this->Found[other / 3][other % 3] = static_cast<Index>(one / 3);
      }
      first = end;
    }
  }

  /// The id of the point at which the side begins.
  Index Begin(std::uint32_t slot) const { return this->Ids[this->Triangles[slot / 3][slot % 3]]; }

  const std::vector<Triangle>& Triangles;
  const std::vector<Index>& Ids;
  std::vector<std::uint32_t> Starts; // for each point its first edge to points of higher ids
  std::vector<Half> Halves;
  EdgeSides Found;
};

bool HasBoundaries(const EdgeSides& sides)
{
  return std::any_of(sides.begin(), sides.end(),
    [](const std::array<Index, 3>& of)
    { return std::find(of.begin(), of.end(), Boundary) != of.end(); });
}
}

EdgeSides FindEdgeSides(const std::vector<Vector3>& points, const std::vector<Triangle>& triangles)
{
  std::vector<Index> ids(points.size());
  std::iota(ids.begin(), ids.end(), 0);
  EdgeSides sides = EdgeMatch(triangles, ids).Run();
  if (HasBoundaries(sides)) // merging points can only remove boundaries
  {
    ids = FirstPointAtEachPosition(points);
    sides = EdgeMatch(triangles, ids).Run();
  }
  return sides;
}

std::vector<BoundaryEdge> FindBoundaries(const Surface& surface)
{
  const EdgeSides sides = FindEdgeSides(surface.Points, surface.Triangles);
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
