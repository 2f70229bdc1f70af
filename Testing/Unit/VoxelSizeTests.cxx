// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The voxel size of a surface, and the error presets.
#include "Mesh/SurfaceAssembly.h"
#include "Run/Input/VoxelSize.h"
#include "Run/Report/Report.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// Where a bumpy ball cuts the edges of a grid, as marching cubes would put its vertices; no
/// triangles.
Surface CutsOfAGrid(const Vector3& spacing, const Vector3& origin)
{
  const auto value = [](const Vector3& p)
  {
    return p.norm() - 10.0 - 0.7 * std::sin(p[0]) * std::cos(0.8 * p[1]) -
      0.3 * std::sin(1.3 * p[2]);
  };
  const auto at = [&](const Eigen::Vector3i& i)
  { return Vector3(origin + spacing.cwiseProduct(i.cast<double>())); };
  Surface surface;
  const Eigen::Vector3i size = (24.0 * spacing.cwiseInverse()).cast<int>();
  for (int x = 0; x < size[0]; ++x)
  {
    for (int y = 0; y < size[1]; ++y)
    {
      for (int z = 0; z < size[2]; ++z)
      {
        const Vector3 a = at({ x, y, z });
        for (int axis = 0; axis < 3; ++axis)
        {
          Vector3 b = a;
          b[axis] = at({ x + 1, y + 1, z + 1 })[axis];
          const double t = value(a) / (value(a) - value(b));
          if (t >= 0.0 && t < 1.0)
          {
            const Vector3 position = a + t * (b - a);
            surface.Points.push_back(RoundedToSingle(position));
          }
        }
      }
    }
  }
  return surface;
}
}

TEST(VoxelSize, IsFoundAlongEachAxisInSinglePrecisionFarFromTheOrigin)
{
  for (const Vector3& spacing :
    { Vector3(0.5, 0.5, 0.5), Vector3(0.9570312, 0.9570312, 1.5), Vector3(0.4, 0.7, 1.25) })
  {
    for (const Vector3& origin : { Vector3(-12.0, -12.0, -12.0), Vector3(-11.9, -12.03, -12.4) })
    {
      Surface cuts = CutsOfAGrid(spacing, origin);
      const VoxelEstimate found = EstimateVoxelSize(cuts);
      EXPECT_TRUE(found.IsFromGrid) << spacing.transpose();
      EXPECT_LT((found.Spacing - spacing).cwiseAbs().maxCoeff(), 1e-3) << found.Spacing.transpose();
      EXPECT_LT(found.RelativeError, 1e-3);
      EXPECT_EQ(found.Least(), found.Spacing.minCoeff());
    }
  }
}

TEST(VoxelSize, FindsNoGridWhereThereIsNone)
{
  Surface turned = CutsOfAGrid({ 0.5, 0.5, 0.5 }, { -12.0, -12.0, -12.0 });
  const Eigen::AngleAxisd turn(0.3, Vector3(1.0, 2.0, 3.0).normalized());
  for (Vector3& p : turned.Points)
  {
    p = turn * p;
  }
  EXPECT_FALSE(EstimateVoxelSize(turned).IsFromGrid);
  EXPECT_FALSE(EstimateVoxelSize(BumpySphere(4, 20.0, 0.1, 5)).IsFromGrid);
}

TEST(VoxelSize, IsThatOfTheEdgesThenWithAStatedError)
{
  const Surface sphere = BumpySphere(4, 20.0, 0.1, 5);
  const VoxelEstimate found = EstimateVoxelSize(sphere);
  EXPECT_GT(found.Least(), 0.5);
  EXPECT_LT(found.Least(), 4.0);
  EXPECT_GE(found.RelativeError, 0.2);
}

TEST(VoxelSize, OfNothingIsNothing)
{
  EXPECT_EQ(EstimateVoxelSize({}).Least(), 0.0);
  Surface bad = Tetrahedron();
  bad.Points[0][1] = std::nan("");
  bad.Triangles.push_back({ 0, -1, 99 });
  EXPECT_TRUE(std::isfinite(EstimateVoxelSize(bad).Least()));
}

TEST(ErrorPreset, IsAFractionOfTheVoxelAndProved)
{
  const Surface input = BumpySphere(4, 20.0, 0.1, 5);
  Options options = InMode(Mode::Fast, Unmeasured());
  options.VoxelSize = 0.5;
  double before = 0.0;
  for (const auto& [preset, error] : { std::pair(ErrorPreset::QuarterVoxel, 0.125),
         std::pair(ErrorPreset::HalfVoxel, 0.25), std::pair(ErrorPreset::OneVoxel, 0.5) })
  {
    options.ErrorPreset = preset;
    const Result result = Decimate(input, options);
    EXPECT_EQ(result.Report.Voxel.From, VoxelFigures::Source::Input);
    EXPECT_EQ(result.Report.Voxel.MaxError, error);
    EXPECT_EQ(result.Report.Proof.Tolerance, error);
    EXPECT_EQ(result.Report.Requested.ErrorPreset, preset);
    EXPECT_TRUE(
      SameBytes(result.Surface, Decimate(input, InMode(Mode::Fast, Error(error))).Surface));
    EXPECT_GT(error, before);
    before = error;
  }
}

TEST(ErrorPreset, IsIgnoredWithASmallerLargestError)
{
  Options options = InMode(Mode::Fast, Error(0.1));
  options.VoxelSize = 1.0;
  options.ErrorPreset = ErrorPreset::OneVoxel;
  EXPECT_EQ(Decimate(BumpySphere(2, 20.0, 0.1, 5), options).Report.Proof.Tolerance, 0.1);
}

TEST(ErrorPreset, ReportsTheEstimatedVoxelSize)
{
  Options options = InMode(Mode::Fast, Unmeasured());
  options.ErrorPreset = ErrorPreset::HalfVoxel;
  const Report report = Decimate(BumpySphere(3, 20.0, 0.1, 5), options).Report;
  EXPECT_EQ(report.Voxel.From, VoxelFigures::Source::Edges);
  EXPECT_GT(report.Voxel.Error, 0.0);
  EXPECT_EQ(report.Proof.Tolerance, 0.5 * report.Voxel.Size);
  const std::vector<std::string> warnings = InputWarnings(report);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].rfind("the surface has no grid of voxels, so their size of ", 0), 0U);
}
