// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BruteForce.h"
#include "Random.h"
#include "Repair/Diagnostics/Diagnostics.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// The diagnostic of that kind; its count is 0 if there is none.
Diagnostic Found(const Surface& surface, DiagnosticKind kind)
{
  for (Diagnostic& diagnostic : Diagnose(surface, 1))
  {
    if (diagnostic.Kind == kind)
    {
      return diagnostic;
    }
  }
  return { kind };
}

std::int64_t Count(const Surface& surface, DiagnosticKind kind)
{
  return Found(surface, kind).Count;
}

std::vector<DiagnosticKind> KindsIn(const Surface& surface)
{
  std::vector<DiagnosticKind> kinds;
  for (const Diagnostic& diagnostic : Diagnose(surface, 1))
  {
    kinds.push_back(diagnostic.Kind);
  }
  return kinds;
}
}

TEST(Diagnostics, ReportsOnlyComponentsForAGoodSurface)
{
  EXPECT_EQ(KindsIn(Icosphere(3, 10.0)), std::vector<DiagnosticKind>{ DiagnosticKind::Components });
}

TEST(Diagnostics, StopsAtPointsThatAreNotUsable)
{
  Surface surface = Icosphere(1, 10.0);
  surface.Points[7][1] = std::numeric_limits<double>::quiet_NaN();
  surface.Points[3][0] = std::numeric_limits<double>::infinity();
  surface.Points[5][2] = 1e31;
  EXPECT_EQ(KindsIn(surface),
    (std::vector<DiagnosticKind>{ DiagnosticKind::NonFinitePoints, DiagnosticKind::HugePoints }));
  EXPECT_EQ(Found(surface, DiagnosticKind::NonFinitePoints).First, (std::vector<Index>{ 3, 7 }));
  EXPECT_EQ(Found(surface, DiagnosticKind::HugePoints).First, std::vector<Index>{ 5 });
}

TEST(Diagnostics, FindsPointIdsOutOfRange)
{
  Surface surface = Icosphere(1, 10.0);
  surface.Triangles[4][1] = static_cast<Index>(surface.Points.size());
  surface.Triangles[9][2] = -1;
  EXPECT_EQ(Found(surface, DiagnosticKind::IdsOutOfRange).First, (std::vector<Index>{ 4, 9 }));
}

TEST(Diagnostics, DistinguishesTrianglesWithoutAreaFromRepeatedCorners)
{
  Surface surface = Icosphere(1, 10.0);
  surface.Points.push_back(surface.Points[0]);                           // equal: a corner twice
  surface.Points.push_back(2.0 * surface.Points[1] - surface.Points[0]); // on a line
  const auto last = static_cast<Index>(surface.Points.size()) - 1;
  surface.Triangles.push_back({ 0, 0, 1 });
  surface.Triangles.push_back({ 0, last - 1, 1 });
  surface.Triangles.push_back({ 0, 1, last });
  EXPECT_EQ(Count(surface, DiagnosticKind::RepeatedCorners), 2);
  EXPECT_EQ(Count(surface, DiagnosticKind::NoArea), 1);
  EXPECT_EQ(Found(surface, DiagnosticKind::NoArea).First, std::vector<Index>{ 82 });
}

TEST(Diagnostics, DistinguishesDuplicatesFromOpposites)
{
  Surface surface = Grid(3);
  const Triangle first = surface.Triangles[0];
  surface.Triangles.push_back({ first[1], first[2], first[0] });
  surface.Triangles.push_back({ first[1], first[0], first[2] });
  EXPECT_EQ(Found(surface, DiagnosticKind::Duplicates).First, std::vector<Index>{ 18 });
  EXPECT_EQ(Found(surface, DiagnosticKind::Opposites).First, std::vector<Index>{ 19 });
}

TEST(Diagnostics, CountsUnusedAndEqualPoints)
{
  Surface surface = Unwelded(Icosphere(1, 10.0));
  surface.Points.emplace_back(1.0, 2.0, 3.0);
  EXPECT_EQ(Count(surface, DiagnosticKind::UnusedPoints), 1);
  EXPECT_EQ(Found(surface, DiagnosticKind::UnusedPoints).First, std::vector<Index>{ 240 });
  EXPECT_EQ(Count(surface, DiagnosticKind::EqualPoints), 240 - 42);
  EXPECT_EQ(Count(surface, DiagnosticKind::OpenEdges), 0) << "equal points are one";
}

