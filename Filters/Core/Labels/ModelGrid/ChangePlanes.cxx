// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ChangePlanes.h"

#include "Base/Parallel.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
using Counts32 = std::vector<std::uint32_t>;

template <typename Label>
std::uint32_t CountDifferences(const Label* a, const Label* b, std::size_t count)
{
  std::uint32_t different = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    different += a[i] != b[i] ? 1 : 0;
  }
  return different;
}

/// Changes within a layer, along x and y, and from the layer before.
struct LayerCounts
{
  Counts32 AlongX;
  Counts32 AlongY;
  std::int64_t FromLayerBefore = 0;
};

template <typename Label>
LayerCounts CountLayer(
  const Label* layer, bool hasLayerBefore, std::size_t columns, std::size_t rows)
{
  LayerCounts counts{ Counts32(columns, 0), Counts32(rows, 0) };
  std::uint32_t* const alongX = counts.AlongX.data();
  for (std::size_t y = 0; y < rows; ++y)
  {
    const Label* const row = layer + y * columns;
    counts.FromLayerBefore +=
      hasLayerBefore ? CountDifferences(row, row - rows * columns, columns) : 0;
    counts.AlongY[y] = y > 0 ? CountDifferences(row, row - columns, columns) : 0;
    for (std::size_t x = 1; x < columns; ++x)
    {
      alongX[x] += row[x] != row[x - 1] ? 1 : 0;
    }
  }
  return counts;
}

void AddTo(PlaneCounts& sums, const Counts32& counts)
{
  std::transform(counts.begin(), counts.end(), sums.begin(), sums.begin(),
    [](std::uint32_t count, std::int64_t sum) { return sum + count; });
}
}

std::array<PlaneCounts, 3> CountPlaneChanges(const LabelImage& image, int threads)
{
  const auto [columns, rows, layers] = image.Grid.Dimensions;
  const auto perLayer = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  std::vector<LayerCounts> ofLayer(static_cast<std::size_t>(layers));
  WithLabelsOf(image,
    [&, columns = static_cast<std::size_t>(columns), rows = static_cast<std::size_t>(rows)](
      const auto* labels)
    {
      ForEachPart(ofLayer.size(), threads, Monitor(),
        [&](std::size_t z)
        { ofLayer[z] = CountLayer(labels + z * perLayer, z > 0, columns, rows); });
    });
  std::array<PlaneCounts, 3> counts = { PlaneCounts(static_cast<std::size_t>(columns), 0),
    PlaneCounts(static_cast<std::size_t>(rows), 0), {} };
  for (const LayerCounts& layer : ofLayer)
  {
    AddTo(counts[0], layer.AlongX);
    AddTo(counts[1], layer.AlongY);
    counts[2].push_back(layer.FromLayerBefore);
  }
  return counts;
}
}
