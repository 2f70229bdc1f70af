// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Where columns of voxel centers cross triangles, against integers of any size with a displacement
// that is really made.
#include "Labels/VoxelGuard/ColumnCrossing.h"
#include "Random.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

#include <algorithm>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
using Big = boost::multiprecision::cpp_int;
using BigPoint = std::array<Big, 3>;

/// e^3 = 1, e^2 = 2^200, e = 2^400, a unit of 2^-30 voxel = 2^600: coefficients of powers of e have
/// less than 128 bits.
BigPoint Scaled(const FixedPoint& point)
{
  return { Big(point[0]) << 600, Big(point[1]) << 600, Big(point[2]) << 600 };
}

BigPoint DisplacedCenter(const Column& column, std::int64_t height)
{
  BigPoint center;
  center[column.Axis] = (Big(height) << 630) + 1;
  center[(column.Axis + 1) % 3] = (Big(column.S) << 630) + (Big(1) << 400);
  center[(column.Axis + 2) % 3] = (Big(column.T) << 630) + (Big(1) << 200);
  return center;
}

int Sign(const Big& value)
{
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

Big AreaAlong(const BigPoint& a, const BigPoint& b, const BigPoint& c, std::size_t axis)
{
  const std::size_t s = (axis + 1) % 3;
  const std::size_t t = (axis + 2) % 3;
  return (b[s] - a[s]) * (c[t] - a[t]) - (b[t] - a[t]) * (c[s] - a[s]);
}

Big VolumeAt(const std::array<BigPoint, 3>& corners, const BigPoint& p)
{
  Big volume = 0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    volume += AreaAlong(corners[0], corners[1], corners[2], k) * (p[k] - corners[0][k]);
  }
  return volume;
}

FixedBox BoxOf(const FixedTriangle& corners)
{
  FixedBox box(corners[0]);
  box.Add(corners[1]);
  box.Add(corners[2]);
  return box;
}

ColumnCrossing Expected(const FixedTriangle& fixed, const Column& column)
{
  const std::array<BigPoint, 3> corners = { Scaled(fixed[0]), Scaled(fixed[1]), Scaled(fixed[2]) };
  const BigPoint p = DisplacedCenter(column, 0);
  const int sign = Sign(AreaAlong(corners[0], corners[1], corners[2], column.Axis));
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (sign == 0 || Sign(AreaAlong(corners[i], corners[(i + 1) % 3], p, column.Axis)) != sign)
    {
      return {};
    }
  }
  const FixedBox box = BoxOf(fixed);
  std::int64_t below = CenterAtOrBelow(box.Low[column.Axis]) - 2;
  while (Sign(VolumeAt(corners, DisplacedCenter(column, below + 1))) == -sign)
  {
    ++below;
  }
  return { sign, below };
}

/// Expects exact crossings of every column in and around the triangle.
void ExpectExact(const FixedTriangle& corners)
{
  const FixedBox box = BoxOf(corners);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t s = (axis + 1) % 3;
    const std::size_t t = (axis + 2) % 3;
    for (std::int64_t i = CenterAtOrBelow(box.Low[s]); i <= CenterAtOrAbove(box.High[s]); ++i)
    {
      for (std::int64_t j = CenterAtOrBelow(box.Low[t]); j <= CenterAtOrAbove(box.High[t]); ++j)
      {
        const Column column = { axis, i, j };
        const ColumnCrossing expected = Expected(corners, column);
        const ColumnCrossing found = CrossColumn(corners, box, column);
        ASSERT_EQ(found.Sign, expected.Sign) << axis << " " << i << " " << j;
        ASSERT_TRUE(found.Sign == 0 || found.Below == expected.Below)
          << axis << " " << i << " " << j << ": " << found.Below << ", not " << expected.Below;
      }
    }
  }
}

FixedTriangle RandomTriangle(Random& random, const FixedPoint& corner, Index voxels, Index steps)
{
  FixedTriangle corners;
  for (FixedPoint& point : corners)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::int64_t step = random.Below(voxels * steps + 1);
      point[k] = corner[k] + step * (UnitsOfVoxel / steps);
    }
  }
  return corners;
}
}

TEST(ColumnCrossings, AreExactOnTrianglesThroughVoxelCenters)
{
  Random random(1);
  for (int i = 0; i < 3000; ++i)
  {
    const Index steps = 1 + random.Below(3); // voxel centers, halves and thirds
    ExpectExact(RandomTriangle(random, { -2 * UnitsOfVoxel, -UnitsOfVoxel, 0 }, 4, steps));
    ASSERT_FALSE(testing::Test::HasFatalFailure());
  }
}

