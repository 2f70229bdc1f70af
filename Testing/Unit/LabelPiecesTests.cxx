// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Islands and cavities of label maps: against brute force, and what each of them becomes.
#include "Labels/LabelMap/ChangePieces.h"

#include "LabelMaps.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <set>
#include <vector>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
using Voxel = std::array<Index, 3>;

constexpr double VoxelVolume = 2.0 * 3.0 * 5.0;

LabelImage ImageOf(const LabelMap& map)
{
  LabelImage image = MakeLabelImage(map.Labels.data(), map.Grid);
  image.Grid.Spacing = { 2.0, 3.0, 5.0 };
  return image;
}

std::size_t IndexOf(const LabelMap& map, const Voxel& v)
{
  const std::array<Index, 3>& size = map.Grid.Dimensions;
  return static_cast<std::size_t>((v[2] * size[1] + v[1]) * size[0] + v[0]);
}

LabelMap Changed(LabelMap map, const PieceChanges& changes)
{
  for (const VoxelRun& run : changes.Runs)
  {
    for (std::size_t i = 0; i < run.Count; ++i)
    {
      map.Labels[run.First + i] = static_cast<std::int32_t>(run.Label);
    }
  }
  return map;
}

/// The voxels connected to one of them, of its label. @param reach 1: by faces; 2: by faces and
/// edges.
std::set<Voxel> PieceAt(const LabelMap& map, const Voxel& first, int reach)
{
  std::set<Voxel> piece = { first };
  std::vector<Voxel> next = { first };
  while (!next.empty())
  {
    const Voxel v = next.back();
    next.pop_back();
    for (int i = 0; i < 27; ++i)
    {
      const Voxel d = { i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1 };
      const Voxel w = { v[0] + d[0], v[1] + d[1], v[2] + d[2] };
      const bool isIn = w[0] >= 0 && w[1] >= 0 && w[2] >= 0 && w[0] < map.Grid.Dimensions[0] &&
        w[1] < map.Grid.Dimensions[1] && w[2] < map.Grid.Dimensions[2];
      if (isIn && std::abs(d[0]) + std::abs(d[1]) + std::abs(d[2]) <= reach &&
        map.Labels[IndexOf(map, w)] == map.Labels[IndexOf(map, v)] && piece.insert(w).second)
      {
        next.push_back(w);
      }
    }
  }
  return piece;
}

/// The pieces of all voxels of a label, by the least voxel of each.
std::map<Voxel, std::set<Voxel>> PiecesOf(const LabelMap& map, int label, int reach)
{
  std::map<Voxel, std::set<Voxel>> pieces;
  for (Index i = 0; i < static_cast<Index>(map.Labels.size()); ++i)
  {
    const std::array<Index, 3>& size = map.Grid.Dimensions;
    const Voxel v = { i % size[0], i / size[0] % size[1], i / size[0] / size[1] };
    if (map.Labels[static_cast<std::size_t>(i)] == label)
    {
      const std::set<Voxel> piece = PieceAt(map, v, reach);
      pieces[*piece.begin()] = piece;
    }
  }
  return pieces;
}

/// A block of 1 with a block of 2 in it, and blocks of 2 beside it, in 0.
LabelMap Blocks()
{
  return MakeLabelMap({ 16, 9, 8 },
    [](const Voxel& v)
    {
      const auto isIn = [&v](Index low, Index high)
      { return v[0] >= low && v[0] <= high && v[1] >= 3 && v[1] <= 4 && v[2] >= 3 && v[2] <= 4; };
      const bool isBlock =
        v[0] >= 1 && v[0] <= 6 && v[1] >= 1 && v[1] <= 6 && v[2] >= 1 && v[2] <= 6;
      return isIn(3, 4) || isIn(9, 9) || isIn(11, 14) ? 2 : isBlock ? 1 : 0;
    });
}
}

