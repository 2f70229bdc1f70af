// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VoxelLayers.h
 * @brief Layers of a label map as ranks, and a loop over the voxels of two layers at which labels
 * differ.
 */
#ifndef BoneDecimate_Core_Labels_LabelMap_VoxelLayers_h
#define BoneDecimate_Core_Labels_LabelMap_VoxelLayers_h

#include "Base/LargeArray.h"
#include "CellSurface.h"
#include "LabelImage.h"
#include "LabelRanks.h"

#include <array>
#include <cstddef>

namespace bonedecimate
{
/// Ranks of one layer of voxels, x fastest.
using RankLayer = LargeArray<Index>;

/// The layers of a label map, padded by one voxel of background on all sides on request.
class VoxelLayers
{
public:
  /// @param inMemory The layers that the image holds. Only at the ends of the grid are they padded.
  VoxelLayers(
    const LabelImage& image, const LayerRange& inMemory, const LabelRanks& ranks, bool isPadded);

  Index Width() const { return this->Size[0]; }
  Index Height() const { return this->Size[1]; }
  Index Depth() const { return this->Size[2]; }
  std::size_t VoxelsInALayer() const
  {
    return static_cast<std::size_t>(this->Width()) * static_cast<std::size_t>(this->Height());
  }
  /// The first two coordinates of the first voxel in the grid: -1 or 0.
  Index First() const { return -this->Padding; }
  /// The third coordinate of the first layer in the grid.
  Index FirstLayer() const { return this->FirstZ; }

  void Load(Index layer, RankLayer& ranks) const;

private:
  const LabelImage& Image;
  const LabelRanks& Ranks;
  LayerRange InMemory;
  Index Padding;
  Index FirstZ;
  std::array<Index, 3> Size;
};

/// A voxel and the labels of the cell whose least corner it is; at the end of an axis, labels are
/// repeated.
struct VoxelVisit
{
  std::size_t Voxel; ///< Index in its layer.
  Index X;
  Index Y;
  bool HasCell; ///< False at the ends of the x and y axes.
  CellLabels Labels;
};

/// Calls visit(const VoxelVisit&) for the voxels with different labels, in order of the lower
/// layer.
template <typename Visit>
class DifferentVoxels
{
public:
  DifferentVoxels(const VoxelLayers& layers, const Visit& visit)
    : Width(static_cast<std::size_t>(layers.Width()))
    , Height(static_cast<std::size_t>(layers.Height()))
    , VisitLabels(visit)
    , Differences(this->Width)
  {
  }

  void Run(const RankLayer& lower, const RankLayer& upper)
  {
    for (std::size_t y = 0; y < this->Height; ++y)
    {
      const std::size_t row = y * this->Width;
      const std::size_t next = y + 1 < this->Height ? row + this->Width : row;
      this->Rows = { lower.data() + row, lower.data() + next, upper.data() + row,
        upper.data() + next };
      this->VisitRow(y);
    }
  }

private:
  void VisitRow(std::size_t y)
  {
    this->FindDifferences();
    const std::size_t last = this->Width - 1;
    for (std::size_t x = 0; x < this->Width; ++x)
    {
      if (this->Differences[x] != 0)
      {
        this->VisitVoxel(x, x < last ? x + 1 : x, y);
      }
    }
  }

  /// Sets differences to nonzero where a label differs. Without branches, so that it is vectorized.
  void FindDifferences()
  {
    const auto [a, b, c, d] = this->Rows;
    Index* differences = this->Differences.data();
    const std::size_t last = this->Width - 1;
    for (std::size_t x = 0; x < last; ++x)
    {
      differences[x] = (a[x] ^ b[x]) | (a[x] ^ c[x]) | (a[x] ^ d[x]) | (a[x] ^ a[x + 1]) |
        (a[x] ^ b[x + 1]) | (a[x] ^ c[x + 1]) | (a[x] ^ d[x + 1]);
    }
    differences[last] = (a[last] ^ b[last]) | (a[last] ^ c[last]) | (a[last] ^ d[last]);
  }

  void VisitVoxel(std::size_t x, std::size_t right, std::size_t y)
  {
    const auto [a, b, c, d] = this->Rows;
    this->VisitLabels(VoxelVisit{ y * this->Width + x, static_cast<Index>(x), static_cast<Index>(y),
      right != x && y + 1 < this->Height,
      { a[x], a[right], b[x], b[right], c[x], c[right], d[x], d[right] } });
  }

  std::size_t Width;
  std::size_t Height;
  const Visit& VisitLabels;
  std::array<const Index*, 4> Rows = {};
  LargeArray<Index> Differences;
};

template <typename Visit>
void VisitDifferentVoxels(
  const VoxelLayers& layers, const RankLayer& lower, const RankLayer& upper, const Visit& visit)
{
  DifferentVoxels<Visit>(layers, visit).Run(lower, upper);
}
}

#endif
