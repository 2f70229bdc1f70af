// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// What closing tunnels is made of.
#include "Repair/Caps/LeastAreaContour.h"
#include "Repair/Tunnels/EdgeGraph.h"
#include "Repair/Tunnels/WordBasis.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

TEST(WordBasis, KnowsSums)
{
  WordBasis basis;
  EXPECT_FALSE(basis.IsIndependent(0));
  EXPECT_TRUE(basis.Add(0xF0));
  EXPECT_TRUE(basis.Add(0x3C));
  EXPECT_FALSE(basis.IsIndependent(0xF0 ^ 0x3C));
  EXPECT_FALSE(basis.Add(0x3C));
  EXPECT_TRUE(basis.IsIndependent(0x30));
}

TEST(LeastArea, FillsAContourWithoutTheEdgesThatAreNotAllowed)
{
  const std::vector<Vector3> kite = { { 0, 0, 0 }, { 2, -1, 0.5 }, { 4, 0, 0 }, { 2, 1, 0.5 } };
  const auto all = [](Index, Index) { return true; };
  ASSERT_EQ(FillByLeastArea(kite, all).size(), 2U);
  for (const Index low : { 0, 1 })
  {
    const auto triangles =
      FillByLeastArea(kite, [low](Index a, Index b) { return a != low || b != low + 2; });
    ASSERT_EQ(triangles.size(), 2U);
    for (const Triangle& corners : triangles)
    {
      EXPECT_TRUE(std::count(corners.begin(), corners.end(), 1 - low) == 1 &&
        std::count(corners.begin(), corners.end(), 3 - low) == 1);
    }
  }
  EXPECT_TRUE(FillByLeastArea(kite, [](Index, Index) { return false; }).empty());
  EXPECT_TRUE(FillByLeastArea({ kite[0], kite[1] }, all).empty());
}

TEST(EdgeGraph, TellsLoopsThatDivideFromThoseThatDoNot)
{
  constexpr Index across = 8;
  const Surface torus = Torus(12, across);
  const EdgeGraph graph(torus, 1);
  EXPECT_EQ(graph.Genus(), 1);
  EXPECT_EQ(graph.Components(), 1);
  const auto along = [&graph](const std::vector<Index>& loop)
  {
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Index to = loop[(i + 1) % loop.size()];
      const auto* spoke = std::find_if(graph.Begin(loop[i]), graph.End(loop[i]),
        [to](const GraphSpoke& each) { return each.To == to; });
      word ^= graph.Edges()[static_cast<std::size_t>(spoke->Edge)].Signature;
    }
    return word;
  };
  std::vector<Index> strut;
  std::vector<Index> next;
  std::vector<Index> tunnel;
  for (Index j = 0; j < across; ++j)
  {
    strut.push_back(j);
    next.push_back(5 * across + j);
  }
  for (Index i = 0; i < 12; ++i)
  {
    tunnel.push_back(i * across + 3);
  }
  EXPECT_NE(along(strut), 0U);
  EXPECT_EQ(along(strut), along(next));
  EXPECT_NE(along(tunnel), 0U);
  EXPECT_NE(along(tunnel), along(strut));
  for (const Triangle& corners : torus.Triangles)
  {
    EXPECT_EQ(along({ corners.begin(), corners.end() }), 0U);
  }
}

TEST(EdgeGraph, CountsHandlesOfOpenAndOfSeveralSurfaces)
{
  Surface open = Torus(12, 8);
  open.Triangles.pop_back();
  EXPECT_EQ(EdgeGraph(open, 1).Genus(), 1);
  EXPECT_EQ(EdgeGraph(OpenCylinder(8, 4), 1).Genus(), 0);
  const Surface both = Together(Torus(12, 8), Moved(DrilledPlate(), { 50, 0, 0 }));
  EXPECT_EQ(EdgeGraph(both, 1).Genus(), 4);
  EXPECT_EQ(EdgeGraph(both, 1).Components(), 2);
}
