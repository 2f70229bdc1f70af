// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BruteForce.h"
#include "Doctor/Doctor.h"
#include "Random.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// Of that kind; count 0 if there is none.
Finding Found(const Surface& surface, FindingKind kind)
{
  for (Finding& finding : Examine(surface, 1))
  {
    if (finding.Kind == kind)
    {
      return finding;
    }
  }
  return { kind };
}

std::int64_t Count(const Surface& surface, FindingKind kind)
{
  return Found(surface, kind).Count;
}

std::vector<FindingKind> KindsIn(const Surface& surface)
{
  std::vector<FindingKind> kinds;
  for (const Finding& finding : Examine(surface, 1))
  {
    kinds.push_back(finding.Kind);
  }
  return kinds;
}
}

TEST(Doctor, FindsNothingButOnePartInASoundBone)
{
  EXPECT_EQ(KindsIn(Icosphere(3, 10.0)), std::vector<FindingKind>{ FindingKind::Components });
}

TEST(Doctor, NamesPointsThatAreNoPlacesAndLooksNoFurther)
{
  Surface surface = Icosphere(1, 10.0);
  surface.Points[7][1] = std::numeric_limits<double>::quiet_NaN();
  surface.Points[3][0] = std::numeric_limits<double>::infinity();
  surface.Points[5][2] = 1e31;
  EXPECT_EQ(KindsIn(surface),
    (std::vector<FindingKind>{ FindingKind::NonFinitePoints, FindingKind::HugePoints }));
  EXPECT_EQ(Found(surface, FindingKind::NonFinitePoints).First, (std::vector<Index>{ 3, 7 }));
  EXPECT_EQ(Found(surface, FindingKind::HugePoints).First, std::vector<Index>{ 5 });
}

TEST(Doctor, NamesTrianglesOfPointsThatAreNotThere)
{
  Surface surface = Icosphere(1, 10.0);
  surface.Triangles[4][1] = static_cast<Index>(surface.Points.size());
  surface.Triangles[9][2] = -1;
  EXPECT_EQ(Found(surface, FindingKind::IdsOutOfRange).First, (std::vector<Index>{ 4, 9 }));
}

TEST(Doctor, TellsTrianglesWithoutAreaFromThoseWithACornerTwice)
{
  Surface surface = Icosphere(1, 10.0);
  surface.Points.push_back(surface.Points[0]);                           // equal: a corner twice
  surface.Points.push_back(2.0 * surface.Points[1] - surface.Points[0]); // on a line
  const auto last = static_cast<Index>(surface.Points.size()) - 1;
  surface.Triangles.push_back({ 0, 0, 1 });
  surface.Triangles.push_back({ 0, last - 1, 1 });
  surface.Triangles.push_back({ 0, 1, last });
  EXPECT_EQ(Count(surface, FindingKind::RepeatedCorners), 2);
  EXPECT_EQ(Count(surface, FindingKind::NoArea), 1);
  EXPECT_EQ(Found(surface, FindingKind::NoArea).First, std::vector<Index>{ 82 });
}

TEST(Doctor, TellsDuplicatesFromBacks)
{
  Surface surface = Grid(3);
  const Triangle first = surface.Triangles[0];
  surface.Triangles.push_back({ first[1], first[2], first[0] });
  surface.Triangles.push_back({ first[1], first[0], first[2] });
  EXPECT_EQ(Found(surface, FindingKind::Duplicates).First, std::vector<Index>{ 18 });
  EXPECT_EQ(Found(surface, FindingKind::Opposites).First, std::vector<Index>{ 19 });
}

TEST(Doctor, CountsUnusedAndEqualPoints)
{
  Surface surface = Unwelded(Icosphere(1, 10.0));
  surface.Points.emplace_back(1.0, 2.0, 3.0);
  EXPECT_EQ(Count(surface, FindingKind::UnusedPoints), 1);
  EXPECT_EQ(Found(surface, FindingKind::UnusedPoints).First, std::vector<Index>{ 240 });
  EXPECT_EQ(Count(surface, FindingKind::EqualPoints), 240 - 42);
  EXPECT_EQ(Count(surface, FindingKind::OpenEdges), 0) << "equal points are one";
}

