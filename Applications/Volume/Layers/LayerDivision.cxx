// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LayerDivision.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <functional>
#include <numeric>

namespace bonedecimate::volume
{
namespace
{
/// Pairs of different values in two ranges.
template <typename Scalar>
std::int64_t CountChanges(const Scalar* a, const Scalar* b, std::ptrdiff_t count)
{
  return std::inner_product(
    a, a + count, b, std::int64_t(0), std::plus<>(), std::not_equal_to<Scalar>());
}

template <typename Scalar>
std::vector<std::int64_t> CountChanges(const Scalar* labels, const int* size)
{
  const std::ptrdiff_t row = size[0];
  const std::ptrdiff_t layer = row * size[1];
  std::vector<std::int64_t> changes;
  for (int k = 0; k < size[2]; ++k)
  {
    const Scalar* const first = labels + k * layer;
    std::int64_t count = CountChanges(first, first + row, layer - row) +
      (k + 1 < size[2] ? CountChanges(first, first + layer, layer) : 0);
    for (int j = 0; j < size[1]; ++j)
    {
      count += CountChanges(first + j * row, first + j * row + 1, row - 1);
    }
    changes.push_back(count);
  }
  return changes;
}
}

std::vector<std::int64_t> DivideLayers(
  const std::vector<std::int64_t>& triangles, std::int64_t mostTriangles, std::int64_t mostLayers)
{
  std::vector<std::int64_t> lastLayers;
  const std::int64_t count = static_cast<std::int64_t>(triangles.size());
  std::int64_t layers = 0;
  std::int64_t inSlab = 0;
  for (std::int64_t layer = 0; layer + 1 < count; ++layer)
  {
    const std::int64_t more = triangles[static_cast<std::size_t>(layer)];
    if (layers > 0 && (inSlab + more > mostTriangles || layers == mostLayers))
    {
      lastLayers.push_back(layer);
      inSlab = 0;
      layers = 0;
    }
    inSlab += more;
    ++layers;
  }
  lastLayers.push_back(count - 1);
  return lastLayers;
}

void AppendCounts(const std::vector<std::int64_t>& ofSlab, std::vector<std::int64_t>& counts)
{
  if (!counts.empty())
  {
    counts.pop_back(); // the shared layer, without those above it
  }
  counts.insert(counts.end(), ofSlab.begin(), ofSlab.end());
}

std::vector<std::int64_t> CountLabelChanges(const Volume& slab)
{
  vtkDataArray* const array = slab.Image->GetPointData()->GetScalars();
  const int* const size = slab.Image->GetDimensions();
  switch (array->GetDataType())
  {
    vtkTemplateMacro(
      return CountChanges(static_cast<const VTK_TT*>(array->GetVoidPointer(0)), size));
    default:
      break;
  }
  return std::vector<std::int64_t>(static_cast<std::size_t>(size[2]), 0);
}
}
