// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Options of the extraction of label maps, types of labels, and input that is rejected.
#include "BruteForce.h"
#include "LabelMaps.h"
#include "Labels/LabelMap/LabelSurfaces.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <vector>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
LabelSurfaces Extract(const LabelMap& map, const LabelSurfaceOptions& options = {})
{
  return ExtractLabelSurfaces(MakeLabelImage(map.Labels.data(), map.Grid), options);
}

bool SameResult(const LabelSurfaces& a, const LabelSurfaces& b)
{
  return a.Status == b.Status && SameBytes(a.Surface, b.Surface) &&
    a.Source.OfPoint == b.Source.OfPoint && a.Source.OfTriangle == b.Source.OfTriangle &&
    a.Source.Values == b.Source.Values;
}

LabelMap Replaced(LabelMap map, std::int32_t label, std::int32_t by)
{
  for (std::int32_t& value : map.Labels)
  {
    value = value == label ? by : value;
  }
  return map;
}

template <typename Scalar>
class LabelTypes : public testing::Test
{
};

using AllLabelTypes = testing::Types<signed char, unsigned char, short, unsigned short, int,
  unsigned int, long, unsigned long, long long, unsigned long long>;
}

TYPED_TEST_SUITE(LabelTypes, AllLabelTypes);

TYPED_TEST(LabelTypes, GiveTheSameSurfaces)
{
  const LabelMap map = NoiseLabels({ 6, 7, 5 }, 5, 3);
  const std::vector<TypeParam> labels(map.Labels.begin(), map.Labels.end());
  EXPECT_TRUE(
    SameResult(ExtractLabelSurfaces(MakeLabelImage(labels.data(), map.Grid), {}), Extract(map)));
}

TYPED_TEST(LabelTypes, MayHaveTheLeastAndTheLargestValue)
{
  using Limits = std::numeric_limits<TypeParam>;
  const bool fits = Limits::is_signed || sizeof(TypeParam) < 8;
  const TypeParam largest =
    fits ? Limits::max() : static_cast<TypeParam>(std::numeric_limits<std::int64_t>::max());
  const std::vector<TypeParam> labels = { Limits::min(), largest, 5, 5, 6, 5, 5, 5 };
  VoxelGrid grid;
  grid.Dimensions = { 2, 2, 2 };
  LabelSurfaceOptions options;
  options.Background = 5;
  const LabelSurfaces result = ExtractLabelSurfaces(MakeLabelImage(labels.data(), grid), options);
  EXPECT_EQ(result.Status, LabelSurfaceStatus::Good);
  EXPECT_EQ(result.Source.Values,
    (std::vector<std::int64_t>{
      static_cast<std::int64_t>(Limits::min()), 6, static_cast<std::int64_t>(largest), 5 }));
  const std::vector<Index> voxels =
    VoxelizeLabels(result.Surface, result.Source.OfTriangle, grid, result.Source.Background(), 0);
  EXPECT_EQ(voxels, (std::vector<Index>{ 0, 2, 3, 3, 1, 3, 3, 3 }));
}

TEST(LabelSurfaceOptions, LabelsThatAreNotChosenCountAsBackground)
{
  const LabelMap map = EllipsoidLabels({ 12, 10, 11 });
  LabelSurfaceOptions options;
  options.Labels = { 3, 1, 3 };
  const LabelSurfaces chosen = Extract(map, options);
  EXPECT_EQ(chosen.Source.Values, (std::vector<std::int64_t>{ 1, 3, 0 }));
  EXPECT_TRUE(SameResult(chosen, Extract(Replaced(map, 2, 0))));
}

TEST(LabelSurfaceOptions, ChosenLabelsThatDoNotOccurKeepTheirIndex)
{
  LabelSurfaceOptions options;
  options.Labels = { -4, 1, 2, 3, 1000000000000 };
  const LabelSurfaces chosen = Extract(EllipsoidLabels({ 12, 10, 11 }), options);
  EXPECT_EQ(chosen.Source.Values, (std::vector<std::int64_t>{ -4, 1, 2, 3, 1000000000000, 0 }));
  const LabelSurfaces all = Extract(EllipsoidLabels({ 12, 10, 11 }));
  EXPECT_TRUE(SameBytes(chosen.Surface, all.Surface));
  EXPECT_EQ(chosen.Source.OfTriangle.front()[0], all.Source.OfTriangle.front()[0] + 1);
}

TEST(LabelSurfaceOptions, NegativeLabelsOfAnUnsignedMapDoNotOccur)
{
  const std::vector<std::uint64_t> labels = { std::numeric_limits<std::uint64_t>::max(), 1 };
  VoxelGrid grid;
  grid.Dimensions = { 2, 1, 1 };
  LabelSurfaceOptions options;
  options.Labels = { -1, 1 };
  const LabelSurfaces result = ExtractLabelSurfaces(MakeLabelImage(labels.data(), grid), options);
  EXPECT_EQ(result.Surface.Triangles.size(), 8U) << "one voxel";
}

TEST(LabelSurfaceOptions, TheBackgroundMayBeAnyLabel)
{
  const LabelMap map = EllipsoidLabels({ 12, 10, 11 });
  LabelSurfaceOptions options;
  options.Background = 9;
  EXPECT_TRUE(SameBytes(Extract(Replaced(map, 0, 9), options).Surface, Extract(map).Surface));
  options.Background = 2;
  const LabelSurfaces result = Extract(map, options);
  EXPECT_EQ(result.Source.Values, (std::vector<std::int64_t>{ 0, 1, 3, 2 }));
  EXPECT_EQ(CountTopology(result.Surface).BoundaryEdges, 0);
}

