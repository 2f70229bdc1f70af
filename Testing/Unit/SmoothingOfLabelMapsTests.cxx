// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Smoothing of binary surfaces with their grid: nearer to the shape, every voxel kept, thin parts kept.
#include "Crossings.h"
#include "Geometry/BoundingTree.h"
#include "Geometry/TriangleGeometry.h"
#include "SmoothingRuns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// mm, RMS over the centroids of the triangles.
double RmsOf(const Surface& surface, const std::function<double(const Vector3&)>& distance)
{
  double sum = 0.0;
  for (const Triangle& c : surface.Triangles)
  {
    const double d =
      distance((surface.Points[c[0]] + surface.Points[c[1]] + surface.Points[c[2]]) / 3.0);
    sum += d * d;
  }
  return std::sqrt(sum / static_cast<double>(surface.Triangles.size()));
}

/// mm, from the points of one surface that are chosen to the chosen triangles.
double LeastDistanceBetween(const Surface& surface,
  const std::function<bool(const Vector3& centroid, const Vector3& normal)>& isFirst,
  const std::function<bool(const Vector3& centroid, const Vector3& normal)>& isSecond)
{
  Surface first = { surface.Points, {} };
  Surface second = { surface.Points, {} };
  for (const Triangle& c : surface.Triangles)
  {
    const Vector3& a = surface.Points[c[0]];
    const Vector3& b = surface.Points[c[1]];
    const Vector3& d = surface.Points[c[2]];
    const Vector3 normal = AreaVector(a, b, d).normalized();
    const Vector3 centroid = (a + b + d) / 3.0;
    if (isFirst(centroid, normal))
    {
      first.Triangles.push_back(c);
    }
    if (isSecond(centroid, normal))
    {
      second.Triangles.push_back(c);
    }
  }
  double least = 1e9;
  for (const auto& [from, to] : { std::pair(&first, &second), std::pair(&second, &first) })
  {
    const BoundingTree tree(*to);
    for (const Triangle& c : from->Triangles)
    {
      for (const Index corner : c)
      {
        least = std::min(
          least, std::sqrt(tree.FindNearest(surface.Points[corner]).Point.SquaredDistance));
      }
    }
  }
  return least;
}

/// The axis of MarchedShape's oblique shapes.
Vector3 InShape(const Vector3& p)
{
  Vector3 found = Vector3::Zero();
  // Oblique() turns and shifts: find the turned coordinates through its own shapes.
  for (int k = 0; k < 3; ++k)
  {
    double low = -100.0;
    double high = 100.0;
    for (int i = 0; i < 60; ++i)
    {
      const double middle = 0.5 * (low + high);
      const bool isBelow = Oblique([&](const Vector3& q) { return q[k] < middle; })(p);
      (isBelow ? high : low) = middle;
    }
    found[k] = low;
  }
  return found;
}
}

TEST(SmoothingOfLabelMaps, BringsSurfacesNearerToTheShape)
{
  const auto toBall = [](const Vector3& p) { return InShape(p).norm() - 8.0; };
  const auto toTorus = [](const Vector3& p)
  {
    const Vector3 q = InShape(p);
    return std::hypot(std::hypot(q[0], q[1]) - 7.0, q[2]) - 3.0;
  };
  const BinarySurface ball = MarchedShape(Oblique(BallShape(8.0)), 9.0, Cubic);
  const BinarySurface torus = MarchedShape(Oblique(TorusShape(7.0, 3.0)), 11.0, Cubic);
  const std::function<double(const Vector3&)> distances[] = { toBall, toTorus };
  const BinarySurface* surfaces[] = { &ball, &torus };
  for (int i = 0; i < 2; ++i)
  {
    const SmoothedSurface smoothed = SmoothBinary(*surfaces[i], Within(0.25));
    const double before = RmsOf(surfaces[i]->Surface, distances[i]);
    const double after = RmsOf(WithPoints(surfaces[i]->Surface, smoothed.Points), distances[i]);
    EXPECT_LT(after, 0.6 * before) << before;
    EXPECT_LT(smoothed.Figures.AngleAfter, 0.45 * smoothed.Figures.AngleBefore);
    EXPECT_NEAR(smoothed.Figures.VolumeAfter, smoothed.Figures.VolumeBefore,
      0.02 * smoothed.Figures.VolumeBefore);
  }
}

