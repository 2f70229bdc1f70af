// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Run/Input/ComponentCensus.h"
#include "Run/Input/Prune.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace bonedecimate::testsupport
{
namespace
{
/// Every third triangle is of another part.
std::vector<Surface> InParts(const Surface& whole, std::size_t count)
{
  std::vector<Surface> parts(count, Surface{ whole.Points, {} });
  for (std::size_t t = 0; t < whole.Triangles.size(); ++t)
  {
    parts[t / 3 % count].Triangles.push_back(whole.Triangles[t]);
  }
  return parts;
}

SharedPositions AllPositions(const Surface& whole)
{
  std::set<std::array<double, 3>> positions;
  for (const Vector3& p : whole.Points)
  {
    positions.insert({ p[0] + 0.0, p[1] + 0.0, p[2] + 0.0 });
  }
  return { positions.begin(), positions.end() };
}

JoinedCensus CensusOf(const std::vector<Surface>& parts, const SharedPositions& shared)
{
  const Vector3 origin(-3.0, 2.0, 5.0);
  std::vector<CensusOfPart> census;
  for (const Surface& part : parts)
  {
    census.push_back(CensusFrom(NumbersOf(TakeCensus(part, origin, shared, 1))));
  }
  return JoinCensus(census, origin);
}

std::vector<PrunedComponent> Sorted(std::vector<PrunedComponent> components)
{
  std::sort(components.begin(), components.end(),
    [](const PrunedComponent& a, const PrunedComponent& b) { return a.Center.x() < b.Center.x(); });
  return components;
}
}

TEST(ComponentCensus, OfPartsIsThatOfTheWhole)
{
  const Surface whole = Together(BumpySphere(2, 8.0, 0.5, 3),
    Together(Moved(Grid(4), { 20.0, 0.0, 0.0 }), Moved(Cube(2), { 40.0, 0.0, 0.0 })));
  const std::vector<PrunedComponent> expected = Sorted(CensusOf({ whole }, {}).All);
  ASSERT_EQ(expected.size(), 3u);
  EXPECT_TRUE(std::isnan(expected[1].Volume));
  for (const std::size_t count : { 2u, 4u })
  {
    const JoinedCensus joined = CensusOf(InParts(whole, count), AllPositions(whole));
    const std::vector<PrunedComponent> found = Sorted(joined.All);
    ASSERT_EQ(found.size(), 3u);
    EXPECT_EQ(joined.OfComponent.size(), count);
    for (std::size_t i = 0; i < 3; ++i)
    {
      EXPECT_EQ(found[i].Triangles, expected[i].Triangles);
      EXPECT_NEAR(found[i].Area, expected[i].Area, 1e-9);
      EXPECT_NEAR(found[i].Size, expected[i].Size, 1e-12);
      EXPECT_NEAR((found[i].Center - expected[i].Center).norm(), 0.0, 1e-12);
      EXPECT_EQ(std::isnan(found[i].Volume), std::isnan(expected[i].Volume));
      EXPECT_TRUE(std::isnan(found[i].Volume) ||
        std::abs(found[i].Volume - expected[i].Volume) < 1e-9 * expected[0].Volume);
    }
  }
}

TEST(ComponentCensus, AnEdgeOfThreePartsClosesNone)
{
  const Surface cube = Cube(1);
  std::vector<Surface> parts = InParts(cube, 2);
  EXPECT_FALSE(std::isnan(CensusOf(parts, AllPositions(cube)).All[0].Volume));
  parts.push_back({ cube.Points, { cube.Triangles[0] } });
  const JoinedCensus joined = CensusOf(parts, AllPositions(cube));
  ASSERT_EQ(joined.All.size(), 1u);
  EXPECT_TRUE(std::isnan(joined.All[0].Volume));
}
}
