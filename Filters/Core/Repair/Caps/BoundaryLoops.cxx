// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryLoops.h"

#include "Mesh/PointMerging.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <utility>

namespace bonedecimate
{
namespace
{
/// The directed edges of the triangles.
class EdgeMap
{
public:
  explicit EdgeMap(const Surface& surface)
    : Corners(surface.Triangles.size(), Triangle{ None, None, None })
  {
    LargeArray<Index> first(surface.Points.size());
    std::iota(first.begin(), first.end(), 0);
    MergeEqualPoints(surface.Points, first);
    const auto count = static_cast<Index>(surface.Points.size());
    for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
    {
      Triangle corners = surface.Triangles[t];
      if (std::any_of(
            corners.begin(), corners.end(), [count](Index c) { return c < 0 || c >= count; }))
      {
        continue;
      }
      for (Index& corner : corners)
      {
        corner = first[static_cast<std::size_t>(corner)];
      }
      if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
      {
        this->Add(t, corners);
      }
    }
  }

  const Triangle& At(std::size_t triangle) const { return this->Corners[triangle]; }

  bool IsBoundary(Index from, Index to) const
  {
    const auto own = this->Edges.find(Key(from, to));
    return own != this->Edges.end() && own->second.Count == 1 &&
      this->Edges.count(Key(to, from)) == 0;
  }

  /// The end of the boundary edge that follows at the point `to`; nothing at a non-manifold edge.
  /// @param triangle The triangle of the edge that ends at `to`; becomes that of the next edge.
  std::optional<Index> Next(Index to, std::size_t& triangle) const
  {
    for (std::size_t turns = 0; turns < this->Corners.size(); ++turns)
    {
      const Triangle& corners = this->Corners[triangle];
      const auto k =
        static_cast<std::size_t>(std::find(corners.begin(), corners.end(), to) - corners.begin());
      const Index after = corners[(k + 1) % 3];
      const auto opposite = this->Edges.find(Key(after, to));
      if (this->Edges.at(Key(to, after)).Count > 1)
      {
        return std::nullopt;
      }
      if (opposite == this->Edges.end())
      {
        return after;
      }
      if (opposite->second.Count > 1)
      {
        return std::nullopt;
      }
      triangle = opposite->second.Triangle;
    }
    return std::nullopt;
  }

private:
  struct Use
  {
    std::size_t Triangle = 0;
    int Count = 0;
  };

  static std::uint64_t Key(Index from, Index to)
  {
    return static_cast<std::uint64_t>(from) << 32U | static_cast<std::uint64_t>(to);
  }

  void Add(std::size_t triangle, const Triangle& corners)
  {
    this->Corners[triangle] = corners;
    for (std::size_t k = 0; k < 3; ++k)
    {
      Use& use = this->Edges[Key(corners[k], corners[(k + 1) % 3])];
      use = { triangle, use.Count + 1 };
    }
  }

  std::vector<Triangle> Corners; // of representatives; None where the triangle does not count
  std::unordered_map<std::uint64_t, Use> Edges;
};

Vector3 AreaOf(const Surface& surface, const std::vector<Index>& loop)
{
  const Vector3& origin = surface.Points[static_cast<std::size_t>(loop.front())];
  Vector3 area = Vector3::Zero();
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
  {
    area += (surface.Points[static_cast<std::size_t>(loop[i])] - origin)
              .cross(surface.Points[static_cast<std::size_t>(loop[i + 1])] - origin);
  }
  return area;
}

class Plane
{
public:
  Plane(const Surface& surface, const BoundaryLoop& loop)
    : Normal(loop.Area.normalized())
  {
    for (const Index point : loop.Points)
    {
      this->Offset += Dot(this->Normal, surface.Points[static_cast<std::size_t>(point)]) /
        static_cast<double>(loop.Points.size());
    }
  }

  double Height(const Vector3& point) const { return Dot(this->Normal, point) - this->Offset; }