TEST(SmoothingOfLabelMaps, KeepsEveryVoxelWithinOctahedra)
{
  for (const Vector3& spacing : { Cubic, Vector3(0.5, 0.6, 0.9), Vector3(0.957, 0.957, 1.5) })
  {
    for (const IsInsideOf& shape :
      { BallShape(6.0), TorusShape(5.0, 1.6), BoxShape({ 5.0, 4.0, 0.7 }) })
    {
      const BinarySurface binary = MarchedShape(Oblique(shape), 8.0, spacing);
      ASSERT_EQ(CountChangedVoxels(binary, binary.Surface), 0);
      const SmoothedSurface smoothed = SmoothBinary(binary, Within(0.5 * spacing.minCoeff()));
      EXPECT_EQ(CountChangedVoxels(binary, WithPoints(binary.Surface, smoothed.Points)), 0);
      for (std::size_t p = 0; p < smoothed.Points.size(); ++p)
      {
        const GridPoint& c = binary.Source.OfPoint[p];
        const Vector3 halves =
          2.0 * binary.Source.Grid.ToVoxels(smoothed.Points[p]) - Vector3(c[0], c[1], c[2]);
        ASSERT_LT(halves.cwiseAbs().sum(), 1.0 - 0.0015);
      }
    }
  }
}

TEST(SmoothingOfLabelMaps, ChangesVoxelsWithoutOctahedra)
{
  const BinarySurface torus = MarchedShape(Oblique(TorusShape(5.0, 1.6)), 8.0, Cubic);
  SmoothingSettings strong = Within(0.6);
  strong.Strength = 30.0;
  const SmoothedSurface smoothed = Smooth({ torus.Surface }, strong);
  EXPECT_GT(CountChangedVoxels(torus, WithPoints(torus.Surface, smoothed.Points)), 0);
}

TEST(SmoothingOfLabelMaps, OfThickSlicesKeepsEveryVoxelAndIsNearer)
{
  const BinarySurface ball = MarchedShape(Oblique(BallShape(10.0)), 12.0, { 0.5, 0.5, 3.0 });
  const auto toBall = [](const Vector3& p) { return InShape(p).norm() - 10.0; };
  SmoothingSettings settings = Within(1.5);
  settings.InVoxels = true;
  const SmoothedSurface smoothed = SmoothBinary(ball, settings);
  const Surface after = WithPoints(ball.Surface, smoothed.Points);
  EXPECT_EQ(CountChangedVoxels(ball, after), 0);
  EXPECT_LE(smoothed.Figures.MaxDisplacement, 1.5);
  EXPECT_TRUE(smoothed.Figures.IsInVoxels);
  const double inBalls =
    RmsOf(WithPoints(ball.Surface, SmoothBinary(ball, Within(0.25)).Points), toBall);
  EXPECT_LT(RmsOf(after, toBall), 0.75 * inBalls)
    << inBalls << ", at first " << RmsOf(ball.Surface, toBall) << ", strength "
    << smoothed.Figures.Strength;
}

TEST(SmoothingOfLabelMaps, FollowsAGridWithDirections)
{
  const BinarySurface ball = MarchedShape(Oblique(BallShape(5.0)), 6.0, { 0.5, 0.5, 0.8 });
  const std::vector<Vector3> expected = SmoothBinary(ball, Within(0.25)).Points;
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.7, Vector3(3.0, -1.0, 2.0).normalized()).toRotationMatrix();
  BinarySurface turned = ball;
  turned.Source.Grid.Direction = turn;
  turned.Source.Grid.Origin = turn * ball.Source.Grid.Origin;
  for (Vector3& p : turned.Surface.Points)
  {
    p = turn * p;
  }
  const std::vector<Vector3> smoothed = SmoothBinary(turned, Within(0.25)).Points;
  for (std::size_t p = 0; p < expected.size(); ++p)
  {
    ASSERT_LT((turn.transpose() * smoothed[p] - expected[p]).norm(), 1e-9);
  }
}

TEST(SmoothingOfLabelMaps, FindsItsStrengthFromTheGrid)
{
  for (const IsInsideOf& shape : { BallShape(7.0), TorusShape(6.0, 2.5) })
  {
    const BinarySurface binary = MarchedShape(Oblique(shape), 9.0, Cubic);
    const SmoothedSurface smoothed = SmoothBinary(binary, Within(0.25));
    EXPECT_GE(smoothed.Figures.Strength, 1.0);
    EXPECT_LE(smoothed.Figures.Strength, 12.0);
    EXPECT_NE(smoothed.Figures.Strength, 3.0);
    EXPECT_NE(smoothed.Figures.Strength, 5.0);
  }
}