TEST(LabelSurfaceOptions, ADirectionOfSinglePrecisionIsMadeOrthogonal)
{
  LabelMap map = EllipsoidLabels({ 12, 10, 11 });
  map.Grid = ObliqueGrid({ 12, 10, 11 }, true);
  const Eigen::Matrix3d exact = map.Grid.Direction;
  map.Grid.Direction = exact.cast<float>().cast<double>();
  const VoxelGrid grid = Extract(map).Source.Grid;
  EXPECT_LT(
    (grid.Direction.transpose() * grid.Direction - Eigen::Matrix3d::Identity()).norm(), 1e-14);
  EXPECT_LT((grid.Direction - exact).norm(), 1e-6);
  map.Grid.Direction = Eigen::Matrix3d::Identity();
  EXPECT_EQ(Extract(map).Source.Grid.Direction, map.Grid.Direction);
}

TEST(LabelSurfaceStatus, RejectsGridsThatAreNotRectangular)
{
  const LabelMap good = EllipsoidLabels({ 5, 6, 7 });
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<VoxelGrid> grids(6, good.Grid);
  grids[0].Spacing[1] = 0.0;
  grids[1].Spacing[2] = -1.0;
  grids[2].Origin[0] = nan;
  grids[3].Direction(1, 1) = nan;
  grids[4].Direction(0, 1) = 0.01;
  grids[5].Direction *= 0.5;
  for (const VoxelGrid& grid : grids)
  {
    const LabelSurfaces result = ExtractLabelSurfaces(MakeLabelImage(good.Labels.data(), grid), {});
    EXPECT_EQ(result.Status, LabelSurfaceStatus::BadGrid);
    EXPECT_TRUE(result.Surface.Points.empty() && result.Source.Values.empty());
  }
}

TEST(LabelSurfaceStatus, RejectsMapsWithoutVoxelsAndOpenSurfacesOfOneLayer)
{
  LabelMap map = MakeLabelMap({ 4, 1, 4 }, [](const std::array<Index, 3>&) { return 1; });
  EXPECT_EQ(Extract(map).Status, LabelSurfaceStatus::Good);
  LabelSurfaceOptions open;
  open.Closed = false;
  EXPECT_EQ(Extract(map, open).Status, LabelSurfaceStatus::TooThin);
  map.Grid.Dimensions = { 4, 0, 4 };
  EXPECT_EQ(Extract(map).Status, LabelSurfaceStatus::NoVoxels);
  map.Grid.Dimensions = { 4, std::numeric_limits<Index>::max(), 4 };
  EXPECT_EQ(Extract(map).Status, LabelSurfaceStatus::NoVoxels);
}

TEST(LabelSurfaceStatus, RejectsLabelsBeyond64BitsWithSign)
{
  const std::vector<std::uint64_t> labels = { 0, std::numeric_limits<std::uint64_t>::max() };
  VoxelGrid grid;
  grid.Dimensions = { 2, 1, 1 };
  const LabelImage image = MakeLabelImage(labels.data(), grid);
  EXPECT_EQ(ExtractLabelSurfaces(image, {}).Status, LabelSurfaceStatus::LabelOutOfRange);
  LabelSurfaceOptions chosen;
  chosen.Labels = { 1 };
  EXPECT_EQ(ExtractLabelSurfaces(image, chosen).Status, LabelSurfaceStatus::Good);
}

TEST(LabelSurfaceStatus, RejectsGrayValuesUnlessLabelsAreChosen)
{
  std::vector<std::int16_t> values(MaxLabels + 2); // the first is that of the background
  std::iota(values.begin(), values.end(), std::int16_t(0));
  VoxelGrid grid;
  grid.Dimensions = { static_cast<Index>(values.size()), 1, 1 };
  const LabelImage image = MakeLabelImage(values.data(), grid);
  EXPECT_EQ(ExtractLabelSurfaces(image, {}).Status, LabelSurfaceStatus::TooManyLabels);
  LabelSurfaceOptions chosen;
  chosen.Labels = { 1 };
  EXPECT_EQ(ExtractLabelSurfaces(image, chosen).Status, LabelSurfaceStatus::Good);
  values.back() = 0;
  EXPECT_EQ(ExtractLabelSurfaces(image, {}).Status, LabelSurfaceStatus::Good);
}

TEST(LabelSurfaceStatus, HasASentenceForEachProblem)
{
  std::set<std::string> sentences;
  for (int status = 0; status < NumberOfLabelSurfaceStatuses; ++status)
  {
    sentences.insert(LabelSurfaceMessage(static_cast<LabelSurfaceStatus>(status)));
  }
  EXPECT_EQ(sentences.size(), static_cast<std::size_t>(NumberOfLabelSurfaceStatuses));
}

TEST(LabelSurfaceMonitor, ReportsProgressAndMayAbort)
{
  const LabelMap map = NoiseLabels({ 8, 8, 40 }, 3, 4);
  const LabelImage image = MakeLabelImage(map.Labels.data(), map.Grid);
  std::vector<double> progress;
  LabelSurfaceOptions options;
  options.Threads = 2;
  const auto record = [&](double done)
  {
    progress.push_back(done);
    return true;
  };
  EXPECT_TRUE(SameResult(ExtractLabelSurfaces(image, options, record), Extract(map)));
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_EQ(progress.back(), 1.0);
  for (const double limit : { 0.0, 0.3, 0.7 })
  {
    const LabelSurfaces aborted =
      ExtractLabelSurfaces(image, options, [&](double done) { return done <= limit; });
    EXPECT_EQ(aborted.Status, LabelSurfaceStatus::Aborted);
    EXPECT_TRUE(aborted.Surface.Points.empty() && aborted.Surface.Triangles.empty());
  }
}
