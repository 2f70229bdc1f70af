// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Grids of a tilted gantry, and of layers with positions of their own.
#include "LabelMaps.h"
#include "Labels/LabelMap/LabelSurfaces.h"
#include "Labels/VoxelGuard/CenterLattice.h"
#include "NoisyBones.h"
#include "Random.h"
#include "Smoothing/Smoothing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
std::vector<VoxelGrid> Grids()
{
  return { UnitGrid(Size), ObliqueGrid(Size, true), ShearedGrid(Size), Uneven(UnitGrid(Size)),
    Uneven(ShearedGrid(Size, true)) };
}

/// mm, by the numbers of the grid alone.
Vector3 CenterOf(const VoxelGrid& grid, const std::array<Index, 3>& voxel)
{
  const double height = grid.Layers.empty() ? grid.Spacing[2] * voxel[2]
                                            : grid.Layers[static_cast<std::size_t>(voxel[2])];
  return grid.Origin + grid.Spacing[0] * voxel[0] * grid.Direction.col(0) +
    grid.Spacing[1] * voxel[1] * grid.Direction.col(1) + height * grid.Direction.col(2);
}
}

TEST(VoxelGrids, VoxelsAreWhereTheirMatrixAndLayersSay)
{
  for (const VoxelGrid& grid : Grids())
  {
    ASSERT_TRUE(grid.IsValid());
    for (const std::array<Index, 3>& voxel :
      { std::array<Index, 3>{ 0, 0, 0 }, { 3, 7, 4 }, { 14, 0, 12 } })
    {
      const Vector3 index(voxel[0], voxel[1], voxel[2]);
      EXPECT_LT((grid.ToMillimeters(index) - CenterOf(grid, voxel)).norm(), 1e-12);
      EXPECT_LT((grid.ToVoxels(CenterOf(grid, voxel)) - index).norm(), 1e-12);
      const Vector3 between = index + Vector3(0.25, -0.5, 0.75);
      EXPECT_LT((grid.ToVoxels(grid.ToMillimeters(between)) - between).norm(), 1e-12);
    }
    const Vector3 outside(-3.5, 20.0, -2.25);
    EXPECT_LT((grid.ToVoxels(grid.ToMillimeters(outside)) - outside).norm(), 1e-12);
  }
}

TEST(VoxelGrids, LayersAreFoundByTheirHeight)
{
  const VoxelGrid grid = Uneven(UnitGrid(Size));
  const CenterLattice lattice(grid);
  const CenterLattice mirrored = lattice.Mirrored();
  for (Index layer = -4; layer < Size[2] + 4; ++layer)
  {
    const double height = grid.StepsOf(layer);
    EXPECT_EQ(grid.FirstLayerAtOrAbove(height), layer);
    EXPECT_EQ(grid.LastLayerAtOrBelow(height), layer);
    EXPECT_EQ(grid.FirstLayerAtOrAbove(height + 1e-9), layer + 1);
    EXPECT_EQ(grid.LastLayerAtOrBelow(height - 1e-9), layer - 1);
    const std::int64_t center = lattice.Coordinate(2, layer);
    EXPECT_EQ(lattice.AtOrAbove(2, center), layer);
    EXPECT_EQ(lattice.AtOrBelow(2, center), layer);
    EXPECT_EQ(lattice.AtOrAbove(2, center + 1), layer + 1);
    EXPECT_EQ(lattice.AtOrBelow(2, center - 1), layer - 1);
    EXPECT_EQ(mirrored.Coordinate(2, mirrored.AtOrBelow(2, -center)), -center);
    EXPECT_EQ(lattice.Coordinate(1, layer), layer * UnitsOfVoxel);
  }
}

TEST(VoxelGrids, AVoxelIsAsThickAsTheWayToTheMiddlesBesideIt)
{
  VoxelGrid grid = UnitGrid({ 2, 2, 5 });
  grid.Layers = { 0.0, 4.0, 8.0, 15.0, 22.0 };
  grid.Spacing[2] = 4.0;
  const std::array<double, 5> thickness = { 4.0, 4.0, 5.5, 7.0, 7.0 };
  for (Index layer = 0; layer < 5; ++layer)
  {
    EXPECT_DOUBLE_EQ(
      grid.ThicknessOf(layer, layer + 1), thickness[static_cast<std::size_t>(layer)]);
  }
  EXPECT_DOUBLE_EQ(grid.ThicknessOf(0, 5), 27.5);
  EXPECT_EQ(grid.MaxSpacing()[2], 7.0);
  EXPECT_EQ(HalfSidesAt(grid, { 1, 0, 4 })[2], 2.0) << "in the layer between both distances";
  EXPECT_EQ(HalfSidesAt(grid, { 0, 0, 5 })[2], 3.5);
}

