// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/NearSurface.h"
#include "Run/Decimate.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bonedecimate::testsupport
{
namespace
{
std::array<Vector3, 3> CornersOf(const Surface& surface, const Triangle& c)
{
  return { surface.Points[c[0]], surface.Points[c[1]], surface.Points[c[2]] };
}

/// mm, from points all over the triangle to the surface: too large by at most the distance between
/// them.
double SampledDistance(const std::array<Vector3, 3>& corners, const Surface& surface, int steps)
{
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i)
  {
    for (int j = 0; i + j <= steps; ++j)
    {
      const double u = static_cast<double>(i) / steps;
      const double v = static_cast<double>(j) / steps;
      const Vector3 p = (1.0 - u - v) * corners[0] + u * corners[1] + v * corners[2];
      for (const Triangle& c : surface.Triangles)
      {
        const auto [a, b, d] = CornersOf(surface, c);
        least = std::min(least, NearestOnTriangle(p, a, b, d).SquaredDistance);
      }
    }
  }
  return std::sqrt(least);
}

Options ErrorOf(double error)
{
  Options options;
  options.MaximumError = error;
  options.NumberOfThreads = 1;
  return options;
}
}

TEST(NearSurface, MissesNothingAndIsAtMostAQuarterTooEarly)
{
  const Surface ball = Icosphere(1, 3.0);
  const Surface soup = RandomSoup(60, 80, 4);
  const BoundingTree tree(ball);
  int near = 0;
  for (const Triangle& c : soup.Triangles)
  {
    const std::array<Vector3, 3> corners = CornersOf(soup, c);
    const double distance = SampledDistance(corners, ball, 30);
    for (const double limit : { 0.1, 0.5, 1.0 })
    {
      const bool isNear = MayComeNear(tree, corners, limit);
      near += isNear ? 1 : 0;
      EXPECT_TRUE(isNear || distance > limit) << distance << " " << limit;
      EXPECT_TRUE(!isNear || distance <= 1.25 * limit + 0.2) << distance << " " << limit;
    }
  }
  EXPECT_GT(near, 10);
}

TEST(NearSurface, LeavesOutTrianglesWithoutUsableCorners)
{
  Surface broken = SingleTriangle();
  broken.Triangles.push_back({ 0, 1, 7 });
  broken.Triangles.push_back({ 0, 1, None });
  broken.Points.emplace_back(0.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
  broken.Triangles.push_back({ 0, 1, static_cast<Index>(broken.Points.size() - 1) });
  EXPECT_EQ(TrianglesNear(broken, broken, 1.0, 1), (std::vector<char>{ 1, 0, 0, 0 }));
  EXPECT_EQ(UsableTriangles(broken).Triangles.size(), 1u);
  EXPECT_EQ(TrianglesNear(broken, {}, 1.0, 1), (std::vector<char>{ 0, 0, 0, 0 }));
}

/// A wall through the middle of a part, of which another run has the wall.
TEST(NearSurface, NewFacesKeepTheirDistanceFromNeighborsAndFacesWithinItStay)
{
  const double distance = 1.0;
  const Surface plate = HeightField(24, 0.1, 5);
  Surface wall;
  wall.Points = { { 12.0, -1.0, -2.0 }, { 12.0, 30.0, -2.0 }, { 12.0, -1.0, 40.0 } };
  wall.Triangles = { { 0, 1, 2 } };
  SurfacePart part;
  part.Neighbors = &wall;
  part.NeighborDistance = distance;
  RunInputs inputs;
  inputs.Part = &part;
  const Surface result = Decimate(plate, ErrorOf(0.3), {}, inputs).Surface;
  EXPECT_LT(result.Triangles.size(), plate.Triangles.size() / 2);
  std::size_t unchanged = 0;
  for (const Triangle& c : result.Triangles)
  {
    const std::array<Vector3, 3> corners = CornersOf(result, c);
    const bool isNear = SampledDistance(corners, wall, 8) <= distance;
    const bool isOld = std::all_of(corners.begin(), corners.end(),
      [&](const Vector3& p)
      { return std::find(plate.Points.begin(), plate.Points.end(), p) != plate.Points.end(); });
    EXPECT_TRUE(!isNear || isOld);
    unchanged += isNear && isOld ? 1 : 0;
  }
  EXPECT_GE(unchanged, 2u * 24u * 2u); // a cell on each side of the wall, all along
}
}
