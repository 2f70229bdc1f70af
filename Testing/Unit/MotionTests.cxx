// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Triangles that pass through each other while points move, intersecting neither before nor after.
#include "Smoothing/Motion.h"

#include "Random.h"
#include "SmoothingRuns.h"

#include <gtest/gtest.h>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
constexpr Index Peak = 40; // the middle point of the grid

/// A flat grid of 8 by 8 unit cells with one point raised.
Surface FloorWithPeak(double height)
{
  Surface floor = Grid(8);
  floor.Points[Peak][2] += height;
  return floor;
}

/// Below the peak.
Surface Speck(const Surface& floor, double depth)
{
  const Surface small = Scaled(Tetrahedron(), 0.01);
  return Moved(small, floor.Points[Peak] - Vector3(0.0, 0.0, depth) - small.Points[0]);
}

TriangleCorners At(const TriangleCorners& corners, const Vector3& offset)
{
  return { corners[0] + offset, corners[1] + offset, corners[2] + offset };
}
}

TEST(Motion, KnowsTrianglesThatPass)
{
  const TriangleCorners wall = { Vector3(-1, -1, 0), Vector3(2, -1, 0), Vector3(-1, 2, 0) };
  const TriangleCorners speck = { Vector3(0, 0, 0), Vector3(0.1, 0, 0), Vector3(0, 0.1, 0.05) };
  const Vector3 below(0, 0, -0.5), above(0, 0, 0.5), aside(5, 0, 0.5), farBelow(0, 0, -3);
  EXPECT_FALSE(StayApart({ wall, At(speck, below) }, { wall, At(speck, above) }));
  EXPECT_FALSE(StayApart({ wall, At(speck, above) }, { wall, At(speck, below) }));
  EXPECT_FALSE(StayApart({ At(wall, above), speck }, { At(wall, below), speck }));
  EXPECT_TRUE(StayApart({ wall, At(speck, below) }, { wall, At(speck, farBelow) }));
  EXPECT_TRUE(StayApart({ wall, At(speck, below) }, { At(wall, above), At(speck, above * 0.5) }));
  EXPECT_TRUE(StayApart({ wall, At(speck, aside + below) }, { wall, At(speck, aside + above) }));
}

TEST(Motion, OfNothingKeepsTrianglesApartHoweverNear)
{
  const TriangleCorners wall = { Vector3(100, 0, 0), Vector3(101, 0, 0), Vector3(100, 1, 0) };
  const TrianglesInTime slit = { wall, At(wall, Vector3(0, 0, 1e-14)) };
  ASSERT_FALSE(Meet(PlaneTriangle(slit.First), PlaneTriangle(slit.Second)));
  EXPECT_TRUE(StayApart(slit, slit));
  EXPECT_FALSE(StayApart(slit, { wall, At(wall, Vector3(0.5, 0, 1e-14)) }));
}

TEST(Motion, OfSmoothingEndsWhereWallsAreNearerThanRounding)
{
  const Surface wall = HeightField(6, 0.3, 2);
  SmoothingSettings settings = Within(0.5);
  settings.Strength = 5.0;
  const Surface slit = Together(wall, Moved(wall, { 0.0, 0.0, 1e-14 }));
  EXPECT_EQ(Smooth({ slit }, settings).Points.size(), slit.Points.size());
}