TEST(VoxelGrids, RejectsNumbersThatAreNone)
{
  const VoxelGrid good = Uneven(ShearedGrid(Size));
  const auto isValid = [&good](const std::function<void(VoxelGrid&)>& change)
  {
    VoxelGrid grid = good;
    change(grid);
    return grid.IsValid();
  };
  EXPECT_TRUE(isValid([](VoxelGrid&) {}));
  EXPECT_FALSE(isValid([](VoxelGrid& grid) { grid.Layers.pop_back(); }));
  EXPECT_FALSE(isValid([](VoxelGrid& grid) { grid.Layers[0] = 0.5; }));
  EXPECT_FALSE(isValid([](VoxelGrid& grid) { std::swap(grid.Layers[3], grid.Layers[4]); }));
  EXPECT_FALSE(isValid([](VoxelGrid& grid) { grid.Layers[4] = std::nan(""); }));
  EXPECT_FALSE(
    isValid([](VoxelGrid& grid) { grid.Layers.back() = std::numeric_limits<double>::infinity(); }));
  EXPECT_FALSE(isValid([](VoxelGrid& grid) { grid.Direction.col(2) *= 0.9; }));
  EXPECT_FALSE(isValid([](VoxelGrid& grid) { grid.Direction.col(2) = grid.Direction.col(1); }));
}

TEST(VoxelGrids, PointsAnywhereInTheirOctahedraKeepEveryLabel)
{
  Random random(11);
  for (const VoxelGrid& grid : Grids())
  {
    const LabelMap map = NoisyBones(grid, 0.8);
    LabelSurfaces surfaces = Extracted(map);
    ASSERT_EQ(surfaces.Status, LabelSurfaceStatus::Good);
    for (std::size_t p = 0; p < surfaces.Surface.Points.size(); ++p)
    {
      const GridPoint& center = surfaces.Source.OfPoint[p];
      const Vector3 half = HalfSidesAt(grid, center);
      int odd = 0;
      Vector3 offset = random.InCube(1.0);
      for (const std::int32_t i : center)
      {
        odd += i % 2 != 0 ? 1 : 0;
      }
      offset *= 0.999 * odd / offset.cwiseAbs().sum();
      surfaces.Surface.Points[p] =
        grid.ToMillimeters(0.5 * Vector3(center[0], center[1], center[2])) +
        grid.Direction * offset.cwiseProduct(half);
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::vector<Index> found = VoxelizeLabels(
        surfaces.Surface, surfaces.Source.OfTriangle, grid, surfaces.Source.Background(), axis);
      for (std::size_t i = 0; i < found.size(); ++i)
      {
        ASSERT_NE(found[i], NoLabel);
        ASSERT_EQ(surfaces.Source.Values[static_cast<std::size_t>(found[i])], map.Labels[i]);
      }
    }
  }
}

TEST(VoxelGrids, SmoothingKeepsEveryLabelAndItsBoundInMillimeters)
{
  for (const bool inVoxels : { false, true })
  {
    for (const VoxelGrid& grid : Grids())
    {
      const LabelMap map = NoisyBones(grid, 0.8);
      const LabelSurfaces surfaces = Extracted(map);
      SmoothingSettings settings;
      settings.Radius = 0.5 * (inVoxels ? grid.MaxSpacing().maxCoeff() : grid.Spacing.minCoeff());
      settings.InVoxels = inVoxels;
      settings.Strength = 20.0;
      const SmoothedSurface smoothed =
        Smooth({ surfaces.Surface, nullptr, &surfaces.Source }, settings);
      double largest = 0.0;
      for (std::size_t p = 0; p < smoothed.Points.size(); ++p)
      {
        largest = std::max(largest, (smoothed.Points[p] - surfaces.Surface.Points[p]).norm());
      }
      EXPECT_LE(largest, settings.Radius);
      EXPECT_GT(largest, 0.2 * grid.Spacing.minCoeff());
      const std::vector<Index> found =
        VoxelizeLabels({ smoothed.Points, surfaces.Surface.Triangles }, surfaces.Source.OfTriangle,
          grid, surfaces.Source.Background(), 1);
      for (std::size_t i = 0; i < found.size(); ++i)
      {
        ASSERT_NE(found[i], NoLabel);
        ASSERT_EQ(surfaces.Source.Values[static_cast<std::size_t>(found[i])], map.Labels[i]);
      }
    }
  }
}
