// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelSize.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace bonedecimate
{
namespace
{
/// Largest difference of equal coordinates as a fraction of the largest coordinate: twice the
/// rounding of single precision.
constexpr double SameCoordinate = 0x1p-22;
/// Least number of vertices of a plane as a fraction of that of a typical plane.
constexpr double PlaneRatio = 0.125;
constexpr double EvenStep = 0.02;
constexpr double EvenStepRatio = 0.9;
constexpr double OnPlanesRatio =
  0.15; // with cubic voxels two thirds; fewer if the planes are far apart
constexpr std::size_t FewestPlanes = 4;
/// The median edge of a marching-cubes surface as a fraction of the side of a cubic voxel, and its
/// uncertainty.
constexpr double EdgeOfVoxel = 1.03;
constexpr double EdgeError = 0.2;

struct Value
{
  double Coordinate; // mm
  std::size_t Count;
};

/// Distinct coordinates, ascending.
std::vector<Value> CountedValues(std::vector<double> coordinates)
{
  std::sort(coordinates.begin(), coordinates.end());
  std::vector<Value> values;
  if (coordinates.empty())
  {
    return values;
  }
  const double same =
    SameCoordinate * std::max(std::abs(coordinates.front()), std::abs(coordinates.back()));
  for (const double x : coordinates)
  {
    if (values.empty() || x - values.back().Coordinate > same)
    {
      values.push_back({ x, 0 });
    }
    ++values.back().Count;
  }
  return values;
}

/// The number of occurrences that the values of a tenth of the vertices reach.
std::size_t TypicalCount(std::vector<Value> values, std::size_t vertices)
{
  std::sort(
    values.begin(), values.end(), [](const Value& a, const Value& b) { return a.Count > b.Count; });
  std::size_t passed = 0;
  for (const Value& value : values)
  {
    passed += value.Count;
    if (10 * passed >= vertices)
    {
      return value.Count;
    }
  }
  return 0;
}

double Median(std::vector<double> numbers)
{
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

struct Planes
{
  std::vector<double> Coordinates; // mm
  std::size_t Vertices = 0;        // on them
};

Planes FindPlanes(const std::vector<Value>& values, std::size_t vertices)
{
  const double fewest =
    std::max(2.0, PlaneRatio * static_cast<double>(TypicalCount(values, vertices)));
  Planes planes;
  for (const Value& value : values)
  {
    if (static_cast<double>(value.Count) >= fewest)
    {
      planes.Coordinates.push_back(value.Coordinate);
      planes.Vertices += value.Count;
    }
  }
  return planes;
}

struct AxisSpacing
{
  double Spacing = 0.0; // mm; 0: none
  double RelativeError = 0.0;
};

AxisSpacing SpacingOf(const std::vector<double>& coordinates)
{
  const Planes planes = FindPlanes(CountedValues(coordinates), coordinates.size());
  const std::vector<double>& at = planes.Coordinates;
  if (at.size() < FewestPlanes ||
    static_cast<double>(planes.Vertices) < OnPlanesRatio * static_cast<double>(coordinates.size()))
  {
    return {};
  }
  std::vector<double> steps;
  for (std::size_t i = 1; i < at.size(); ++i)
  {
    steps.push_back(at[i] - at[i - 1]);
  }
  const double step = Median(steps);
  double whole = 0.0; // steps of the grid from the first to the last plane
  std::size_t even = 0;
  double worst = 0.0;
  for (const double each : steps)
  {
    const double multiple = std::max(1.0, std::round(each / step));
    const double off = std::abs(each / step - multiple);
    even += off <= EvenStep ? 1 : 0;
    worst = off <= EvenStep ? std::max(worst, off) : worst;
    whole += multiple;
  }
  const bool isEven =
    static_cast<double>(even) >= EvenStepRatio * static_cast<double>(steps.size());
  return isEven ? AxisSpacing{ (at.back() - at.front()) / whole, 2.0 * worst / whole }
                : AxisSpacing{};
}

bool IsFinite(const Vector3& p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

double MedianEdge(const Surface& surface)
{
  std::vector<double> lengths;
  lengths.reserve(3 * surface.Triangles.size());
  const auto count = static_cast<Index>(surface.Points.size());
  for (const Triangle& corners : surface.Triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Index a = corners[i];
      const Index b = corners[(i + 1) % 3];
      if (std::min(a, b) >= 0 && std::max(a, b) < count)
      {
        const double length = (surface.Points[a] - surface.Points[b]).norm();
        if (std::isfinite(length) && length > 0.0)
        {
          lengths.push_back(length);
        }
      }
    }
  }
  return lengths.empty() ? 0.0 : Median(std::move(lengths));
}
}

//------------------------------------------------------------------------------
VoxelEstimate EstimateVoxelSize(const Surface& surface)
{
  VoxelEstimate estimate;
  estimate.IsFromGrid = true;
  for (Eigen::Index axis = 0; axis < 3 && estimate.IsFromGrid; ++axis)
  {
    std::vector<double> coordinates;
    coordinates.reserve(surface.Points.size());
    for (const Vector3& p : surface.Points)
    {
      if (IsFinite(p))
      {
        coordinates.push_back(p[axis]);
      }
    }
    const AxisSpacing found = SpacingOf(coordinates);
    estimate.Spacing[axis] = found.Spacing;
    estimate.RelativeError = std::max(estimate.RelativeError, found.RelativeError);
    estimate.IsFromGrid = found.Spacing > 0.0;
  }
  if (!estimate.IsFromGrid)
  {
    estimate.Spacing.setConstant(MedianEdge(surface) / EdgeOfVoxel);
    estimate.RelativeError = EdgeError;
  }
  return estimate;
}

//------------------------------------------------------------------------------
VoxelFigures ApplyPreset(const Surface& surface, Options& options)
{
  VoxelFigures voxel;
  if (options.VoxelsOfPreset() == 0.0)
  {
    return voxel;
  }
  voxel.From = VoxelFigures::Source::Input;
  voxel.Size = options.VoxelSize;
  if (voxel.Size == 0.0)
  {
    const VoxelEstimate estimate = EstimateVoxelSize(surface);
    voxel.From = estimate.IsFromGrid ? VoxelFigures::Source::Grid : VoxelFigures::Source::Edges;
    voxel.Size = estimate.Least();
    voxel.Error = estimate.RelativeError * voxel.Size;
  }
  voxel.MaxError = options.MaxError(voxel.Size);
  options.MaximumError = voxel.MaxError;
  options.ErrorPreset = ErrorPreset::NoPreset;
  return voxel;
}
}