TEST(Doctor, CountsEdgesAndPointsAsBruteForceDoes)
{
  for (const NamedSurface& shape : AllShapes())
  {
    const Topology expected = CountTopology(shape.Surface);
    if (Count(shape.Surface, FindingKind::EqualPoints) + Count(shape.Surface, FindingKind::NoArea) +
        Count(shape.Surface, FindingKind::RepeatedCorners) >
      0)
    {
      continue; // brute force takes points by their ids and every triangle
    }
    EXPECT_EQ(Count(shape.Surface, FindingKind::OpenEdges), expected.BoundaryEdges) << shape.Name;
    EXPECT_EQ(Count(shape.Surface, FindingKind::NonManifoldEdges), expected.NonManifoldEdges)
      << shape.Name;
    EXPECT_EQ(Count(shape.Surface, FindingKind::InconsistentEdges), expected.InconsistentEdges)
      << shape.Name;
    EXPECT_EQ(Count(shape.Surface, FindingKind::Components), expected.Components) << shape.Name;
    EXPECT_LE(Count(shape.Surface, FindingKind::PinchedPoints), expected.NonManifoldPoints)
      << shape.Name;
  }
}

TEST(Doctor, FindsPointsThatHoldPartsTogether)
{
  EXPECT_EQ(Count(PinchedSolids(8), FindingKind::PinchedPoints), 1);
  EXPECT_EQ(Count(PinchedSolids(8), FindingKind::NonManifoldEdges), 0);
}

TEST(Doctor, TellsOverWhichDistanceASeamWouldHaveToBeWelded)
{
  Surface left = Grid(6);
  Surface right = Moved(Grid(6), { 6.004, 0.0, 0.0 });
  const Finding seam = Found(Together(left, right), FindingKind::UnweldedPoints);
  EXPECT_EQ(seam.Count, 14);
  EXPECT_NEAR(seam.Length, 0.004, 1e-12);
  const Surface apart = Together(left, Moved(Grid(6), { 6.02, 0.0, 0.0 }));
  EXPECT_EQ(Count(apart, FindingKind::UnweldedPoints), 0) << "a gap is no seam";
  EXPECT_EQ(Count(left, FindingKind::UnweldedPoints), 0);
}

TEST(Doctor, DoubtsSizesThatAreNoBoneInMillimetres)
{
  EXPECT_EQ(Count(Icosphere(2, 100.0), FindingKind::OddSize), 0);
  EXPECT_EQ(Count(Icosphere(2, 0.1), FindingKind::OddSize), 1) << "metres?";
  EXPECT_NEAR(Found(Icosphere(2, 1e5), FindingKind::OddSize).Length, 1e5 * std::sqrt(12.0), 1e4);
}

TEST(Doctor, NamesNoMoreThanTheFirstEight)
{
  const Finding open = Found(Grid(20), FindingKind::OpenEdges);
  EXPECT_EQ(open.Count, 80);
  EXPECT_EQ(open.First.size(), FirstFindings);
  EXPECT_TRUE(std::is_sorted(open.First.begin(), open.First.end()));
}

TEST(Doctor, AnswersAnything)
{
  EXPECT_TRUE(Examine({}).empty() || Count({}, FindingKind::Components) == 0);
  for (std::uint64_t seed = 1; seed <= 50; ++seed)
  {
    const Surface soup = RandomSoup(12, 40, seed);
    EXPECT_FALSE(Examine(soup, 1).empty()) << seed;
  }
  Surface flat;
  flat.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } };
  flat.Triangles = { { 0, 1, 2 }, { 0, 0, 1 } };
  EXPECT_EQ(Count(flat, FindingKind::NoArea), 1);
  EXPECT_EQ(Count(flat, FindingKind::RepeatedCorners), 1);
}

TEST(Doctor, HasAWordOfItsOwnForEachKind)
{
  std::set<std::string> words;
  for (int kind = 0; kind < NumberOfFindingKinds; ++kind)
  {
    words.insert(InfoOf(static_cast<FindingKind>(kind)).Word);
  }
  EXPECT_EQ(words.size(), static_cast<std::size_t>(NumberOfFindingKinds));
}
