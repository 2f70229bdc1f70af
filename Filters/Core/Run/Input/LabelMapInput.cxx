// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelMapInput.h"

#include "Labels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bonedecimate
{
namespace
{
constexpr double MaxErrorOfAutomatic = 0.5; // voxels
/// A preset of half a voxel may be rounded.
constexpr double Slack = 1.0 + 1e-6;
/// Voxels along an axis; a surface beyond that belongs to another grid.
constexpr double MaxExtent = 65536.0;

bool HasGrid(const LabelMapSource* source)
{
  return source != nullptr && source->Grid.Dimensions[0] > 0;
}

bool IsValidGrid(const VoxelGrid& grid)
{
  return grid.IsValid() && *std::min_element(grid.Dimensions.begin(), grid.Dimensions.end()) > 0;
}

bool ArePairsValid(const LabelMapSource& source, std::size_t triangles)
{
  const Index count = static_cast<Index>(source.Values.size());
  const auto isKnown = [count](Index label) { return label >= 0 && label < count; };
  return source.OfTriangle.empty() ||
    (source.OfTriangle.size() == triangles &&
      std::all_of(source.OfTriangle.begin(), source.OfTriangle.end(),
        [&](const BoundaryLabels& pair) { return isKnown(pair[0]) && isKnown(pair[1]); }));
}

/// Points in use within reach of the grid.
bool IsNearGrid(const Surface& input, const VoxelGrid& grid)
{
  const auto isNear = [&](Index point)
  {
    const bool isThere = point >= 0 && static_cast<std::size_t>(point) < input.Points.size();
    return !isThere || !IsUsable(input.Points[static_cast<std::size_t>(point)]) ||
      grid.ToSteps(input.Points[static_cast<std::size_t>(point)]).cwiseAbs().maxCoeff() <=
      MaxExtent;
  };
  return std::all_of(input.Triangles.begin(), input.Triangles.end(),
    [&](const Triangle& c) { return std::all_of(c.begin(), c.end(), isNear); });
}
}

InputStatus CheckLabelMap(
  const LabelMapSource* source, const Surface& input, const Options& options)
{
  if (!HasGrid(source))
  {
    return options.KeepVoxels == KeepVoxels::On ? InputStatus::NoVoxelGrid : InputStatus::Good;
  }
  const bool isValid = IsValidGrid(source->Grid) &&
    ArePairsValid(*source, input.Triangles.size()) && IsNearGrid(input, source->Grid);
  return isValid ? InputStatus::Good : InputStatus::BadLabelMap;
}

//------------------------------------------------------------------------------
InputStatus CheckForVoxels(
  const Surface& surface, const VoxelGrid& grid, int threads, CleaningStatistics& found)
{
  const InputStatus status = CheckSurface(surface, threads, found);
  const bool isUsable = status == InputStatus::Good || status == InputStatus::Empty ||
    status == InputStatus::NoTriangles;
  return !isUsable              ? status
    : IsNearGrid(surface, grid) ? InputStatus::Good
                                : InputStatus::BadLabelMap;
}

//------------------------------------------------------------------------------
bool GuardsVoxels(const LabelMapSource* source, const Options& options)
{
  if (!HasGrid(source) || options.KeepVoxels == KeepVoxels::Off)
  {
    return false;
  }
  const double largest = MaxErrorOfAutomatic * source->Grid.Spacing.minCoeff() * Slack;
  return options.KeepVoxels == KeepVoxels::On || options.MaximumError <= largest;
}

//------------------------------------------------------------------------------
bool HasSeveralPairs(const LabelMapSource* source)
{
  return source != nullptr && !source->OfTriangle.empty() &&
    std::any_of(source->OfTriangle.begin(), source->OfTriangle.end(),
      [source](const BoundaryLabels& pair) { return pair != source->OfTriangle.front(); });
}

//------------------------------------------------------------------------------
std::vector<Index> PatchLabels(
  const CleanSurface& clean, const Labels* labels, const LabelMapSource* source)
{
  if (!HasSeveralPairs(source))
  {
    return labels != nullptr ? LabelsOf(clean, *labels) : std::vector<Index>();
  }
  using Key = std::array<Index, 3>;
  std::vector<Key> keys;
  keys.reserve(clean.InputTriangle.size());
  for (const Index triangle : clean.InputTriangle)
  {
    const BoundaryLabels& pair = source->OfTriangle[static_cast<std::size_t>(triangle)];
    const Index label =
      labels != nullptr ? labels->OfTriangle[static_cast<std::size_t>(triangle)] : 0;
    keys.push_back({ pair[0], pair[1], label });
  }
  std::vector<Key> distinct = keys;
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  std::vector<Index> numbers;
  numbers.reserve(keys.size());
  for (const Key& key : keys)
  {
    numbers.push_back(static_cast<Index>(
      std::lower_bound(distinct.begin(), distinct.end(), key) - distinct.begin()));
  }
  return numbers;
}

//------------------------------------------------------------------------------
std::vector<BoundaryLabels> BoundaryLabelsOf(
  const CleanSurface& clean, const LabelMapSource& source)
{
  std::vector<BoundaryLabels> pairs;
  for (const Index triangle : clean.InputTriangle)
  {
    if (!source.OfTriangle.empty())
    {
      pairs.push_back(source.OfTriangle[static_cast<std::size_t>(triangle)]);
    }
  }
  return pairs;
}

//------------------------------------------------------------------------------
VoxelReport CompareWithInput(const Surface& input, const Surface& result,
  const std::vector<BoundaryLabels>& resultLabels, const LabelMapSource& source, int threads,
  const Monitor& monitor)
{
  VoxelCheckSettings settings;
  settings.Grid = source.Grid;
  settings.NumberOfLabels =
    source.OfTriangle.empty() ? 2 : static_cast<Index>(source.Values.size());
  settings.Threads = threads;
  VoxelReport report;
  report.Changes =
    CompareVoxels({ input, source.OfTriangle }, { result, resultLabels }, settings, monitor);
  report.WasChecked = report.Changes.IsDone;
  report.Values = source.OfTriangle.empty() ? std::vector<std::int64_t>{ 1, 0 } : source.Values;
  return report;
}
}
