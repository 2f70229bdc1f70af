// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BruteForce.h"
#include "Mesh/Checksum.h"
#include "Mesh/Cleaning.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// The invariants of a cleaned surface and of its maps.
void ExpectConsistent(const Surface& input, const CleanSurface& clean)
{
  EXPECT_EQ(WhatIsWrong(clean.Surface), "");
  ASSERT_EQ(clean.InputPoint.size(), clean.Surface.Points.size());
  ASSERT_EQ(clean.InputPointCount.size(), clean.Surface.Points.size());
  ASSERT_EQ(clean.InputTriangle.size(), clean.Surface.Triangles.size());
  ASSERT_EQ(clean.PointOfInput.size(), input.Points.size());
  std::vector<Index> counts(clean.Surface.Points.size(), 0);
  for (std::size_t i = 0; i < input.Points.size(); ++i)
  {
    const Index point = clean.PointOfInput[i];
    if (point != None)
    {
      ++counts[point];
      EXPECT_EQ(clean.Surface.Points[point], input.Points[i] - clean.Origin);
      EXPECT_LE(clean.InputPoint[point], static_cast<Index>(i));
    }
  }
  EXPECT_EQ(counts, clean.InputPointCount);
  for (std::size_t i = 0; i < clean.Surface.Triangles.size(); ++i)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Index inputPoint = input.Triangles[clean.InputTriangle[i]][k];
      EXPECT_EQ(clean.PointOfInput[inputPoint], clean.Surface.Triangles[i][k]);
    }
  }
}
}

TEST(Cleaning, EmptyInputIsEmpty)
{
  EXPECT_EQ(Clean({}, true).Status, InputStatus::Empty);
}

TEST(Cleaning, PointsWithoutTrianglesAreNoSurface)
{
  const CleanSurface clean = Clean({ { { 0, 0, 0 }, { 1, 0, 0 } }, {} }, true);
  EXPECT_EQ(clean.Status, InputStatus::NoTriangles);
  EXPECT_EQ(clean.Statistics.PointsRead, 2);
}

TEST(Cleaning, NonFinitePointsAreCountedAndTheFirstIsNamed)
{
  for (const double bad : { NaN, Infinity, -Infinity })
  {
    Surface surface = Icosphere(1, 1.0);
    surface.Points[17].y() = bad;
    surface.Points[5].z() = bad;
    surface.Points[5].x() = bad;
    const CleanSurface clean = Clean(surface, true);
    EXPECT_EQ(clean.Status, InputStatus::NonFinitePoints);
    EXPECT_EQ(clean.Statistics.NonFinitePoints, 2);
    EXPECT_EQ(clean.Statistics.FirstNonFinitePoint, 5);
  }
}

TEST(Cleaning, RejectsHugeCoordinatesAndAcceptsLargeOnes)
{
  Surface surface = Tetrahedron();
  surface.Points[1].x() = -1.1e30;
  EXPECT_EQ(Clean(surface, true).Status, InputStatus::HugeCoordinates);
  surface.Points[1].x() = 1e30;
  EXPECT_EQ(Clean(surface, true).Status, InputStatus::Good);
}

TEST(Cleaning, IndicesOutOfRangeAreCountedAndTheFirstIsNamed)
{
  for (const Index bad :
    { -1, 4, std::numeric_limits<Index>::max(), std::numeric_limits<Index>::min() })
  {
    Surface surface = Tetrahedron();
    surface.Triangles[2][1] = bad;
    surface.Triangles[3] = { bad, bad, bad };
    const CleanSurface clean = Clean(surface, true);
    EXPECT_EQ(clean.Status, InputStatus::IndexOutOfRange);
    EXPECT_EQ(clean.Statistics.TrianglesOutOfRange, 2);
    EXPECT_EQ(clean.Statistics.FirstTriangleOutOfRange, 2);
  }
}

TEST(Cleaning, TrianglesWithoutPointsAreOutOfRange)
{
  EXPECT_EQ(Clean({ {}, { { 0, 1, 2 } } }, true).Status, InputStatus::IndexOutOfRange);
}

