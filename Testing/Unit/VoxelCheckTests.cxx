// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Voxelized surfaces compared with label maps.
#include "Labels/LabelMap/VoxelCheck.h"
#include "NoisyBones.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// One label, a box of voxels from 2 to 4 along each axis.
LabelMap Box()
{
  return MakeLabelMap({ 7, 7, 7 },
    [](const std::array<Index, 3>& voxel) -> int
    {
      const auto isIn = [](Index i) { return i >= 2 && i <= 4; };
      return isIn(voxel[0]) && isIn(voxel[1]) && isIn(voxel[2]) ? 3 : 0;
    });
}

VoxelChanges Check(const LabelMap& map, const LabelSurfaces& surfaces, int threads = 1)
{
  return CompareVoxels(MakeLabelImage(map.Labels.data(), map.Grid), surfaces.Source.Values,
    { surfaces.Surface, surfaces.Source.OfTriangle },
    { {}, static_cast<Index>(surfaces.Source.Values.size()), threads });
}
}

TEST(VoxelChecks, CountNoChangeOnExtractedSurfaces)
{
  for (const Map& map : Maps())
  {
    const VoxelChanges changes = Check(map.Voxels, Extracted(map.Voxels));
    EXPECT_TRUE(changes.IsDone);
    EXPECT_EQ(changes.Changed, 0) << map.Name;
    EXPECT_EQ(changes.Compared, static_cast<std::int64_t>(map.Voxels.Labels.size()));
  }
}

TEST(VoxelChecks, CountTheVoxelsOfALabelThatAreLostAndGained)
{
  LabelMap map = Box();
  const LabelSurfaces surfaces = Extracted(map);
  map.Labels[2 + 7 * (3 + 7 * 4)] = 0;
  map.Labels[6 + 7 * (6 + 7 * 6)] = 3;
  map.Labels[0] = 8; // not a label of the surface: background
  const VoxelChanges changes = Check(map, surfaces);
  EXPECT_EQ(changes.Changed, 2);
  EXPECT_EQ(changes.FirstChanged, (std::array<std::int64_t, 3>{ 2, 3, 4 }));
  ASSERT_EQ(changes.OfLabel.size(), 2U);
  EXPECT_EQ(changes.OfLabel[0].Voxels, 27);
  EXPECT_EQ(changes.OfLabel[0].Lost, 1);
  EXPECT_EQ(changes.OfLabel[0].Gained, 1);
  EXPECT_EQ(changes.OfLabel[1].Lost, 1);
  EXPECT_EQ(changes.OfLabel[1].Gained, 1);
}

TEST(VoxelChecks, SeeAMissingSurfaceAndOneOutsideOfTheImage)
{
  const LabelMap map = Box();
  LabelSurfaces surfaces = Extracted(map);
  LabelSurfaces empty = surfaces;
  empty.Surface.Triangles.clear();
  empty.Source.OfTriangle.clear();
  EXPECT_EQ(Check(map, empty).Changed, 27);
  for (Vector3& point : surfaces.Surface.Points)
  {
    point[1] += 40.0;
  }
  EXPECT_EQ(Check(map, surfaces).Changed, 54);
}

/// Every voxel center on the surface: all triangles must agree on which side it is.
TEST(VoxelChecks, AreConsistentWhereCentersLieOnTheSurface)
{
  const LabelMap map = Box();
  LabelSurfaces surfaces = Extracted(map);
  for (Vector3& point : surfaces.Surface.Points)
  {
    point = point.array().round(); // to voxel centers
  }
  const VoxelRows rows({ surfaces.Surface, surfaces.Source.OfTriangle }, map.Grid, 1, 1);
  const VoxelBox box = { { 0, 0, 0 }, { 7, 7, 7 } };
  VoxelRows::Slice slice(rows, box);
  std::vector<Index> labels;
  for (std::int64_t z = 0; z < 7; ++z)
  {
    slice.Begin(z);
    for (std::int64_t y = 0; y < 7; ++y)
    {
      slice.Row(y, false, labels);
      EXPECT_EQ(std::count(labels.begin(), labels.end(), Ambiguous), 0);
      EXPECT_TRUE(labels.back() == None || labels.back() == 1);
    }
  }
}

TEST(VoxelChecks, AreTheSameOnAnyNumberOfThreads)
{
  const LabelMap map = NoisyBones(UnitGrid(Size), 1.0);
  LabelSurfaces surfaces = Extracted(map);
  for (Vector3& point : surfaces.Surface.Points)
  {
    point[0] += 0.7;
  }
  const VoxelChanges expected = Check(map, surfaces);
  EXPECT_GT(expected.Changed, 100);
  const VoxelChanges changes = Check(map, surfaces, 4);
  EXPECT_EQ(changes.Changed, expected.Changed);
  EXPECT_EQ(changes.FirstChanged, expected.FirstChanged);
}

namespace
{
/// A square across rows along the first axis. Forward: from label 0 to the background.
void AddSquare(Surface& surface, double x, double low, double high, bool isForward)
{
  const auto first = static_cast<Index>(surface.Points.size());
  surface.Points.emplace_back(x, low, low);
  surface.Points.emplace_back(x, high, low);
  surface.Points.emplace_back(x, high, high);
  surface.Points.emplace_back(x, low, high);
  const Index second = first + (isForward ? 1 : 3);
  const Index last = first + (isForward ? 3 : 1);
  surface.Triangles.push_back({ first, second, first + 2 });
  surface.Triangles.push_back({ first, first + 2, last });
}
}

/// Two of three squares lie between the same voxels, so that their crossings have no order there.
TEST(VoxelChecks, FindTheFirstLabelOfOpenSurfacesWhereTwoWallsLieBetweenTheSameVoxels)
{
  VoxelCheckSettings settings;
  settings.Threads = 1;
  for (const bool isForward : { false, true })
  {
    Surface reference;
    AddSquare(reference, 2.5, -1.0, 4.0, false);
    Surface result = reference;
    AddSquare(result, 1.25, -1.0, 4.0, isForward);
    AddSquare(result, 1.75, -1.0, 4.0, !isForward);
    const VoxelChanges changes = CompareVoxels({ reference, {} }, { result, {} }, settings);
    EXPECT_GT(changes.Compared, 0);
    EXPECT_EQ(changes.Changed, 0) << isForward;
  }
}

/// Rounding puts the boundary of an open surface to either side of the outermost voxel centers.
TEST(VoxelChecks, LeaveOutTheOutermostVoxelsOfOpenSurfacesWhateverTheRounding)
{
  VoxelCheckSettings settings;
  settings.Grid.Dimensions = { 4, 4, 4 };
  settings.Threads = 1;
  Surface reference;
  Surface result;
  AddSquare(reference, 1.5, -1e-15, 3.0 + 1e-15, true);
  AddSquare(result, 1.5, 1e-15, 3.0 - 1e-15, true);
  EXPECT_EQ(CompareVoxels({ reference, {} }, { result, {} }, settings).Changed, 0);
  result.Points.front()[0] = 3.5;
  EXPECT_GT(CompareVoxels({ reference, {} }, { result, {} }, settings).Changed, 0);
}