TEST(SmoothingOfLabelMaps, KeepsThinPlatesAndGaps)
{
  const auto isMiddle = [](const Vector3& p)
  {
    const Vector3 q = InShape(p);
    return std::max(std::abs(q[0]), std::abs(q[1])) < 5.0;
  };
  const Vector3 axis = (InShape({ 0, 0, 0 }) - InShape({ 0, 0, 0 })) +
    Vector3(InShape({ 1, 0, 0 })[2] - InShape({ 0, 0, 0 })[2],
      InShape({ 0, 1, 0 })[2] - InShape({ 0, 0, 0 })[2],
      InShape({ 0, 0, 1 })[2] - InShape({ 0, 0, 0 })[2]);
  const auto above = [&](const Vector3& p, const Vector3& n)
  { return isMiddle(p) && n.dot(axis) > 0.2 && std::abs(InShape(p)[2]) < 2.0; };
  const auto below = [&](const Vector3& p, const Vector3& n)
  { return isMiddle(p) && n.dot(axis) < -0.2 && std::abs(InShape(p)[2]) < 2.0; };

  const BinarySurface plate = MarchedShape(Oblique(BoxShape({ 7.0, 7.0, 0.75 })), 11.0, Cubic);
  const Surface thin = WithPoints(plate.Surface, SmoothBinary(plate, Within(0.25)).Points);
  const double before = LeastDistanceBetween(plate.Surface, above, below);
  const double after = LeastDistanceBetween(thin, above, below);
  EXPECT_GE(after, 1.1) << before;
  EXPECT_GT(after, before);

  const auto twoBoxes = [](const Vector3& p)
  {
    return std::max(std::abs(p[0]), std::abs(p[1])) <= 6.7 && std::abs(std::abs(p[2]) - 2.0) <= 1.5;
  };
  const BinarySurface gap = MarchedShape(Oblique(twoBoxes), 11.0, Cubic);
  ASSERT_EQ(CountTopology(gap.Surface).Components, 2);
  const Surface smooth = WithPoints(gap.Surface, SmoothBinary(gap, Within(0.25)).Points);
  const double gapBefore = LeastDistanceBetween(gap.Surface, above, below);
  const double gapAfter = LeastDistanceBetween(smooth, above, below);
  EXPECT_GE(gapAfter, 0.84) << gapBefore;
  EXPECT_GT(gapAfter, gapBefore);
  EXPECT_EQ(CountTopology(smooth).Components, 2);
  EXPECT_GT(LeastDistanceOfComponents(smooth), 0.5);
}

TEST(SmoothingOfLabelMaps, LeavesPointsOutsideOfTheirOctahedronWhereTheyAre)
{
  BinarySurface ball = MarchedShape(Oblique(BallShape(4.0)), 5.0, Cubic);
  ball.Source.OfPoint[10] = { 1, 2, 2 };
  const std::vector<Vector3> smoothed = SmoothBinary(ball, Within(0.25)).Points;
  EXPECT_TRUE(smoothed[10] == ball.Surface.Points[10]);
}

TEST(SmoothingOfLabelMaps, ReportsWhatItChanged)
{
  const BinarySurface ball = MarchedShape(Oblique(BallShape(6.0)), 7.0, Cubic);
  const SmoothedSurface smoothed = SmoothBinary(ball, Within(0.25));
  const Surface after = WithPoints(ball.Surface, smoothed.Points);
  const SmoothingFigures& figures = smoothed.Figures;
  EXPECT_NEAR(figures.AreaBefore, TotalArea(ball.Surface), 1e-9);
  EXPECT_NEAR(figures.AreaAfter, TotalArea(after), 1e-9);
  EXPECT_NEAR(figures.VolumeBefore, SignedVolume(ball.Surface), 1e-9);
  EXPECT_NEAR(figures.VolumeAfter, SignedVolume(after), 1e-9);
  EXPECT_EQ(figures.Bound, 0.25);
  double sum = 0.0;
  double most = 0.0;
  for (std::size_t p = 0; p < after.Points.size(); ++p)
  {
    const double moved = (after.Points[p] - ball.Surface.Points[p]).norm();
    sum += moved * moved;
    most = std::max(most, moved);
  }
  EXPECT_NEAR(figures.RmsDisplacement, std::sqrt(sum / after.Points.size()), 1e-12);
  EXPECT_NEAR(figures.MaxDisplacement, most, 1e-12);
  const SmoothedSurface open = Smooth({ HeightField(5, 0.3, 1) }, Within(0.1));
  EXPECT_EQ(open.Figures.VolumeBefore, 0.0);
}