TEST(Diagnostics, CountsEdgesAndPointsAsBruteForceDoes)
{
  for (const NamedSurface& shape : AllShapes())
  {
    const Topology expected = CountTopology(shape.Surface);
    if (Count(shape.Surface, DiagnosticKind::EqualPoints) +
        Count(shape.Surface, DiagnosticKind::NoArea) +
        Count(shape.Surface, DiagnosticKind::RepeatedCorners) >
      0)
    {
      continue; // brute force takes points by their ids and every triangle
    }
    EXPECT_EQ(Count(shape.Surface, DiagnosticKind::OpenEdges), expected.BoundaryEdges)
      << shape.Name;
    EXPECT_EQ(Count(shape.Surface, DiagnosticKind::NonManifoldEdges), expected.NonManifoldEdges)
      << shape.Name;
    EXPECT_EQ(Count(shape.Surface, DiagnosticKind::InconsistentEdges), expected.InconsistentEdges)
      << shape.Name;
    EXPECT_EQ(Count(shape.Surface, DiagnosticKind::Components), expected.Components) << shape.Name;
    EXPECT_LE(Count(shape.Surface, DiagnosticKind::PinchedPoints), expected.NonManifoldPoints)
      << shape.Name;
  }
}

TEST(Diagnostics, FindsPinchedPoints)
{
  EXPECT_EQ(Count(PinchedSolids(8), DiagnosticKind::PinchedPoints), 1);
  EXPECT_EQ(Count(PinchedSolids(8), DiagnosticKind::NonManifoldEdges), 0);
}

TEST(Diagnostics, ReportsTheDistanceForWelding)
{
  Surface left = Grid(6);
  Surface right = Moved(Grid(6), { 6.004, 0.0, 0.0 });
  const Diagnostic unwelded = Found(Together(left, right), DiagnosticKind::UnweldedPoints);
  EXPECT_EQ(unwelded.Count, 14);
  EXPECT_NEAR(unwelded.Length, 0.004, 1e-12);
  const Surface apart = Together(left, Moved(Grid(6), { 6.02, 0.0, 0.0 }));
  EXPECT_EQ(Count(apart, DiagnosticKind::UnweldedPoints), 0) << "a wide gap is not reported";
  EXPECT_EQ(Count(left, DiagnosticKind::UnweldedPoints), 0);
}

TEST(Diagnostics, ReportsSizesThatAreUnusualForABone)
{
  EXPECT_EQ(Count(Icosphere(2, 100.0), DiagnosticKind::OddSize), 0);
  EXPECT_EQ(Count(Icosphere(2, 0.1), DiagnosticKind::OddSize), 1) << "meters?";
  EXPECT_NEAR(Found(Icosphere(2, 1e5), DiagnosticKind::OddSize).Length, 1e5 * std::sqrt(12.0), 1e4);
}

TEST(Diagnostics, ListsAtMostEightIds)
{
  const Diagnostic open = Found(Grid(20), DiagnosticKind::OpenEdges);
  EXPECT_EQ(open.Count, 80);
  EXPECT_EQ(open.First.size(), FirstDiagnostics);
  EXPECT_TRUE(std::is_sorted(open.First.begin(), open.First.end()));
}

TEST(Diagnostics, AcceptsAnyInput)
{
  EXPECT_TRUE(Diagnose({}).empty() || Count({}, DiagnosticKind::Components) == 0);
  for (std::uint64_t seed = 1; seed <= 50; ++seed)
  {
    const Surface soup = RandomSoup(12, 40, seed);
    EXPECT_FALSE(Diagnose(soup, 1).empty()) << seed;
  }
  Surface flat;
  flat.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } };
  flat.Triangles = { { 0, 1, 2 }, { 0, 0, 1 } };
  EXPECT_EQ(Count(flat, DiagnosticKind::NoArea), 1);
  EXPECT_EQ(Count(flat, DiagnosticKind::RepeatedCorners), 1);
}

TEST(Diagnostics, EveryKindHasAUniqueWord)
{
  std::set<std::string> words;
  for (int kind = 0; kind < NumberOfDiagnosticKinds; ++kind)
  {
    words.insert(InfoOf(static_cast<DiagnosticKind>(kind)).Word);
  }
  EXPECT_EQ(words.size(), static_cast<std::size_t>(NumberOfDiagnosticKinds));
}

TEST(Diagnostics, ReportsClosedPartsThatAreInsideOutAndNoCavities)
{
  Surface surface = Icosphere(2, 10.0);
  EXPECT_EQ(Count(surface, DiagnosticKind::InsideOut), 0);
  const auto turned = [](Surface sphere)
  {
    for (Triangle& corners : sphere.Triangles)
    {
      std::swap(corners[1], corners[2]);
    }
    return sphere;
  };
  EXPECT_EQ(Count(turned(surface), DiagnosticKind::InsideOut), 1);
  const Surface cavity = turned(Icosphere(1, 4.0));
  const auto first = static_cast<Index>(surface.Points.size());
  surface.Points.insert(surface.Points.end(), cavity.Points.begin(), cavity.Points.end());
  for (const Triangle& corners : cavity.Triangles)
  {
    surface.Triangles.push_back({ corners[0] + first, corners[1] + first, corners[2] + first });
  }
  EXPECT_EQ(Count(surface, DiagnosticKind::InsideOut), 0);
  surface.Triangles.pop_back(); // now it is open
  EXPECT_EQ(Count(turned(surface), DiagnosticKind::InsideOut), 1) << "the outer one is closed";
}
