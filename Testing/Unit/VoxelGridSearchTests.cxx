// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The voxel grid of a binary surface, from its points alone.
#include "Run/Input/VoxelGridSearch.h"

#include "LabelShapes.h"
#include "Mesh/SurfaceAssembly.h"
#include "Random.h"
#include "Shapes.h"
#include "Smoothing/Smoothing.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
Surface InSinglePrecision(Surface surface, const Vector3& offset)
{
  for (Vector3& p : surface.Points)
  {
    p = RoundedToSingle(p + offset);
  }
  return surface;
}
}

TEST(VoxelGridSearch, FindsTheGridOfABinarySurface)
{
  for (const Vector3& spacing : { Vector3(0.5, 0.5, 0.5), Vector3(0.9570312, 0.9570312, 1.5) })
  {
    for (const IsInsideOf& shape : { BallShape(7.0), BoxShape({ 6.0, 2.0, 1.0 }) })
    {
      const BinarySurface binary = MarchedShape(Oblique(shape), 8.0, spacing);
      const Vector3 offset(-103.7, 211.3, 17.9);
      const Surface written = Unwelded(InSinglePrecision(binary.Surface, offset));
      const std::optional<LabelMapSource> found = FindVoxelGrid(written);
      ASSERT_TRUE(found);
      EXPECT_LT((found->Grid.Spacing - spacing).norm(), 1e-4);
      EXPECT_TRUE(found->OfTriangle.empty());
      ASSERT_EQ(found->OfPoint.size(), written.Points.size());
      for (std::size_t p = 0; p < written.Points.size(); ++p)
      {
        const GridPoint& at = found->OfPoint[p];
        ASSERT_EQ(std::abs(at[0] % 2) + std::abs(at[1] % 2) + std::abs(at[2] % 2), 1);
        const Vector3 middle = found->Grid.ToMillimeters(0.5 * Vector3(at[0], at[1], at[2]));
        ASSERT_LT((middle - written.Points[p]).norm(), 1e-3);
      }
      // Voxel centers are those of the segmentation.
      const Vector3 ofOrigin = binary.Source.Grid.ToVoxels(found->Grid.Origin - offset);
      EXPECT_LT((ofOrigin - Vector3(ofOrigin.array().round())).norm(), 1e-3);
    }
  }
}

TEST(VoxelGridSearch, FindsARotatedGrid)
{
  const Eigen::Matrix3d rotation =
    (Eigen::AngleAxisd(0.3, Vector3::UnitX()) * Eigen::AngleAxisd(-0.7, Vector3::UnitY()) *
      Eigen::AngleAxisd(0.25 * std::acos(-1.0), Vector3::UnitZ()))
      .toRotationMatrix();
  for (const Vector3& spacing : { Vector3(0.5, 0.5, 0.5), Vector3(0.9570312, 0.9570312, 1.5) })
  {
    for (const IsInsideOf& shape : { BallShape(7.0), BoxShape({ 6.0, 2.0, 1.0 }) })
    {
      Surface turned = MarchedShape(Oblique(shape), 8.0, spacing).Surface;
      for (Vector3& p : turned.Points)
      {
        p = rotation * p;
      }
      const Surface written = InSinglePrecision(turned, Vector3(-103.7, 211.3, 17.9));
      const std::optional<LabelMapSource> found = FindVoxelGrid(written);
      ASSERT_TRUE(found);
      EXPECT_NEAR(found->Grid.Spacing.prod(), spacing.prod(), 1e-4 * spacing.prod());
      EXPECT_NEAR(found->Grid.Direction.determinant(), 1.0, 1e-9);
      for (std::size_t p = 0; p < written.Points.size(); ++p)
      {
        const GridPoint& at = found->OfPoint[p];
        ASSERT_EQ(std::abs(at[0] % 2) + std::abs(at[1] % 2) + std::abs(at[2] % 2), 1);
        const Vector3 middle = found->Grid.ToMillimeters(0.5 * Vector3(at[0], at[1], at[2]));
        ASSERT_LT((middle - written.Points[p]).norm(), 2e-3);
      }
    }
  }
}

TEST(VoxelGridSearch, TakesNoOtherSurfaceForABinaryOne)
{
  const BinarySurface ball = MarchedShape(Oblique(BallShape(7.0)), 8.0, { 0.5, 0.5, 0.5 });
  Surface gray = ball.Surface;
  Random random(5);
  for (std::size_t p = 0; p < gray.Points.size(); ++p)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const bool isAlong = ball.Source.OfPoint[p][axis] % 2 != 0;
      gray.Points[p][axis] += isAlong ? random.Between(-0.24, 0.24) : 0.0;
    }
  }
  EXPECT_FALSE(FindVoxelGrid(InSinglePrecision(gray, Vector3::Zero())));
  SmoothingSettings settings;
  settings.Radius = 0.25;
  Surface smoothed = ball.Surface;
  smoothed.Points = Smooth({ ball.Surface }, settings).Points;
  EXPECT_FALSE(FindVoxelGrid(smoothed));
  for (const NamedSurface& shape : AllShapes())
  {
    const std::optional<LabelMapSource> found = FindVoxelGrid(shape.Surface);
    EXPECT_FALSE(found) << shape.Name;
  }
  EXPECT_FALSE(FindVoxelGrid({}));
  Surface bad = ball.Surface;
  bad.Points[3][1] = std::nan("");
  EXPECT_FALSE(FindVoxelGrid(bad));
}
