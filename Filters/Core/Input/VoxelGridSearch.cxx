// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelGridSearch.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
/// Largest difference of equal coordinates as a fraction of the largest coordinate: four times the rounding of single
/// precision, for programs that transform points.
constexpr double SameValue = 0x1p-21;
/// Largest deviation from a multiple of the step.
constexpr double Deviation = 0.01;
constexpr double MostSteps = 1e6;

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
  if (values.size() < 2 || extent > MostSteps * least)
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

/// Whether the corners of every triangle lie in one cell: no coordinate differs by more than a voxel.
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

/// What to add to the numbers of steps so that exactly one coordinate of every point is odd; nothing if that is impossible.
std::optional<GridPoint> FindParity(const std::vector<GridPoint>& points)
{
  for (int parity = 0; parity < 8; ++parity)
  {
    const GridPoint offset = { parity & 1, parity >> 1 & 1, parity >> 2 & 1 };
    const auto isMiddleOfEdge = [&offset](const GridPoint& p)
    { return (p[0] + offset[0]) % 2 + (p[1] + offset[1]) % 2 + (p[2] + offset[2]) % 2 == 1; };
    if (std::all_of(points.begin(), points.end(), isMiddleOfEdge))
    {
      return offset;
    }
  }
  return {};
}
}

std::optional<LabelMapSource> FindVoxelGrid(const Surface& surface)
{
  if (!AreUsable(surface))
  {
    return {};
  }
  std::array<AxisSteps, 3> steps;
  for (int axis = 0; axis < 3; ++axis)
  {
    steps[axis] = FindSteps(surface.Points, axis);
    if (steps[axis].Length == 0.0)
    {
      return {};
    }
  }
  LabelMapSource source;
  for (const Vector3& p : surface.Points)
  {
    GridPoint at;
    for (int axis = 0; axis < 3; ++axis)
    {
      at[axis] = static_cast<std::int32_t>(std::round(steps[axis].Of(p[axis])));
    }
    source.OfPoint.push_back(at);
  }
  const std::optional<GridPoint> offset = FindParity(source.OfPoint);
  if (!offset || !HasSmallTriangles(source.OfPoint, surface.Triangles))
  {
    return {};
  }
  for (GridPoint& point : source.OfPoint)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] += (*offset)[axis];
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    source.Grid.Spacing[axis] = 2.0 * steps[axis].Length;
    source.Grid.Origin[axis] = steps[axis].First - (*offset)[axis] * steps[axis].Length;
  }
  return source;
}
}