TEST(Motion, IsNeverProvedWhereTrianglesMeetOnTheWay)
{
  Random random(5);
  const auto triangle = [&]
  {
    TriangleCorners corners;
    for (Vector3& corner : corners)
    {
      corner = { random.Between(-1, 1), random.Between(-1, 1), random.Between(-1, 1) };
    }
    return corners;
  };
  int passing = 0, apart = 0;
  for (int run = 0; run < 4000; ++run)
  {
    const TrianglesInTime before = { triangle(), At(triangle(), { 0, 0, 1 }) };
    const TrianglesInTime after = { triangle(), At(triangle(), { 0, 0, 1 }) };
    bool meetsAtEnds = false, meets = false;
    constexpr int steps = 64;
    for (int step = 0; step <= steps; ++step)
    {
      const double time = static_cast<double>(step) / steps;
      TrianglesInTime at;
      for (std::size_t i = 0; i < 3; ++i)
      {
        at.First[i] = (1.0 - time) * before.First[i] + time * after.First[i];
        at.Second[i] = (1.0 - time) * before.Second[i] + time * after.Second[i];
      }
      const bool now = Meet(PlaneTriangle(at.First), PlaneTriangle(at.Second));
      meets = meets || now;
      meetsAtEnds = meetsAtEnds || (now && (step == 0 || step == steps));
    }
    if (meetsAtEnds)
    {
      continue;
    }
    const bool isProved = StayApart(before, after);
    ASSERT_FALSE(isProved && meets) << run;
    passing += meets ? 1 : 0;
    apart += isProved ? 1 : 0;
  }
  EXPECT_GT(passing, 200);
  EXPECT_GT(apart, 500);
}

TEST(Motion, OfSmoothingPassesNoSpeck)
{
  const Surface floor = FloorWithPeak(1.0);
  const Surface speck = Speck(floor, 0.3);
  const Surface both = Together(floor, speck);
  SmoothingSettings settings = Within(2.0);
  settings.Strength = 10.0;
  // Alone the peak sinks below where the speck is.
  const double low = speck.Points[0][2];
  ASSERT_LT(Smooth({ floor }, settings).Points[Peak][2], low);
  const std::vector<Vector3> after = Smooth({ both }, settings).Points;
  const double speckHigh = after[floor.Points.size()][2];
  EXPECT_GT(after[Peak][2], speckHigh);
  EXPECT_LT(after[Peak][2], floor.Points[Peak][2]);
}

TEST(Motion, OfSmoothingPiercesNothingThatItOnlyTouched)
{
  // A pit with a flat floor, which smoothing lifts, and a speck that does not move and stands on
  // the floor with its tip.
  Surface pit = Grid(8);
  for (Vector3& p : pit.Points)
  {
    const bool isFloor = p[0] > 2.5 && p[0] < 5.5 && p[1] > 2.5 && p[1] < 5.5;
    p[2] = isFloor ? -1.0 : 0.0;
  }
  const Vector3 tip(3.75, 3.5, -1.0);
  const Surface speck = { { tip, tip + Vector3(0.1, 0.0, 0.5), tip + Vector3(-0.1, 0.1, 0.5),
                            tip + Vector3(-0.1, -0.1, 0.5) },
    { { 0, 2, 1 }, { 0, 3, 2 }, { 0, 1, 3 }, { 1, 2, 3 } } };
  const Surface both = Together(pit, speck);
  std::vector<double> limits(both.Points.size(), 0.3);
  std::fill(limits.end() - 4, limits.end(), 0.0);
  SmoothingSettings settings = Within(0.3);
  settings.Strength = 5.0;
  const auto floorAtTip = [&](const std::vector<Vector3>& points)
  {
    double height = std::numeric_limits<double>::quiet_NaN();
    for (const Triangle& c : pit.Triangles)
    {
      const Vector3& origin = points[c[0]];
      Eigen::Matrix2d sides;
      sides << (points[c[1]] - origin).head<2>(), (points[c[2]] - origin).head<2>();
      const Eigen::Vector2d at = sides.inverse() * (tip - origin).head<2>();
      const bool isOver = at.minCoeff() >= 0.0 && at.sum() <= 1.0;
      height = isOver
        ? origin[2] + at[0] * (points[c[1]] - origin)[2] + at[1] * (points[c[2]] - origin)[2]
        : height;
    }
    return height;
  };
  EXPECT_GT(floorAtTip(Smooth({ pit }, settings).Points), -0.95);
  EXPECT_LE(floorAtTip(Smooth({ both, &limits }, settings).Points), -1.0);
}