  bool Has(const Surface& surface, const BoundaryLoop& loop, double tolerance) const
  {
    return std::all_of(loop.Points.begin(), loop.Points.end(),
      [&](Index p)
      { return std::abs(this->Height(surface.Points[static_cast<std::size_t>(p)])) <= tolerance; });
  }

  bool IsEnd(const Surface& surface, double tolerance) const
  {
    const auto isBelow = [&](Index p)
    { return this->Height(surface.Points[static_cast<std::size_t>(p)]) <= tolerance; };
    return std::all_of(surface.Triangles.begin(), surface.Triangles.end(),
      [&](const Triangle& c) { return std::all_of(c.begin(), c.end(), isBelow); });
  }

private:
  Vector3 Normal; // outward
  double Offset = 0.0;
};

void FindChords(const Surface& surface, const EdgeMap& edges, BoundaryLoops& found)
{
  std::vector<bool> isOfLoop(surface.Points.size(), false);
  for (const BoundaryLoop& loop : found.Loops)
  {
    for (const Index point : loop.Points)
    {
      isOfLoop[static_cast<std::size_t>(point)] = true;
    }
  }
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    for (std::size_t k = 0; k < 3 && edges.At(t)[0] != None; ++k)
    {
      const Index a = edges.At(t)[k];
      const Index b = edges.At(t)[(k + 1) % 3];
      if (isOfLoop[static_cast<std::size_t>(a)] && isOfLoop[static_cast<std::size_t>(b)] &&
        !edges.IsBoundary(a, b))
      {
        found.Chords.insert(std::minmax(a, b));
      }
    }
  }
}
}

BoundaryLoops FindBoundaryLoops(const Surface& surface)
{
  const EdgeMap edges(surface);
  BoundaryLoops found;
  std::vector<std::array<bool, 3>> visited(surface.Triangles.size());
  const auto visit = [&](std::size_t triangle, Index from)
  {
    const Triangle& corners = edges.At(triangle);
    bool& isVisited = visited[triangle][static_cast<std::size_t>(
      std::find(corners.begin(), corners.end(), from) - corners.begin())];
    return !std::exchange(isVisited, true);
  };
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    for (std::size_t k = 0; k < 3 && edges.At(t)[0] != None; ++k)
    {
      Index from = edges.At(t)[k];
      std::optional<Index> to = edges.At(t)[(k + 1) % 3];
      if (visited[t][k] || !edges.IsBoundary(from, *to))
      {
        continue;
      }
      BoundaryLoop loop{ {}, t };
      for (std::size_t triangle = t; to && visit(triangle, from);)
      {
        loop.Points.push_back(from);
        from = *to;
        to = edges.Next(from, triangle);
      }
      if (!to || from != loop.Points.front())
      {
        ++found.NonManifold;
        continue;
      }
      std::reverse(loop.Points.begin(), loop.Points.end());
      loop.Area = AreaOf(surface, loop.Points);
      found.Loops.push_back(std::move(loop));
    }
  }
  FindChords(surface, edges, found);
  return found;
}

std::vector<std::vector<std::size_t>> GroupByEndPlanes(
  const Surface& surface, const std::vector<BoundaryLoop>& loops, double tolerance)
{
  std::vector<std::size_t> order(loops.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
    [&loops](std::size_t a, std::size_t b)
    { return loops[a].Area.squaredNorm() > loops[b].Area.squaredNorm(); });
  std::vector<bool> isTaken(loops.size(), false);
  std::vector<std::vector<std::size_t>> groups;
  for (const std::size_t largest : order)
  {
    const Plane plane(surface, loops[largest]);
    if (isTaken[largest] || loops[largest].Points.size() < 4 ||
      !plane.Has(surface, loops[largest], tolerance) || !plane.IsEnd(surface, tolerance))
    {
      continue;
    }
    groups.emplace_back();
    for (const std::size_t other : order)
    {
      if (!isTaken[other] && plane.Has(surface, loops[other], tolerance))
      {
        isTaken[other] = true;
        groups.back().push_back(other);
      }
    }
  }
  return groups;
}
}
