// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelLayers.h"

#include <algorithm>

namespace bonedecimate
{
VoxelLayers::VoxelLayers(
  const LabelImage& image, const LayerRange& inMemory, const LabelRanks& ranks, bool isPadded)
  : Image(image)
  , Ranks(ranks)
  , InMemory(inMemory)
  , Padding(isPadded ? 1 : 0)
  , FirstZ(inMemory.First == 0 ? -this->Padding : inMemory.First)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Size[axis] = image.Grid.Dimensions[axis] + 2 * this->Padding;
  }
  const bool isAtEnd = inMemory.Last + 1 == image.Grid.Dimensions[2];
  this->Size[2] = inMemory.Last + 1 + (isAtEnd ? this->Padding : 0) - this->FirstZ;
}

//------------------------------------------------------------------------------
void VoxelLayers::Load(Index layer, RankLayer& ranks) const
{
  const auto& dimensions = this->Image.Grid.Dimensions;
  ranks.resize(this->VoxelsInALayer());
  const Index z = layer + this->FirstZ;
  if (z < 0 || z >= dimensions[2])
  {
    std::fill(ranks.begin(), ranks.end(), 0);
    return;
  }
  const auto width = static_cast<std::size_t>(dimensions[0]);
  const auto height = static_cast<std::size_t>(dimensions[1]);
  const auto padding = static_cast<std::size_t>(this->Padding);
  const std::size_t first = width * height * static_cast<std::size_t>(z - this->InMemory.First);
  std::fill_n(ranks.begin(), padding * (width + 2 * padding), 0);
  Index* row = ranks.data() + padding * (width + 2 * padding);
  for (std::size_t y = 0; y < height; ++y, row += width + 2 * padding)
  {
    std::fill_n(row, padding, 0);
    this->Ranks.Convert(this->Image, first + y * width, width, row + padding);
    std::fill_n(row + padding + width, padding, 0);
  }
  std::fill_n(row, padding * (width + 2 * padding), 0);
}
}
