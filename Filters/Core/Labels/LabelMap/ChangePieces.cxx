// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ChangePieces.h"

#include "LabelRanks.h"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace bonedecimate
{
namespace
{
void Apply(const std::vector<VoxelRun>& runs, const LabelImage& image, void* labels)
{
  WithLabelsOf(image,
    [&](const auto* typed)
    {
      using Scalar = std::remove_const_t<std::remove_pointer_t<decltype(typed)>>;
      for (const VoxelRun& run : runs)
      {
        std::fill_n(
          static_cast<Scalar*>(labels) + run.First, run.Count, static_cast<Scalar>(run.Label));
      }
    });
}

/// Whether a label of this type can be the background.
bool CanHold(const LabelImage& image, std::int64_t background)
{
  bool holds = false;
  WithLabelsOf(image,
    [&](const auto* typed)
    {
      using Scalar = std::remove_const_t<std::remove_pointer_t<decltype(typed)>>;
      const auto label = static_cast<Scalar>(background);
      holds = static_cast<std::int64_t>(label) == background &&
        (std::is_signed_v<Scalar> || background >= 0);
    });
  return holds;
}

/// Each once, ascending, without the background.
std::vector<std::int64_t> SegmentsOf(std::vector<std::int64_t> labels, std::int64_t background)
{
  std::sort(labels.begin(), labels.end());
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  labels.erase(std::remove(labels.begin(), labels.end(), background), labels.end());
  return labels;
}

bool HasVoxels(const VoxelGrid& grid)
{
  return std::all_of(
    grid.Dimensions.begin(), grid.Dimensions.end(), [](Index count) { return count > 0; });
}
}

//------------------------------------------------------------------------------
PieceCounts ChangePieces(
  const PieceOptions& options, void* labels, LabelType type, const VoxelGrid& grid)
{
  PieceCounts counts;
  const LabelImage image = { labels, type, grid };
  const IslandLimits& islands = options.Islands;
  const bool removes = islands.Size > 0.0 || islands.Area > 0.0 || islands.Volume > 0.0;
  if ((!removes && !(options.CavityVolume > 0.0)) || !HasVoxels(grid))
  {
    return counts;
  }
  const LabelValues found = FindLabelValues(image, 0, {});
  counts.FitInt64 = found.FitInt64; // others would be taken for background
  counts.HoldsBackground = CanHold(image, options.Background);
  if (!counts.FitInt64 || !counts.HoldsBackground)
  {
    return counts;
  }
  const std::vector<std::int64_t> segments =
    SegmentsOf(options.Labels.empty() ? found.Values : options.Labels, options.Background);
  if (removes)
  {
    PieceChanges changes = FindIslands(image, segments, options.Background, islands);
    Apply(changes.Runs, image, labels);
    counts.Islands = std::move(changes.Segments);
  }
  if (options.CavityVolume > 0.0)
  {
    PieceChanges changes = FindCavities(image, segments, options.Background, options.CavityVolume);
    Apply(changes.Runs, image, labels);
    counts.Cavities = std::move(changes.Segments);
  }
  return counts;
}
}
