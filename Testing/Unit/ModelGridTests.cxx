// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Grids of networks are found in maps that were copied from a coarser one.
#include "CopiedMaps.h"

#include <gtest/gtest.h>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
class CopiedMaps : public testing::TestWithParam<int>
{
};
}

//------------------------------------------------------------------------------
TEST_P(CopiedMaps, AreExplainedByTheirGrid)
{
  for (const std::uint64_t seed : SeedsOfMaps())
  {
    const Copied copied = MakeCopied(seed, this->GetParam());
    const ModelGrid found = FindIn(copied.File);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", labels " + std::to_string(copied.Labels) +
      ", lengths " + std::to_string(copied.Axes[0].Length) + " " +
      std::to_string(copied.Axes[1].Length) + " " + std::to_string(copied.Axes[2].Length) + "; " +
      Describe(found));
    EXPECT_TRUE(found.IsFound);
    EXPECT_EQ(found.Different, 0);
    for (std::size_t k = 0; k < 3; ++k)
    {
      EXPECT_GT(found.Axes[k].Length, 0.97 * copied.Axes[k].Length);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(ModelGrid, CopiedMaps, testing::Values(0, 1, 2));

//------------------------------------------------------------------------------
TEST(ModelGrid, SamplesAreWhereTheConventionPutsThem)
{
  for (const int convention : { 0, 1 })
  {
    Copied copied = MakeCopied(1, convention);
    copied.File.Grid = ObliqueGrid(copied.File.Grid.Dimensions, true);
    const ModelGrid found = FindIn(copied.File);
    ASSERT_TRUE(found.IsFound);
    ASSERT_EQ(found.Grid.Dimensions, copied.Model.Grid.Dimensions);
    const auto* const labels = static_cast<const std::int32_t*>(found.Map().Labels);
    EXPECT_TRUE(std::equal(copied.Model.Labels.begin(), copied.Model.Labels.end(), labels));
    Vector3 first;
    Vector3 last;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double length = copied.Axes[k].Length;
      first[static_cast<Eigen::Index>(k)] = convention == 0 ? 0.0 : 0.5 * length - 0.5;
      last[static_cast<Eigen::Index>(k)] =
        first[static_cast<Eigen::Index>(k)] + length * (copied.Model.Grid.Dimensions[k] - 1.0);
    }
    const auto& [x, y, z] = found.Grid.Dimensions;
    EXPECT_LT((found.Grid.Origin - copied.File.Grid.ToMillimeters(first)).norm(), 1e-9);
    EXPECT_LT((found.Grid.ToMillimeters({ x - 1.0, y - 1.0, z - 1.0 }) -
                copied.File.Grid.ToMillimeters(last))
                .norm(),
      1e-9);
  }
}

TEST(ModelGrid, VoxelsThatWereChangedAfterwardsAreCounted)
{
  Copied copied = MakeCopied(2, 0);
  const LabelMap file = copied.File;
  Random random(5);
  for (int i = 0; i < 20; ++i)
  {
    const auto voxel =
      static_cast<std::size_t>(random.Below(static_cast<Index>(file.Labels.size())));
    copied.File.Labels[voxel] = 121;
  }
  const ModelGrid found = FindIn(copied.File);
  ASSERT_TRUE(found.IsFound) << Describe(found);
  const auto* const labels = static_cast<const std::int32_t*>(found.Map().Labels);
  const auto& [x, y, z] = found.FirstDifferent;
  std::int64_t different = 0;
  for (std::size_t i = 0; i < file.Labels.size(); ++i)
  {
    const auto& size = file.Grid.Dimensions;
    const auto v = static_cast<Index>(i);
    const Voxel voxel = { v % size[0], v / size[0] % size[1], v / size[0] / size[1] };
    Voxel cell;
    for (std::size_t k = 0; k < 3; ++k)
    {
      cell[k] = found.Axes[k].OfLayer[static_cast<std::size_t>(voxel[k])];
    }
    const auto& cells = found.Grid.Dimensions;
    if (labels[(cell[2] * cells[1] + cell[1]) * cells[0] + cell[0]] != copied.File.Labels[i])
    {
      if (different++ == 0)
      {
        EXPECT_EQ(voxel, (Voxel{ x, y, z }));
      }
    }
  }
  EXPECT_GT(different, 0);
  EXPECT_EQ(found.Different, different);
}

TEST(ModelGrid, LayersAsThickAsThoseOfTheModelStay)
{
  Random random(3);
  const LabelMap model = Sampled({ 50, 50, 60 }, Bodies(random, { 50.0, 50.0, 60.0 }, 12));
  const LabelMap file = Copy(model,
    { CopyAxis(random, 0, 50, 2.1), CopyAxis(random, 0, 50, 2.1), CopyAxis(random, 0, 60, 0.4) });
  const ModelGrid found = FindIn(file);
  ASSERT_TRUE(found.IsFound) << Describe(found);
  EXPECT_EQ(found.Grid.Dimensions, (Voxel{ 50, 50, file.Grid.Dimensions[2] }));
  EXPECT_EQ(found.Grid.Spacing[2], 1.0);
  EXPECT_EQ(found.Different, 0);
}

TEST(ModelGrid, UnevenLayersStay)
{
  Copied copied = MakeCopied(4, 1);
  copied.File.Grid = Uneven(copied.File.Grid);
  const ModelGrid found = FindIn(copied.File);
  ASSERT_TRUE(found.IsFound);
  EXPECT_EQ(found.Grid.Layers, copied.File.Grid.Layers);
}

TEST(ModelGrid, RequestedSpacingNeedsNoEvidenceButAnExactCopy)
{
  const LabelMap block = Sampled({ 40, 40, 40 },
    [](const Vector3& p) { return (p.array() >= 8.0).all() && (p.array() < 32.0).all() ? 1 : 0; });
  EXPECT_FALSE(FindIn(block).IsFound);
  const LabelImage image = MakeLabelImage(block.Labels.data(), block.Grid);
  const ModelGrid found = FindModelGrid(image, { Vector3(2.0, 4.0, 1.0) });
  ASSERT_TRUE(found.IsFound);
  EXPECT_EQ(found.Different, 0);
  EXPECT_NEAR(found.Grid.Spacing[0], 2.0, 0.05);
  EXPECT_NEAR(found.Grid.Spacing[1], 4.0, 0.1);
  EXPECT_EQ(found.Grid.Spacing[2], 1.0);
  Random random(1);
  const LabelMap bodies = Sampled({ 40, 40, 40 }, Bodies(random, { 40.0, 40.0, 40.0 }, 9));
  EXPECT_FALSE(
    FindModelGrid(MakeLabelImage(bodies.Labels.data(), bodies.Grid), { Vector3(2.0, 2.0, 2.0) })
      .IsFound);
}

TEST(ModelGrid, IsTheSameForAnyNumberOfThreadsAndAnyType)
{
  const Copied copied = MakeCopied(3, 2);
  const ModelGrid found = FindIn(copied.File);
  const std::vector<std::uint8_t> bytes(copied.File.Labels.begin(), copied.File.Labels.end());
  const ModelGrid same =
    FindModelGrid(MakeLabelImage(bytes.data(), copied.File.Grid), { std::nullopt, 3 });
  ASSERT_TRUE(found.IsFound && same.IsFound);
  EXPECT_EQ(found.Grid.Origin, same.Grid.Origin);
  EXPECT_EQ(found.Grid.Spacing, same.Grid.Spacing);
  EXPECT_EQ(found.Chance, same.Chance);
  const auto* const labels = static_cast<const std::int32_t*>(found.Map().Labels);
  EXPECT_TRUE(std::equal(labels, labels + found.Grid.NumberOfVoxels(),
    static_cast<const std::uint8_t*>(same.Map().Labels)));
}

TEST(ModelGrid, EmptyMapsAndSingleVoxelsHaveNone)
{
  for (const Voxel& size : { Voxel{ 1, 1, 1 }, Voxel{ 30, 1, 1 }, Voxel{ 30, 30, 30 } })
  {
    EXPECT_FALSE(FindIn(MakeLabelMap(size, [](const Voxel&) { return 0; })).IsFound);
  }
}
