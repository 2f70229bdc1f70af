// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelGridSearch.h"

#include "GridDirection.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bonedecimate
{
namespace
{
/// Largest difference of equal coordinates as a fraction of the largest coordinate:
/// eight times the rounding of single precision, for programs that transform points and for axes
/// that are found in edges.
constexpr double SameValue = 0x1p-20;
/// Largest deviation from a multiple of the step.
constexpr double Deviation = 0.01;
constexpr double MaxSteps = 1e6;

/// The coordinates along an axis: numbers of steps from the least one.
struct AxisSteps
{
  double First = 0.0;  // mm
  double Length = 0.0; // mm, of a step; 0: none

  double Of(double coordinate) const { return (coordinate - this->First) / this->Length; }
};

/// Ascending; the first of each group of equal ones.
std::vector<double> DistinctValues(const std::vector<Vector3>& points, Eigen::Index axis)
{
  std::vector<double> values;
  values.reserve(points.size());
  for (const Vector3& p : points)
  {
    values.push_back(p[axis]);
  }
  std::sort(values.begin(), values.end());
  const double same = SameValue * std::max(std::abs(values.front()), std::abs(values.back()));
  std::vector<double> distinct = { values.front() };
  for (const double value : values)
  {
    if (value - distinct.back() > same)
    {
      distinct.push_back(value);
    }
  }
  return distinct;
}

AxisSteps FindSteps(const std::vector<Vector3>& points, Eigen::Index axis)
{
  const std::vector<double> values = DistinctValues(points, axis);
  double least = values.back() - values.front();
  for (std::size_t i = 1; i < values.size(); ++i)
  {
    least = std::min(least, values[i] - values[i - 1]);
  }
  AxisSteps steps;
  steps.First = values.front();
  const double extent = values.back() - values.front();
  if (values.size() < 2 || extent > MaxSteps * least)
  {
    return {};
  }
  // The least step alone would add up its rounding: walk from value to value.
  double whole = 0.0;
  for (std::size_t i = 1; i < values.size(); ++i)
  {
    whole += std::round((values[i] - values[i - 1]) / least);
  }
  steps.Length = extent / whole;
  const bool fit = std::all_of(values.begin(), values.end(),
    [&](double value)
    { return std::abs(steps.Of(value) - std::round(steps.Of(value))) <= Deviation; });
  return fit ? steps : AxisSteps{};
}

bool AreUsable(const Surface& surface)
{
  const auto count = static_cast<Index>(surface.Points.size());
  return !surface.Triangles.empty() &&
    std::all_of(surface.Points.begin(), surface.Points.end(), IsUsable) &&
    std::all_of(surface.Triangles.begin(), surface.Triangles.end(),
      [count](const Triangle& c) {
        return std::min({ c[0], c[1], c[2] }) >= 0 && std::max({ c[0], c[1], c[2] }) < count;
      });
}

/// Whether the corners of every triangle lie in one cell: no coordinate differs by more than a
/// voxel.
bool HasSmallTriangles(const std::vector<GridPoint>& points, const std::vector<Triangle>& triangles)
{
  return std::all_of(triangles.begin(), triangles.end(),
    [&](const Triangle& c)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const auto [low, high] = std::minmax({ points[c[0]][k], points[c[1]][k], points[c[2]][k] });
        if (high - low > 2)
        {
          return false;
        }
      }
      return true;
    });
}

/// Nothing if the position is not the middle of a grid edge.
std::optional<GridPoint> FindGridPoint(const Vector3& position, const VoxelGrid& grid)
{
  const Vector3 halves = 2.0 * grid.ToVoxels(position);
  const Vector3 whole = halves.array().round();
  if (!(whole.cwiseAbs().maxCoeff() <= MaxSteps) ||
    !((halves - whole).cwiseAbs().maxCoeff() <= Deviation))
  {
    return {};
  }
  GridPoint point;
  int odd = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    point[axis] = static_cast<std::int32_t>(whole[axis]);
    odd += point[axis] % 2 != 0 ? 1 : 0;
  }
  return odd == 1 ? std::optional<GridPoint>(point) : std::nullopt;
}
}

std::optional<std::vector<GridPoint>> FindGridPoints(const Surface& surface, const VoxelGrid& grid)
{
  if (!AreUsable(surface))
  {
    return {};
  }
  std::vector<GridPoint> points;
  points.reserve(surface.Points.size());
  for (const Vector3& position : surface.Points)
  {
    const std::optional<GridPoint> point = FindGridPoint(position, grid);
    if (!point)
    {
      return {};
    }
    points.push_back(*point);
  }
  return HasSmallTriangles(points, surface.Triangles) ? std::optional(std::move(points))
                                                      : std::nullopt;
}

namespace
{
/// @param direction Columns: the axes.
std::optional<LabelMapSource> FindGridAlong(
  const Surface& surface, const Eigen::Matrix3d& direction)
{
  std::vector<Vector3> points;
  points.reserve(surface.Points.size());
  for (const Vector3& point : surface.Points)
  {
    points.emplace_back(direction.transpose() * point);
  }
  std::array<AxisSteps, 3> steps;
  for (int axis = 0; axis < 3; ++axis)
  {
    steps[axis] = FindSteps(points, axis);
    if (steps[axis].Length == 0.0)
    {
      return {};
    }
  }
  LabelMapSource source;
  source.Grid.Direction = direction;
  for (int parity = 0; parity < 8; ++parity)
  {
    Vector3 origin;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int offset = parity >> axis & 1;
      source.Grid.Spacing[axis] = 2.0 * steps[axis].Length;
      origin[axis] = steps[axis].First - offset * steps[axis].Length;
    }
    source.Grid.Origin = direction * origin;
    if (auto found = FindGridPoints(surface, source.Grid))
    {
      source.OfPoint = std::move(*found);
      return source;
    }
  }
  return {};
}
}

//------------------------------------------------------------------------------
std::optional<LabelMapSource> FindVoxelGrid(const Surface& surface)
{
  if (!AreUsable(surface))
  {
    return {};
  }
  std::optional<LabelMapSource> source = FindGridAlong(surface, Eigen::Matrix3d::Identity());
  const std::vector<Eigen::Matrix3d> directions =
    source ? std::vector<Eigen::Matrix3d>() : FindGridDirections(surface);
  for (auto direction = directions.begin(); direction != directions.end() && !source; ++direction)
  {
    source = FindGridAlong(surface, *direction);
  }
  return source;
}
}
