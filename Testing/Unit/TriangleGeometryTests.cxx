// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BruteForce.h"
#include "Geometry/TriangleGeometry.h"
#include "Random.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
using Corners = std::array<Vector3, 3>;

/// Compares the nearest point with brute force and its members with each other. Lengths are of the
/// order of size.
void ExpectNearest(const Vector3& p, const Corners& t, double size)
{
  const PointOnTriangle point = NearestOnTriangle(p, t[0], t[1], t[2]);
  const double tolerance = 1e-12 * size;
  EXPECT_NEAR(
    std::sqrt(point.SquaredDistance), PointTriangleDistance(p, t[0], t[1], t[2]), tolerance);
  EXPECT_NEAR((point.Position - p).norm(), std::sqrt(point.SquaredDistance), tolerance);
  EXPECT_NEAR(point.Weights[0] + point.Weights[1] + point.Weights[2], 1.0, 1e-14);
  Vector3 mixed = Vector3::Zero();
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_GE(point.Weights[i], -1e-15);
    mixed += point.Weights[i] * t[i];
  }
  EXPECT_LE((mixed - point.Position).norm(), tolerance);
}
}

TEST(TriangleGeometry, DotProductsAddTheFirstProductLast)
{
  EXPECT_EQ(Dot({ 1.0, 1e17, -1e17 }, Vector3::Ones()), 1.0) << "from left to right it is 0";
}

TEST(TriangleGeometry, AreaVectorPointsOutwardsAndIsTheArea)
{
  const Vector3 area = AreaVector({ 0, 0, 0 }, { 2, 0, 0 }, { 0, 3, 0 });
  EXPECT_EQ(area, Vector3(0, 0, 3));
}

TEST(TriangleGeometry, NearestPointOfRandomTrianglesAgreesWithBruteForce)
{
  Random random(1);
  for (int i = 0; i < 20000; ++i)
  {
    const Corners t = { random.InCube(1), random.InCube(1), random.InCube(1) };
    ExpectNearest(random.InCube(2), t, 4.0);
  }
}

TEST(TriangleGeometry, NearestPointOfPointsOnTheTriangleIsThePointItself)
{
  Random random(2);
  for (int i = 0; i < 2000; ++i)
  {
    const Corners t = { random.InCube(1), random.InCube(1), random.InCube(1) };
    const double u = random.Uniform();
    const double v = random.Uniform() * (1.0 - u);
    const Vector3 p = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
    EXPECT_LE(NearestOnTriangle(p, t[0], t[1], t[2]).SquaredDistance, 1e-28);
    for (const Vector3& corner : t)
    {
      EXPECT_EQ(NearestOnTriangle(corner, t[0], t[1], t[2]).SquaredDistance, 0.0);
    }
  }
}

TEST(TriangleGeometry, NearestPointOfTrianglesWithoutAreaAgreesWithBruteForce)
{
  Random random(3);
  for (int i = 0; i < 2000; ++i)
  {
    const Vector3 a = random.InCube(1);
    const Vector3 along = random.InCube(1);
    const Vector3 p = random.InCube(2);
    const double s = random.Between(-1, 2);
    for (const Corners& t : { Corners{ a, a, a }, Corners{ a, a + along, a },
           Corners{ a, a, a + along }, Corners{ a + along, a, a },
           Corners{ a, a + along, a + s * along }, Corners{ a, a + s * along, a + along } })
    {
      ExpectNearest(p, t, 4.0);
    }
  }
}

TEST(TriangleGeometry, NearestPointOfNeedlesAgreesWithBruteForce)
{
  Random random(4);
  for (int i = 0; i < 5000; ++i)
  {
    const double width = std::pow(10.0, random.Between(-12, 0));
    const Vector3 a = random.InCube(1);
    const Vector3 along = random.InCube(1);
    const Corners t = { a, a + along, a + random.Uniform() * along + width * random.InCube(1) };
    ExpectNearest(random.InCube(2), t, 4.0);
  }
}

TEST(TriangleGeometry, PointsOnNeedlesAreAtNoDistance)
{
  // 1 mm long and down to a nanometer wide, as marching cubes leaves them where a voxel has just
  // the iso-value.
  Random random(6);
  for (int i = 0; i < 5000; ++i)
  {
    const double width = std::pow(10.0, random.Between(-6, 0)); // mm
    const Corners t = { Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(random.Uniform(), width, 0) };
    const double u = random.Uniform();
    const double v = random.Uniform() * (1.0 - u);
    const Vector3 p = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
    EXPECT_LE(NearestOnTriangle(p, t[0], t[1], t[2]).SquaredDistance, 1e-20) << "width " << width;
  }
}

TEST(TriangleGeometry, NearestPointOfFarPointsKeepsItsDigits)
{
  Random random(5);
  for (int i = 0; i < 2000; ++i)
  {
    const Corners t = { random.InCube(1), random.InCube(1), random.InCube(1) };
    ExpectNearest(1e6 * random.InCube(1), t, 1e6);
  }
}

TEST(TriangleGeometry, FractionStaysOnTheSegment)
{
  const Vector3 a(0, 0, 0);
  const Vector3 b(4, 0, 0);
  EXPECT_EQ(NearestFraction({ -1, 5, 0 }, a, b), 0.0);
  EXPECT_EQ(NearestFraction({ 1, 5, 0 }, a, b), 0.25);
  EXPECT_EQ(NearestFraction({ 9, 5, 0 }, a, b), 1.0);
  EXPECT_EQ(NearestFraction({ 9, 5, 0 }, a, a), 0.0);
}
