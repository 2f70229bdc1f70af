// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/PolygonTriangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

using namespace bonedecimate;

namespace
{
using Points = std::vector<Vector3>;

std::vector<Index> AllOf(const Points& points)
{
  std::vector<Index> corners(points.size());
  std::iota(corners.begin(), corners.end(), 0);
  return corners;
}

std::vector<Triangle> Triangulated(const Points& points)
{
  std::vector<Triangle> triangles;
  PolygonTriangulation(points).Append(AllOf(points), triangles);
  return triangles;
}

Vector3 AreaOf(const Points& points, const Triangle& triangle)
{
  const auto at = [&](std::size_t i) { return points[static_cast<std::size_t>(triangle[i])]; };
  return (at(1) - at(0)).cross(at(2) - at(0)) / 2.0;
}

Vector3 AreaOf(const Points& polygon)
{
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 2; i < polygon.size(); ++i)
  {
    sum += (polygon[i - 1] - polygon[0]).cross(polygon[i] - polygon[0]) / 2.0;
  }
  return sum;
}

/// n - 2 triangles, the sides of the polygon once each, every other edge once in each direction.
void ExpectDisk(const Points& polygon, const std::vector<Triangle>& triangles)
{
  ASSERT_EQ(triangles.size() + 2, polygon.size());
  std::map<std::pair<Index, Index>, int> edges;
  Vector3 area = Vector3::Zero();
  for (const Triangle& triangle : triangles)
  {
    area += AreaOf(polygon, triangle);
    for (std::size_t i = 0; i < 3; ++i)
    {
      ++edges[{ triangle[i], triangle[(i + 1) % 3] }];
    }
  }
  const auto count = static_cast<Index>(polygon.size());
  for (const auto& [edge, uses] : edges)
  {
    const bool isSide = edge.second == (edge.first + 1) % count;
    EXPECT_EQ(uses, 1);
    EXPECT_EQ(edges.count({ edge.second, edge.first }), isSide ? 0U : 1U);
  }
  EXPECT_NEAR((area - AreaOf(polygon)).norm(), 0.0, 1e-9 * (1.0 + area.norm()));
}

/// Requires a simple polygon in a plane, in which no triangle is turned and so none overlap.
void ExpectNoOverlap(const Points& polygon, const std::vector<Triangle>& triangles)
{
  ExpectDisk(polygon, triangles);
  double sum = 0.0;
  for (const Triangle& triangle : triangles)
  {
    sum += AreaOf(polygon, triangle).norm();
  }
  EXPECT_NEAR(sum, AreaOf(polygon).norm(), 1e-9 * sum);
}

/// Corners at random distances around a center, in a tilted plane; many of them are reflex.
Points Star(std::size_t corners, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> radius(1.0, 10.0);
  const Vector3 u = Vector3(2.0, 1.0, 0.5).normalized();
  const Vector3 v = Vector3(0.3, 1.0, -2.0).cross(u).normalized();
  Points points;
  for (std::size_t i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(corners);
    points.push_back(radius(random) * (std::cos(angle) * u + std::sin(angle) * v));
  }
  return points;
}

/// Teeth of unit width, as long as half of their number.
Points Comb(std::size_t teeth)
{
  Points points = { { 2.0 * static_cast<double>(teeth), -1.0, 0.0 } };
  for (std::size_t i = teeth; i-- > 0;)
  {
    const double x = 2.0 * static_cast<double>(i);
    const double height = static_cast<double>(teeth) / 2.0;
    points.emplace_back(x + 1.9, 0.0, 0.0);
    points.emplace_back(x + 1.5, height, 0.0);
    points.emplace_back(x + 0.5, height, 0.0);
    points.emplace_back(x, 0.0, 0.0);
  }
  points.emplace_back(0.0, -1.0, 0.0);
  return points;
}
}

TEST(PolygonTriangulation, ConcavePolygonsAreCoveredWithoutOverlaps)
{
  for (unsigned int seed = 0; seed < 200; ++seed)
  {
    const Points star = Star(3 + seed % 60, seed);
    SCOPED_TRACE(seed);
    ExpectNoOverlap(star, Triangulated(star));
  }
}

TEST(PolygonTriangulation, LargePolygonsAreCoveredWithoutOverlaps)
{
  for (const Points& polygon : { Star(3000, 7), Comb(1500) })
  {
    ExpectNoOverlap(polygon, Triangulated(polygon));
  }
}

