// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BruteForce.h"
#include "FilterRun.h"
#include "Runs.h"
#include "Shapes.h"
#include "VtkSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
using Coordinates = std::array<double, 3>;
using Segment = std::pair<Coordinates, Coordinates>;

Coordinates PositionOf(const Surface& surface, Index point)
{
  const Vector3& p = surface.Points[static_cast<std::size_t>(point)];
  return { p[0], p[1], p[2] };
}

/// Both ends of every edge of three or more triangles, and of how many.
std::map<Segment, int> NonManifoldEdges(const Surface& surface)
{
  std::map<Segment, int> edges;
  for (const Triangle& corners : surface.Triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Coordinates a = PositionOf(surface, corners[i]);
      const Coordinates b = PositionOf(surface, corners[(i + 1) % 3]);
      ++edges[{ std::min(a, b), std::max(a, b) }];
    }
  }
  for (auto edge = edges.begin(); edge != edges.end();)
  {
    edge = edge->second < 3 ? edges.erase(edge) : std::next(edge);
  }
  return edges;
}

int TimesThere(const Surface& surface, const Vector3& position)
{
  return static_cast<int>(std::count(surface.Points.begin(), surface.Points.end(), position));
}

class BrokenSurface : public EachShape
{
};
}

TEST_P(BrokenSurface, ComesOutValidWithItsComponentsAndItsBrokenEdges)
{
  const Surface& input = GetParam().Surface;
  FilterRun run(PolyData(input));
  const Surface output = SurfaceOf(run.Output());
  EXPECT_EQ(WhatIsWrong(output), "");
  EXPECT_EQ(CountTopology(output).Components, CountTopology(input).Components);
  EXPECT_EQ(NonManifoldEdges(output), NonManifoldEdges(input));
  EXPECT_TRUE(run.Errors.empty()) << run.AllMessages();
}

TEST_P(BrokenSurface, IsSpokenOfWithTheNumberOfItsBrokenPointsAndTheFirst)
{
  FilterRun run(PolyData(GetParam().Surface));
  const std::string count =
    std::to_string(static_cast<int>(run.Value("input.non_manifold_points")));
  const std::string first =
    std::to_string(static_cast<int>(run.Value("input.first_non_manifold_point")));
  EXPECT_GT(run.Value("input.non_manifold_points"), 0);
  EXPECT_GE(run.Value("input.first_non_manifold_point"), 0);
  EXPECT_EQ(run.Said(count + (count == "1" ? " point stays" : " points stay")), 1)
    << run.AllMessages();
  EXPECT_EQ(run.Said("point " + first), 1) << run.AllMessages();
}

INSTANTIATE_TEST_SUITE_P(Shapes, BrokenSurface, testing::ValuesIn(BrokenShapes()), NameOf);

TEST(NonManifold, EdgePointsKeepTheirPositionsBitForBit)
{
  const Surface book = Moved(ThreeLeavedBook(8), { 0.1, 1e5 / 3, -7.7 });
  FilterRun run(PolyData(book));
  run->SetTargetNumberOfTriangles(1);
  const Surface output = SurfaceOf(run.Output());
  EXPECT_LT(output.Triangles.size(), book.Triangles.size());
  for (std::size_t p = 0; p <= 8; ++p) // the spine
  {
    EXPECT_EQ(TimesThere(output, book.Points[p]), 1) << "point " << p;
  }
  EXPECT_EQ(NonManifoldEdges(output), NonManifoldEdges(book));
}

TEST(NonManifold, PinchedPointKeepsItsPositionAndJoinsBothSides)
{
  const Surface cones = Moved(PinchedVertex(12, 6), { 0.1, 1e5 / 3, -7.7 });
  FilterRun run(PolyData(cones));
  run->SetTargetNumberOfTriangles(1);
  const Surface output = SurfaceOf(run.Output());
  EXPECT_LT(output.Triangles.size(), cones.Triangles.size());
  EXPECT_EQ(TimesThere(output, cones.Points[0]), 1);
  EXPECT_EQ(CountTopology(output).NonManifoldPoints, 1);
  EXPECT_EQ(CountTopology(output).Components, 1);
}

TEST(NonManifold, DuplicateTrianglesStayAsTheyAre)
{
  const Surface surface = DuplicateTriangles(3, 5);
  FilterRun run(PolyData(surface));
  const Surface output = SurfaceOf(run.Output());
  EXPECT_EQ(RepeatedTriangles(output), RepeatedTriangles(surface));
  EXPECT_LT(output.Triangles.size(), surface.Triangles.size() / 5);
}

TEST(ZeroArea, TrianglesAreDroppedWithCountAndFirst)
{
  Surface surface = SurfaceOf(Bumps(2));
  surface.Triangles.insert(surface.Triangles.begin() + 9, { 3, 3, 8 });
  surface.Triangles.insert(surface.Triangles.begin() + 20, { 4, 5, 4 });
  FilterRun run(PolyData(surface));
  run->SetTargetReduction(0.0);
  EXPECT_EQ(run.Triangles(), 320);
  EXPECT_EQ(run.Value("input.triangles_read"), 322);
  EXPECT_EQ(run.Value("input.triangles"), 320);
  EXPECT_EQ(run.Value("input.dropped_triangles"), 2);
  EXPECT_EQ(run.Value("input.first_dropped_triangle"), 9);
  EXPECT_EQ(run.Value("output.boundary_edges"), 0);
}

TEST(ZeroArea, TrianglesAreSpokenOf)
{
  Surface surface = SurfaceOf(Bumps(2));
  surface.Triangles.insert(surface.Triangles.begin() + 9, { 3, 3, 8 });
  surface.Triangles.insert(surface.Triangles.begin() + 20, { 4, 5, 4 });
  FilterRun run(PolyData(surface));
  run.Output();
  EXPECT_EQ(run.Said("2 triangles"), 1) << run.AllMessages();
  EXPECT_EQ(run.Said("triangle 9"), 1) << run.AllMessages();
}

TEST(ZeroArea, AFragmentOfTwoTrianglesStays)
{
  const Surface surface = Together(Envelope(), Moved(SurfaceOf(Bumps(2)), { 40.0, 0.0, 0.0 }));
  FilterRun run(PolyData(surface));
  run->SetTargetNumberOfTriangles(1);
  const Surface output = SurfaceOf(run.Output());
  EXPECT_EQ(CountTopology(output).Components, 2);
  EXPECT_EQ(RepeatedTriangles(output), 1);
}