TEST(Cleaning, OnlyTrianglesWithoutAreaAreNoSurface)
{
  const Surface surface = { { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } },
    { { 0, 0, 1 }, { 0, 1, 2 } } };
  const CleanSurface clean = Clean(surface, true);
  EXPECT_EQ(clean.Status, InputStatus::NoTriangles);
  EXPECT_EQ(clean.Statistics.DroppedTriangles, 2);
  EXPECT_EQ(clean.Statistics.FirstDroppedTriangle, 0);
}

TEST(Cleaning, GoodShapesAreKeptWhole)
{
  for (const NamedSurface& shape : AllShapes())
  {
    SCOPED_TRACE(shape.Name);
    const CleanSurface clean = Clean(shape.Surface, true);
    ASSERT_EQ(clean.Status, InputStatus::Good);
    ExpectConsistent(shape.Surface, clean);
    EXPECT_EQ(clean.Surface.Triangles.size(), shape.Surface.Triangles.size());
    EXPECT_EQ(clean.Statistics.DroppedTriangles, 0);
    EXPECT_EQ(clean.Statistics.FirstDroppedTriangle, -1);
  }
}

TEST(Cleaning, UnweldedTrianglesAreWeldedAndCounted)
{
  const Surface whole = Icosphere(2, 3.0);
  const CleanSurface clean = Clean(Unwelded(whole), true);
  ExpectConsistent(Unwelded(whole), clean);
  EXPECT_TRUE(CountTopology(clean.Surface) == CountTopology(whole));
  EXPECT_EQ(clean.Statistics.MergedPoints,
    static_cast<std::int64_t>(3 * whole.Triangles.size() - whole.Points.size()));
}

TEST(Cleaning, WithoutMergingTrianglesStayApart)
{
  const Surface soup = Unwelded(Cube(2));
  const CleanSurface clean = Clean(soup, false);
  ExpectConsistent(soup, clean);
  EXPECT_EQ(
    CountTopology(clean.Surface).Components, static_cast<std::int64_t>(soup.Triangles.size()));
  EXPECT_EQ(clean.Statistics.MergedPoints, 0);
}

TEST(Cleaning, MinusZeroEqualsZero)
{
  Surface surface = Unwelded(Grid(1));
  for (std::size_t i = 3; i < 6; ++i)
  {
    for (double& coordinate : surface.Points[i])
    {
      coordinate = coordinate == 0.0 ? -0.0 : coordinate;
    }
  }
  const CleanSurface clean = Clean(surface, true);
  EXPECT_EQ(clean.Statistics.MergedPoints, 2);
  EXPECT_EQ(CountTopology(clean.Surface).Components, 1);
}

TEST(Cleaning, PointsThatDifferInTheLastBitAreNotMerged)
{
  Surface surface = Unwelded(Grid(1));
  for (std::size_t i = 3; i < 6; ++i)
  {
    surface.Points[i].x() = std::nextafter(surface.Points[i].x(), 2.0);
  }
  EXPECT_EQ(Clean(surface, true).Statistics.MergedPoints, 0);
}

TEST(Cleaning, RepeatedCornersAreDroppedAndTheFirstIsNamed)
{
  Surface surface = Icosphere(1, 1.0);
  const std::size_t good = surface.Triangles.size();
  surface.Triangles.insert(
    surface.Triangles.begin() + 3, { { 0, 0, 1 }, { 2, 3, 2 }, { 4, 5, 5 } });
  const CleanSurface clean = Clean(surface, true);
  ExpectConsistent(surface, clean);
  EXPECT_EQ(clean.Surface.Triangles.size(), good);
  EXPECT_EQ(clean.Statistics.DroppedTriangles, 3);
  EXPECT_EQ(clean.Statistics.FirstDroppedTriangle, 3);
}

TEST(Cleaning, TrianglesThatMergingMakesFlatAreDropped)
{
  Surface surface = Grid(2);
  surface.Points.push_back(surface.Points[0]);
  const auto twin = static_cast<Index>(surface.Points.size() - 1);
  surface.Triangles.push_back({ 0, 1, twin });
  const CleanSurface merged = Clean(surface, true);
  EXPECT_EQ(merged.Statistics.DroppedTriangles, 1);
  EXPECT_EQ(merged.Statistics.MergedPoints, 1);
  ExpectConsistent(surface, merged);
}

