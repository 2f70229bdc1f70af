// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Proof/Guard/IntersectingPairs.h"
#include "Proof/Guard/TrianglePair.h"
#include "Shapes.h"

#include <gtest/gtest.h>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
PlaneTriangle PlaneOf(const Surface& surface, std::size_t triangle)
{
  const Triangle& ids = surface.Triangles[triangle];
  return PlaneTriangle({ surface.Points[ids[0]], surface.Points[ids[1]], surface.Points[ids[2]] });
}

std::int64_t CountAllPairs(const Surface& surface)
{
  std::int64_t pairs = 0;
  for (std::size_t a = 0; a < surface.Triangles.size(); ++a)
  {
    for (std::size_t b = a + 1; b < surface.Triangles.size(); ++b)
    {
      pairs +=
        Meet(PlaneOf(surface, a), surface.Triangles[a], PlaneOf(surface, b), surface.Triangles[b])
        ? 1
        : 0;
    }
  }
  return pairs;
}
}

TEST(IntersectingPairs, AreThoseOfAComparisonOfAllPairs)
{
  for (const std::uint64_t seed : { 1, 2, 3, 4, 5, 6 })
  {
    const Surface soup = RandomSoup(60, 40, seed);
    const std::int64_t expected = CountAllPairs(soup);
    EXPECT_GT(expected, 0);
    for (const int threads : { 1, 3 })
    {
      EXPECT_EQ(CountIntersectingPairs(soup, threads), expected);
    }
  }
}

TEST(IntersectingPairs, OfAConvexSurfaceAreNone)
{
  EXPECT_EQ(CountIntersectingPairs(Icosphere(3, 10.0), 2), 0);
  EXPECT_EQ(CountIntersectingPairs(Surface(), 1), 0);
}

TEST(IntersectingPairs, AreUnknownAfterAnAbort)
{
  EXPECT_FALSE(CountIntersectingPairs(Icosphere(3, 10.0), 1, [](double) { return false; }));
}