TEST(LabelPieces, IslandsGetTheLabelAroundThem)
{
  const LabelMap map = Blocks();
  const PieceChanges changes =
    FindIslands(ImageOf(map), { 1, 2 }, 0, { 0.0, 0.0, 8.5 * VoxelVolume });
  const LabelMap changed = Changed(map, changes);
  EXPECT_EQ(changed.Labels[IndexOf(map, { 3, 3, 3 })], 1);  // within 1
  EXPECT_EQ(changed.Labels[IndexOf(map, { 9, 3, 3 })], 0);  // in the open
  EXPECT_EQ(changed.Labels[IndexOf(map, { 12, 3, 3 })], 2); // the largest
  ASSERT_EQ(changes.Segments.size(), 2U);
  EXPECT_EQ(changes.Segments[0].Pieces, 0);
  EXPECT_EQ(changes.Segments[1].Pieces, 2);
  EXPECT_EQ(changes.Segments[1].Voxels, 8 + 4);
  EXPECT_FALSE(changes.Segments[1].IsLargestTooSmall);
}

TEST(LabelPieces, LimitsOfSizeAndAreaAreThoseOfVoxels)
{
  const LabelMap map = Blocks();
  const auto islands = [&map](const IslandLimits& limits)
  { return FindIslands(ImageOf(map), { 2 }, 0, limits).Segments.front().Pieces; };
  EXPECT_EQ(islands({ 10.0, 0.0, 0.0 }), 0); // two voxels of 5 mm
  EXPECT_EQ(islands({ 10.1, 0.0, 0.0 }), 2);
  const double area = 2.0 * (4.0 * 15.0 + 2.0 * 10.0 + 2.0 * 6.0); // of 1 x 2 x 2 voxels
  EXPECT_EQ(islands({ 0.0, area, 0.0 }), 0);
  EXPECT_EQ(islands({ 0.0, area + 0.1, 0.0 }), 1);
}

TEST(LabelPieces, TheLargestPieceOfASegmentStays)
{
  const LabelMap map = Blocks();
  const PieceChanges changes = FindIslands(ImageOf(map), { 2 }, 0, { 0.0, 0.0, 1e9 });
  EXPECT_EQ(PiecesOf(Changed(map, changes), 2, 1).size(), 1U);
  EXPECT_TRUE(changes.Segments.front().IsLargestTooSmall);
}

TEST(LabelPieces, NoIslandBelowTheLimitIsLeftInNoise)
{
  const LabelMap map = NoiseLabels({ 13, 11, 9 }, 3, 7);
  constexpr std::size_t least = 6;
  const PieceChanges changes =
    FindIslands(ImageOf(map), { 1, 2 }, 0, { 0.0, 0.0, least * VoxelVolume });
  const LabelMap changed = Changed(map, changes);
  std::int64_t voxels = 0;
  for (const SegmentPieces& segment : changes.Segments)
  {
    const auto before = PiecesOf(map, static_cast<int>(segment.Label), 1);
    std::int64_t small = 0;
    for (const auto& [first, piece] : before)
    {
      const bool isGone = changed.Labels[IndexOf(map, first)] != segment.Label;
      small += piece.size() < least ? 1 : 0;
      if (piece.size() >= least)
      {
        EXPECT_FALSE(isGone);
      }
    }
    EXPECT_EQ(segment.Pieces, small);
    voxels += segment.Voxels;
  }
  std::int64_t inRuns = 0;
  for (const VoxelRun& run : changes.Runs)
  {
    inRuns += static_cast<std::int64_t>(run.Count);
  }
  EXPECT_EQ(inRuns, voxels);
}