TEST(Cleaning, UnusedPointsAreLeftOutAndCounted)
{
  Surface surface = Tetrahedron();
  surface.Points.insert(surface.Points.begin(), { { 7, 7, 7 }, { -100, 0, 0 } });
  for (Triangle& t : surface.Triangles)
  {
    t = { t[0] + 2, t[1] + 2, t[2] + 2 };
  }
  const CleanSurface clean = Clean(surface, true);
  ExpectConsistent(surface, clean);
  EXPECT_EQ(clean.Statistics.UnusedPoints, 2);
  EXPECT_EQ(clean.PointOfInput[0], None);
  EXPECT_EQ(clean.Origin, Vector3(0, 0, 0)) << "the unused points do not count";
}

TEST(Cleaning, KeepsAFlatTriangleThatConnectsTheSurface)
{
  // A square in which the middle of one side is a corner of one triangle only: the gap is a
  // triangle without area, and without it there would be a crack.
  const Surface surface = { { { 0, 0, 0 }, { 2, 0, 0 }, { 1, 0, 0 }, { 1, 2, 0 }, { 1, -2, 0 } },
    { { 0, 2, 3 }, { 2, 1, 3 }, { 1, 0, 4 }, { 0, 1, 2 } } };
  const CleanSurface clean = Clean(surface, true);
  EXPECT_EQ(clean.Statistics.DroppedTriangles, 0);
  EXPECT_EQ(clean.Surface.Triangles.size(), 4U);
  // A flat triangle with one neighbor closes nothing.
  Surface flap = Grid(1);
  flap.Points.emplace_back(2.0, 0.0, 0.0);
  flap.Triangles.push_back({ 1, 0, 4 });
  EXPECT_EQ(Clean(flap, true).Statistics.DroppedTriangles, 1);
  EXPECT_EQ(Clean(flap, true).Statistics.FirstDroppedTriangle, 2);
}

TEST(Cleaning, OriginIsTheLeastCornerOfTheBox)
{
  const Surface surface = Moved(Icosphere(1, 2.0), { 100, -50, 7 });
  const CleanSurface clean = Clean(surface, true);
  Vector3 low = surface.Points[0];
  for (const Vector3& p : surface.Points)
  {
    low = low.cwiseMin(p);
  }
  EXPECT_EQ(clean.Origin, low);
}

TEST(Cleaning, TheSameWhateverTheThreads)
{
  // Enough points for several blocks and parts; merged, unused and dropped ones among them.
  Surface surface = Unwelded(Icosphere(5, 10.0));
  surface.Points.resize(surface.Points.size() + 5, Vector3(1, 2, 3));
  for (std::size_t t = 0; t < surface.Triangles.size(); t += 100)
  {
    surface.Triangles[t][2] = surface.Triangles[t][0];
  }
  const CleanSurface one = Clean(surface, true, 1);
  ExpectConsistent(surface, one);
  EXPECT_EQ(one.Statistics.DroppedTriangles, 205);
  for (const int threads : { 2, 5 })
  {
    const CleanSurface many = Clean(surface, true, threads);
    EXPECT_TRUE(SameBytes(one.Surface, many.Surface));
    EXPECT_EQ(one.InputPoint, many.InputPoint);
    EXPECT_EQ(one.InputPointCount, many.InputPointCount);
    EXPECT_EQ(one.InputTriangle, many.InputTriangle);
    EXPECT_EQ(one.PointOfInput, many.PointOfInput);
    EXPECT_EQ(Checksum(surface, 1), Checksum(surface, threads));
  }
}

TEST(Cleaning, ChecksumTellsInputsApart)
{
  const Surface surface = Icosphere(1, 1.0);
  EXPECT_EQ(Checksum(surface), Checksum(Icosphere(1, 1.0)));
  Surface moved = surface;
  moved.Points[7].z() = std::nextafter(moved.Points[7].z(), 9.0);
  EXPECT_NE(Checksum(surface), Checksum(moved));
  Surface turned = surface;
  std::swap(turned.Triangles[3][0], turned.Triangles[3][1]);
  EXPECT_NE(Checksum(surface), Checksum(turned));
  EXPECT_NE(Checksum(surface), Checksum({}));
}
