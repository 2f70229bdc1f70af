// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BruteForce.h"
#include "Mesh/SpatialOrder.h"
#include "Random.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// Bit by bit, from the coarsest to the finest, x before y before z.
std::vector<Index> BruteOrder(const std::vector<Vector3>& points)
{
  Vector3 low = points[0];
  Vector3 high = points[0];
  for (const Vector3& p : points)
  {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double cells = 2038437.618033988 / std::max((high - low).maxCoeff(), 1e-290);
  std::vector<std::vector<int>> positions;
  for (const Vector3& p : points)
  {
    positions.emplace_back();
    for (int bit = 20; bit >= 0; --bit)
    {
      for (Eigen::Index axis = 0; axis < 3; ++axis)
      {
        const double cell = std::floor(std::ldexp((p[axis] - low[axis]) * cells, -bit));
        positions.back().push_back(static_cast<int>(std::fmod(cell, 2.0)));
      }
    }
  }
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](Index p)
  { return std::make_tuple(positions[p], points[p][0], points[p][1], points[p][2]); };
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) < key(b); });
  return order;
}

std::vector<Vector3> RandomPoints(std::size_t count, std::uint64_t seed)
{
  Random random(seed);
  std::vector<Vector3> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    // Half of them in one small corner, many in one cell.
    points.push_back((i % 2 == 0 ? 40.0 : 1e-4) * random.InCube(1));
  }
  return points;
}
}

TEST(SpatialOrder, FollowsTheCurveBitByBit)
{
  EXPECT_TRUE(CurveOrder({}).empty());
  EXPECT_EQ(CurveOrder(RandomPoints(1, 1)), std::vector<Index>(1, 0));
  for (const std::size_t count : { 7U, 600U, 20000U })
  {
    const std::vector<Vector3> points = RandomPoints(count, count);
    const std::vector<Index> expected = BruteOrder(points);
    for (const int threads : { 1, 2, 5 })
    {
      EXPECT_EQ(CurveOrder(points, threads), expected) << count << " points";
    }
  }
}

TEST(SpatialOrder, EqualPointsAndPointsOnALineKeepTheirOrder)
{
  const std::vector<Vector3> same(2000, Vector3(3, 4, 5));
  std::vector<Index> expected(same.size());
  std::iota(expected.begin(), expected.end(), 0);
  EXPECT_EQ(CurveOrder(same), expected);
  std::vector<Vector3> line;
  for (int i = 0; i < 2000; ++i)
  {
    line.emplace_back(0, 0, i);
  }
  EXPECT_EQ(CurveOrder(line), expected);
}

TEST(SpatialOrder, MillimetersOrMetersGiveTheSameOrder)
{
  // Random positions, and regular rows whose coordinates are simple fractions of the box.
  for (std::vector<Vector3> points : { RandomPoints(3000, 6), Cube(16).Points, Grid(40).Points })
  {
    const std::vector<Index> expected = CurveOrder(points);
    std::for_each(points.begin(), points.end(), [](Vector3& p) { p *= 0.001; });
    EXPECT_EQ(CurveOrder(points), expected);
  }
}

TEST(SpatialOrder, ScaleByPowersOfTwoAndExactTranslationChangeNothing)
{
  std::vector<Vector3> points = RandomPoints(3000, 5);
  for (Vector3& p : points)
  {
    p = (p * 1048576.0).array().round().matrix() / 1048576.0;
  }
  const std::vector<Index> expected = CurveOrder(points);
  for (const double factor : { 0x1p-900, 0x1p-10, 0x1p12, 0x1p600 })
  {
    std::vector<Vector3> scaled = points;
    std::for_each(scaled.begin(), scaled.end(), [&](Vector3& p) { p *= factor; });
    EXPECT_EQ(CurveOrder(scaled), expected) << factor;
  }
  std::for_each(
    points.begin(), points.end(), [&](Vector3& p) { p += Vector3(4096.0, -2048.0, 512.5); });
  EXPECT_EQ(CurveOrder(points), expected);
}

TEST(SpatialOrder, TheMapsGoAlongWithPointsAndTriangles)
{
  std::vector<NamedSurface> shapes = AllShapes();
  shapes.push_back({ "Soup", Unwelded(Icosphere(2, 7.0)) });
  for (const auto& [name, input] : shapes)
  {
    SCOPED_TRACE(name);
    const CleanSurface before = Clean(input, true);
    CleanSurface after = before;
    SortAlongCurve(after, 2);
    ASSERT_EQ(after.Surface.Points.size(), before.Surface.Points.size());
    for (std::size_t p = 0; p < after.InputPoint.size(); ++p)
    {
      const Index old = before.PointOfInput[after.InputPoint[p]];
      EXPECT_EQ(after.PointOfInput[after.InputPoint[p]], static_cast<Index>(p));
      EXPECT_EQ(after.Surface.Points[p], before.Surface.Points[old]);
      EXPECT_EQ(after.InputPointCount[p], before.InputPointCount[old]);
    }
    for (std::size_t i = 0; i < input.Points.size(); ++i)
    {
      EXPECT_EQ(after.PointOfInput[i] == None, before.PointOfInput[i] == None);
    }
    // corners from the least one on, then old index
    std::vector<std::pair<Triangle, Index>> positions;
    for (std::size_t t = 0; t < after.Surface.Triangles.size(); ++t)
    {
      const Triangle& corners = after.Surface.Triangles[t];
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Index inputPoint = input.Triangles[after.InputTriangle[t]][k];
        EXPECT_EQ(after.PointOfInput[inputPoint], corners[k]);
      }
      Triangle fromLeast = corners;
      std::rotate(
        fromLeast.begin(), std::min_element(fromLeast.begin(), fromLeast.end()), fromLeast.end());
      positions.emplace_back(fromLeast, after.InputTriangle[t]);
    }
    EXPECT_EQ(positions.size(), before.Surface.Triangles.size());
    EXPECT_TRUE(std::is_sorted(positions.begin(), positions.end()));
  }
}