TEST(LabelPieces, CavitiesAreWhatBruteForceFinds)
{
  const LabelMap map = MakeLabelMap({ 14, 12, 10 },
    [noise = NoiseLabels({ 14, 12, 10 }, 12, 3)](const Voxel& v)
    {
      const int value = noise.Labels[IndexOf(noise, v)];
      return value == 0 ? 0 : v[0] < 7 ? 1 : 2;
    });
  constexpr std::size_t most = 3;
  const PieceChanges changes = FindCavities(ImageOf(map), { 1, 2 }, 0, most * VoxelVolume);
  const LabelMap changed = Changed(map, changes);
  std::map<std::int32_t, std::int64_t> filled;
  for (const auto& [first, piece] : PiecesOf(map, 0, 2))
  {
    std::set<std::int32_t> around;
    for (const Voxel& v : piece)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        for (const Index step : { -1, 1 })
        {
          Voxel w = v;
          w[axis] += step;
          const bool isOut = w[axis] < 0 || w[axis] >= map.Grid.Dimensions[axis];
          around.insert(isOut ? -1 : map.Labels[IndexOf(map, w)]);
        }
      }
    }
    around.erase(0);
    const bool isCavity = around.size() == 1 && *around.begin() > 0 && piece.size() <= most;
    filled[*around.begin()] += isCavity ? 1 : 0;
    for (const Voxel& v : piece)
    {
      EXPECT_EQ(changed.Labels[IndexOf(map, v)], isCavity ? *around.begin() : 0);
    }
  }
  for (const SegmentPieces& segment : changes.Segments)
  {
    EXPECT_GT(segment.Pieces, 3);
    EXPECT_EQ(segment.Pieces, filled[static_cast<std::int32_t>(segment.Label)]);
  }
}

TEST(LabelPieces, OtherLabelsAreNeitherCavitiesNorChanged)
{
  const LabelMap map = Blocks();
  EXPECT_TRUE(FindCavities(ImageOf(map), { 1 }, 0, 1e9).Runs.empty());
  EXPECT_TRUE(FindIslands(ImageOf(map), { 1 }, 0, { 0.0, 0.0, 1e9 }).Runs.empty());
}

TEST(LabelPieces, IslandsAreRemovedBeforeCavitiesAreMeasured)
{
  LabelMap map = MakeLabelMap({ 9, 5, 5 },
    [](const Voxel& v)
    {
      const bool isRow = v[1] == 2 && v[2] == 2;
      const bool isEnd = v[0] == 0 || v[0] == 8 || v[1] % 4 == 0 || v[2] % 4 == 0;
      return isRow && v[0] == 3 ? 0 : isRow && v[0] == 4 ? 2 : isEnd ? 0 : 1;
    });
  map.Labels[0] = map.Labels[1] = 2; // larger than the island in 1
  PieceOptions options = { { 2, 1, 1, 0, 2 }, 0, { 0.0, 0.0, 1.5 }, 1.0 };
  const PieceCounts counts = ChangePieces(options, map.Labels.data(), LabelType::Int32, map.Grid);
  ASSERT_EQ(counts.Islands.size(), 2U); // each label once, and not the background
  EXPECT_EQ(counts.Islands[1].Pieces, 1);
  EXPECT_EQ(counts.Cavities[0].Voxels, 1);
  EXPECT_EQ(map.Labels[IndexOf(map, { 3, 2, 2 })], 1);
  EXPECT_EQ(map.Labels[IndexOf(map, { 4, 2, 2 })], 1);
  EXPECT_EQ(map.Labels[0], 2);
}

TEST(LabelPieces, OfLabelsThatDoNotFitNothingChanges)
{
  std::vector<std::uint64_t> labels(27, 1);
  labels[13] = 1ULL << 63; // no background, but in no signed integer
  VoxelGrid grid;
  grid.Dimensions = { 3, 3, 3 };
  const std::vector<std::uint64_t> before = labels;
  const PieceOptions options = { {}, 0, { 0.0, 0.0, 9.0 }, 9.0 };
  EXPECT_FALSE(ChangePieces(options, labels.data(), LabelType::UInt64, grid).FitInt64);
  EXPECT_EQ(labels, before);
  grid.Dimensions = { 0, 3, 3 };
  EXPECT_TRUE(ChangePieces(options, labels.data(), LabelType::UInt64, grid).Islands.empty());
}
