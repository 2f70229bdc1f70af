// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NearBoundaries.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace bonedecimate
{
namespace
{
/// Fraction of the mean length of boundary edges.
constexpr double NearRatio = 0.01;

/// A hash grid of points whose cells are as wide as the search distance.
class Grid
{
public:
  Grid(const std::vector<Vector3>& points, double width)
    : Points(points)
    , Width(width)
  {
  }

  void Add(Index point) { this->Cells[this->BucketOf(this->CellOf(point))].push_back(point); }

  /// Calls visit(other) for the points in this cell and in the neighboring ones.
  template <typename Visit>
  void VisitNear(Index point, const Visit& visit) const
  {
    const Cell middle = this->CellOf(point);
    for (int i = 0; i < 27; ++i)
    {
      const Cell cell = { middle[0] + i % 3 - 1, middle[1] + i / 3 % 3 - 1, middle[2] + i / 9 - 1 };
      const auto found = this->Cells.find(BucketOf(cell));
      if (found != this->Cells.end())
      {
        std::for_each(found->second.begin(), found->second.end(), visit);
      }
    }
  }

private:
  using Cell = std::array<std::int64_t, 3>;

  Cell CellOf(Index point) const
  {
    const Vector3& p = this->Points[static_cast<std::size_t>(point)];
    const auto along = [&](Eigen::Index axis)
    { return static_cast<std::int64_t>(std::floor(std::min(p[axis] / this->Width, 1e18))); };
    return { along(0), along(1), along(2) };
  }

  /// Collisions only cost time: the distance is always compared.
  static std::uint64_t BucketOf(const Cell& cell)
  {
    return static_cast<std::uint64_t>(cell[0]) * 73856093U ^
      static_cast<std::uint64_t>(cell[1]) * 19349663U ^
      static_cast<std::uint64_t>(cell[2]) * 83492791U;
  }

  const std::vector<Vector3>& Points;
  double Width; // mm
  std::unordered_map<std::uint64_t, std::vector<Index>> Cells;
};

double MeanLength(
  const std::vector<Vector3>& points, const std::vector<std::array<Index, 2>>& edges)
{
  double sum = 0.0;
  for (const auto& [from, to] : edges)
  {
    sum += (points[static_cast<std::size_t>(from)] - points[static_cast<std::size_t>(to)]).norm();
  }
  return sum / std::max<double>(1.0, static_cast<double>(edges.size()));
}

/// Pairs of each point and its neighbors along boundaries, sorted.
std::vector<std::pair<Index, Index>> NeighborsAlongBoundaries(
  const std::vector<std::array<Index, 2>>& open)
{
  std::vector<std::pair<Index, Index>> neighbors;
  neighbors.reserve(2 * open.size());
  for (const auto& [from, to] : open)
  {
    neighbors.emplace_back(from, to);
    neighbors.emplace_back(to, from);
  }
  std::sort(neighbors.begin(), neighbors.end());
  return neighbors;
}
}

NearBoundaries FindNearBoundaries(
  const std::vector<Vector3>& points, const std::vector<std::array<Index, 2>>& open)
{
  NearBoundaries near;
  const double limit = NearRatio * MeanLength(points, open);
  if (limit <= 0.0)
  {
    return near;
  }
  const std::vector<std::pair<Index, Index>> neighbors = NeighborsAlongBoundaries(open);
  std::vector<Index> onBoundaries;
  for (const auto& [point, other] : neighbors)
  {
    if (onBoundaries.empty() || onBoundaries.back() != point)
    {
      onBoundaries.push_back(point);
    }
  }
  Grid grid(points, limit);
  std::for_each(
    onBoundaries.begin(), onBoundaries.end(), [&grid](Index point) { grid.Add(point); });
  double farthest = 0.0;
  for (const Index point : onBoundaries)
  {
    double least = std::numeric_limits<double>::infinity();
    grid.VisitNear(point,
      [&](Index other)
      {
        const bool isOther = other != point &&
          !std::binary_search(neighbors.begin(), neighbors.end(), std::pair(point, other));
        const double distance =
          (points[static_cast<std::size_t>(point)] - points[static_cast<std::size_t>(other)])
            .norm();
        least = isOther ? std::min(least, distance) : least;
      });
    if (least <= limit)
    {
      near.Points.push_back(point);
      farthest = std::max(farthest, least);
    }
  }
  near.WeldingDistance = near.Points.empty() ? near.WeldingDistance : farthest;
  return near;
}
}
