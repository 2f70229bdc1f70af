// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelRanks.h
 * @brief Numbers the labels of a map in ascending order: 0 is the background, 1 the least label.
 */
#ifndef BoneDecimate_Core_Labels_LabelMap_LabelRanks_h
#define BoneDecimate_Core_Labels_LabelMap_LabelRanks_h

#include "Base/Monitor.h"
#include "LabelImage.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bonedecimate
{
/// Values of the map, ascending.
struct LabelValues
{
  std::vector<std::int64_t> Values;
  bool FitInt64 = true;   ///< Whether all do; others are left out.
  bool IsComplete = true; ///< False after an abort.
};
LabelValues FindLabelValues(const LabelImage& image, int threads, const Monitor& monitor);

class LabelRanks
{
public:
  /// @param labels ascending, each once, without the background. All other values count as
  /// background.
  explicit LabelRanks(std::vector<std::int64_t> labels);

  /// Writes the ranks of consecutive voxels.
  void Convert(const LabelImage& image, std::size_t first, std::size_t count, Index* ranks) const;

private:
  template <typename Scalar>
  void ConvertValues(const Scalar* values, std::size_t count, Index* ranks) const;
  Index Find(std::int64_t value) const;

  std::vector<std::int64_t> Labels;
  std::int64_t MinLabel = 0;
  /// Rank of each value from the least label to the largest; empty if this range is too large.
  std::vector<Index> Table;
};
}

#endif
