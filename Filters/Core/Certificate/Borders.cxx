// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Borders.h"

#include <algorithm>
#include <numeric>

namespace bonedecimate::certificate
{
namespace
{
/// Of each point the least id of those at the same place.
std::vector<Index> OnePointAPlace(const std::vector<Vector3>& points)
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

/// Edges of one triangle when point p goes by the name ids[p].
class EdgeCount
{
public:
  EdgeCount(const Surface& surface, const std::vector<Index>& ids)
    : Source(surface)
    , Ids(ids)
    , Starts(surface.Points.size() + 1, 0)
  {
  }

  std::vector<BorderEdge> Run()
  {
    this->ForEachEdge([&](Index low, Index, Index, int) { ++this->Starts[low + 1]; });
    std::partial_sum(this->Starts.begin(), this->Starts.end(), this->Starts.begin());
    this->Edges.resize(this->Starts.back());
    std::vector<std::size_t> next(this->Starts.begin(), this->Starts.end() - 1);
    this->ForEachEdge(
      [&](Index low, Index high, Index triangle, int side) {
        this->Edges[next[low]++] = { high, triangle, side };
      });
    this->KeepSingles();
    return this->Borders();
  }

private:
  /// An edge by the point of the higher id, listed with the one of the lower.
  struct Half
  {
    Index High, Triangle;
    int Side;
  };

  template <typename Visit>
  void ForEachEdge(const Visit& visit) const
  {
    for (std::size_t t = 0; t < this->Source.Triangles.size(); ++t)
    {
      const auto& [a, b, c] = this->Source.Triangles[t];
      const Triangle ids = { this->Ids[a], this->Ids[b], this->Ids[c] };
      if (ids[0] == ids[1] || ids[1] == ids[2] || ids[2] == ids[0])
      {
        continue;
      }
      for (int side = 0; side < 3; ++side)
      {
        const auto [low, high] = std::minmax(ids[side], ids[(side + 1) % 3]);
        visit(low, high, static_cast<Index>(t), side);
      }
    }
  }

  void KeepSingles()
  {
    for (std::size_t low = 0; low + 1 < this->Starts.size(); ++low)
    {
      const auto first = this->Edges.begin() + static_cast<std::ptrdiff_t>(this->Starts[low]);
      const auto last = this->Edges.begin() + static_cast<std::ptrdiff_t>(this->Starts[low + 1]);
      std::sort(first, last, [](const Half& a, const Half& b) { return a.High < b.High; });
      for (auto at = first; at != last;)
      {
        const auto end =
          std::find_if(at, last, [&](const Half& other) { return other.High != at->High; });
        if (end - at == 1)
        {
          this->Singles.push_back(*at);
        }
        at = end;
      }
    }
  }

  std::vector<BorderEdge> Borders()
  {
    std::sort(this->Singles.begin(), this->Singles.end(),
      [](const Half& a, const Half& b)
      { return a.Triangle != b.Triangle ? a.Triangle < b.Triangle : a.Side < b.Side; });
    std::vector<BorderEdge> borders;
    borders.reserve(this->Singles.size());
    for (const Half& half : this->Singles)
    {
      const Triangle& corners = this->Source.Triangles[half.Triangle];
      borders.push_back({ { corners[half.Side], corners[(half.Side + 1) % 3] }, half.Triangle });
    }
    return borders;
  }

  const Surface& Source;
  const std::vector<Index>& Ids;
  std::vector<std::size_t> Starts; // of each point its edges to points of higher ids
  std::vector<Half> Edges;
  std::vector<Half> Singles;
};
}

std::vector<BorderEdge> FindBorders(const Surface& surface)
{
  std::vector<Index> ids(surface.Points.size());
  std::iota(ids.begin(), ids.end(), 0);
  std::vector<BorderEdge> borders = EdgeCount(surface, ids).Run();
  if (!borders.empty()) // merging points can only take borders away
  {
    ids = OnePointAPlace(surface.Points);
    borders = EdgeCount(surface, ids).Run();
  }
  return borders;
}
}