TEST(PolygonTriangulation, NoCornerOfALargeConvexPolygonIsInManyTriangles)
{
  constexpr int count = 4096;
  constexpr int most = 2 * 12 + 2; // two for each round, of which there are log2(count)
  Points circle;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * 3.14159265358979323846 * i / count;
    circle.emplace_back(50.0 * std::cos(angle), 50.0 * std::sin(angle), 0.0);
  }
  std::vector<int> triangles(count, 0);
  for (const Triangle& triangle : Triangulated(circle))
  {
    for (const Index corner : triangle)
    {
      ++triangles[static_cast<std::size_t>(corner)];
    }
  }
  EXPECT_LE(*std::max_element(triangles.begin(), triangles.end()), most);
}

TEST(PolygonTriangulation, BowTiesHaveAsManyTrianglesAsOtherPolygons)
{
  const Points tie = { { 0, 0, 0 }, { 10, 10, 0 }, { 10, 0, 0 }, { 0, 10, 0 } };
  EXPECT_EQ(AreaOf(tie).norm(), 0.0);
  ExpectDisk(tie, Triangulated(tie));
  Points many;
  for (int i = 0; i < 41; ++i)
  {
    const double angle = 2.0 * M_PI * 20.0 * i / 41.0; // every side crosses nearly all others
    many.emplace_back(std::cos(angle), std::sin(angle), 0.1 * std::sin(3.0 * i));
  }
  ExpectDisk(many, Triangulated(many));
}

TEST(PolygonTriangulation, RandomCornersInSpaceAreAllUsed)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-5.0, 5.0);
  for (std::size_t corners = 4; corners < 100; ++corners)
  {
    Points points;
    for (std::size_t i = 0; i < corners; ++i)
    {
      points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
    }
    ExpectDisk(points, Triangulated(points));
  }
}

TEST(PolygonTriangulation, CornersOnAStraightSideBelongToTriangles)
{
  const Points square = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 3, 3, 0 },
    { 3, 3, 0 }, { 0, 3, 0 }, { 0, 1, 0 } };
  std::vector<Triangle> triangles = Triangulated(square);
  EXPECT_EQ(triangles.size(), 5U) << "one corner repeats the one before it";
  for (const Triangle& triangle : triangles)
  {
    EXPECT_GT(AreaOf(square, triangle)[2], 0.0);
  }
}

TEST(PolygonTriangulation, QuadrilateralsAreSplitAtTheReflexCornerOrAlongTheShorterDiagonal)
{
  const Points dart = { { 0, 0, 0 }, { 10, -1, 0 }, { 1, 0, 0 }, { 10, 1, 0 } };
  ExpectNoOverlap(dart, Triangulated(dart));
  const Points kite = { { 0, 0, 0 }, { 1, -1, 0 }, { 9, 0, 0 }, { 1, 1, 0 } };
  for (const Triangle& triangle : Triangulated(kite))
  {
    EXPECT_EQ(std::count(triangle.begin(), triangle.end(), 1), 1);
    EXPECT_EQ(std::count(triangle.begin(), triangle.end(), 3), 1);
  }
}

TEST(PolygonTriangulation, TrianglesDoNotDependOnTheOrigin)
{
  for (const Vector3& step : { Vector3(4096.0, -1024.0, 512.0), Vector3(-65536.0, 0.0, 8.0) })
  {
    Points star = Star(50, 11);
    for (Vector3& point : star)
    {
      point = (point * 1024.0).array().round() / 1024.0; // so that moving them is exact
    }
    Points moved = star;
    for (Vector3& point : moved)
    {
      point += step;
    }
    EXPECT_EQ(Triangulated(star), Triangulated(moved));
  }
}

TEST(PolygonTriangulation, FewerThanThreeDifferentCornersHaveNoTriangle)
{
  std::vector<Triangle> triangles;
  const Points points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 0 } };
  PolygonTriangulation triangulation(points);
  EXPECT_FALSE(triangulation.Append({}, triangles));
  EXPECT_FALSE(triangulation.Append({ 0, 1 }, triangles));
  EXPECT_FALSE(triangulation.Append({ 0, 0, 1, 2 }, triangles));
  EXPECT_TRUE(triangles.empty());
}

TEST(PolygonTriangulation, EverySecondTriangleOfAStripIsTurned)
{
  std::vector<Triangle> triangles;
  EXPECT_TRUE(AppendStrip({ 4, 5, 6, 7 }, triangles));
  EXPECT_EQ(triangles, (std::vector<Triangle>{ { 4, 5, 6 }, { 6, 5, 7 } }));
  EXPECT_FALSE(AppendStrip({ 1, 2 }, triangles));
}