TEST(ColumnCrossings, AreExactOnTrianglesAUnitOffVoxelCenters)
{
  Random random(2);
  for (int i = 0; i < 3000; ++i)
  {
    FixedTriangle corners =
      RandomTriangle(random, { -UnitsOfVoxel, -UnitsOfVoxel, -UnitsOfVoxel }, 3, 1);
    for (FixedPoint& point : corners)
    {
      for (std::int64_t& coordinate : point)
      {
        coordinate += random.Below(3) - 1;
      }
    }
    ExpectExact(corners);
    ASSERT_FALSE(testing::Test::HasFatalFailure());
  }
}

/// As large as the guard allows, with centers in the plane of the triangle or nearly so.
TEST(ColumnCrossings, AreExactOnTheLargestTriangles)
{
  Random random(3);
  for (int i = 0; i < 20000; ++i)
  {
    const FixedPoint corner = { (random.Below(2000000) - 1000000) * UnitsOfVoxel,
      -1500000 * UnitsOfVoxel, 7 * UnitsOfVoxel };
    FixedTriangle corners = RandomTriangle(random, corner, 1024, 1);
    FixedPoint& bent = corners[static_cast<std::size_t>(random.Below(3))];
    bent[static_cast<std::size_t>(random.Below(3))] += random.Below(3) - 1;
    const FixedBox box = BoxOf(corners);
    const std::size_t axis = static_cast<std::size_t>(random.Below(3));
    const FixedPoint& near = corners[static_cast<std::size_t>(random.Below(3))];
    const std::size_t s = (axis + 1) % 3;
    const std::size_t t = (axis + 2) % 3;
    const bool isNear = random.Below(2) == 0;
    const auto index = [&](std::size_t k)
    {
      const Index planes = static_cast<Index>(CenterLattice().NumberOfPlanes(box, k));
      return isNear ? CenterAtOrAbove(near[k])
                    : CenterAtOrAbove(box.Low[k]) + random.Below(std::max(1, planes));
    };
    const Column column = { axis, index(s), index(t) };
    const ColumnCrossing found = CrossColumn(corners, box, column);
    const std::array<BigPoint, 3> big = { Scaled(corners[0]), Scaled(corners[1]),
      Scaled(corners[2]) };
    if (found.Sign != 0)
    {
      EXPECT_EQ(Sign(VolumeAt(big, DisplacedCenter(column, found.Below))), -found.Sign);
      EXPECT_EQ(Sign(VolumeAt(big, DisplacedCenter(column, found.Below + 1))), found.Sign);
    }
    const BigPoint p = DisplacedCenter(column, 0);
    bool isCrossed = true;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const int side = Sign(AreaAlong(big[k], big[(k + 1) % 3], p, axis));
      isCrossed = isCrossed && side == Sign(AreaAlong(big[0], big[1], big[2], axis)) && side != 0;
    }
    ASSERT_EQ(found.Sign != 0, isCrossed) << i;
  }
}

TEST(ColumnCrossings, OfTheSixTrianglesAroundAPointAreOneOnEveryColumn)
{
  const FixedPoint center = { 0, 0, 0 };
  const std::array<std::array<int, 2>, 6> ring = { { { 2, 0 }, { 2, 2 }, { 0, 2 }, { -2, 0 },
    { -2, -2 }, { 0, -2 } } };
  const auto at = [](const std::array<int, 2>& st) -> FixedPoint {
    return { UnitsOfVoxel / 2, st[0] * UnitsOfVoxel, st[1] * UnitsOfVoxel };
  };
  for (std::int64_t s = -1; s <= 1; ++s)
  {
    for (std::int64_t t = -1; t <= 1; ++t)
    {
      int sum = 0;
      for (std::size_t i = 0; i < 6; ++i)
      {
        const FixedTriangle corners = { center, at(ring[i]), at(ring[(i + 1) % 6]) };
        sum += CrossColumn(corners, BoxOf(corners), { 0, s, t }).Sign;
      }
      // displaced out of the ring; (-1, 1) is displaced into it
      const bool isInside = s != 1 || t != -1;
      EXPECT_EQ(sum, isInside ? 1 : 0) << s << " " << t;
    }
  }
}
