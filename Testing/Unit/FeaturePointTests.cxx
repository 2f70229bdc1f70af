// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Run/Input/FeaturePoints.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
constexpr double CosineOf30Degrees = 0.8660254;
constexpr double CosineOf100Degrees = -0.1736482;

bool IsOnEdgeOfUnitCube(const Vector3& p)
{
  const auto isEnd = [](double x) { return x == 0.0 || x == 1.0; };
  return isEnd(p[0]) + isEnd(p[1]) + isEnd(p[2]) >= 2;
}
}

TEST(FeaturePoints, OfACubeAreThoseOfItsTwelveEdges)
{
  for (const Surface& cube : { Cube(4), Unwelded(Cube(4)) })
  {
    const std::vector<bool> found = PointsOnFolds(cube, CosineOf30Degrees);
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      EXPECT_EQ(found[i], IsOnEdgeOfUnitCube(cube.Points[i])) << i;
    }
  }
}

TEST(FeaturePoints, AreNoneWhereNothingFoldsSoFar)
{
  const std::vector<bool> found = PointsOnFolds(Cube(4), CosineOf100Degrees);
  EXPECT_EQ(std::count(found.begin(), found.end(), true), 0);
}

TEST(FeaturePoints, OnBoundariesAreThoseOfTheHoleAndTheRim)
{
  const Surface plate = HoledPlate(9);
  for (const Surface& surface : { plate, Unwelded(plate) })
  {
    const std::vector<bool> found = PointsOnBoundaries(surface);
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      const double x = surface.Points[i][0];
      const double y = surface.Points[i][1];
      const bool isOnRim = x == 0.0 || y == 0.0 || x == 9.0 || y == 9.0;
      const bool isOnHole = x >= 3.0 && x <= 6.0 && y >= 3.0 && y <= 6.0;
      EXPECT_EQ(found[i], isOnRim || isOnHole) << x << " " << y;
    }
  }
  const std::vector<bool> closed = PointsOnBoundaries(Icosphere(2, 1.0));
  EXPECT_EQ(std::count(closed.begin(), closed.end(), true), 0);
}

TEST(FeaturePoints, CountEdgesThatAreNotManifoldAsFolds)
{
  const Surface book = ThreeLeavedBook(3);
  const std::vector<bool> found = PointsOnFolds(book, -1.0);
  EXPECT_EQ(std::count(found.begin(), found.end(), true), 4); // the spine's
}

TEST(FeaturePoints, AreNoneOfWhatIsNoSurface)
{
  Surface broken = Grid(2);
  broken.Triangles[0][0] = 999;
  EXPECT_EQ(PointsOnBoundaries(broken), std::vector<bool>(broken.Points.size(), false));
  EXPECT_TRUE(PointsOnFolds({}, 0.5).empty());
}
