// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CertificatePairs.h"
#include "Proof/Certificate/OverlayCover.h"

#include <gtest/gtest.h>

namespace bonedecimate::testsupport
{
namespace
{
using certificate::Corners;
using certificate::EdgeSides;
using certificate::OverlayCover;
using certificate::Simplices;

constexpr double Infinite = std::numeric_limits<double>::infinity();

/// A surface and the cover of triangles by it.
struct CoveringSurface
{
  explicit CoveringSurface(const Surface& surface)
    : Whole(surface)
    , Sides(SidesOf(surface))
  {
    this->Set.Points = surface.Points;
    this->Set.Corners = surface.Triangles;
    this->Set.Sides = &this->Sides;
  }

  /// mm, the bound of all parts; infinite if the triangle is not covered.
  double Bound(const Corners& triangle) const
  {
    const Vector3 middle = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
    return this->Bound(triangle, BruteNearest(this->Whole, middle).Triangle);
  }
  double Bound(const Corners& triangle, Index seed) const
  {
    OverlayCover cover(this->Set);
    return cover.Find(triangle, { seed, seed, seed }, Infinite) ? cover.Upper() : Infinite;
  }

  Surface Whole;
  EdgeSides Sides;
  Simplices Set;
};

bool IsBounded(double bound)
{
  return bound < Infinite;
}

double LargestSampled(const Corners& triangle, const Surface& surface)
{
  const Surface one = { { triangle[0], triangle[1], triangle[2] }, { { 0, 1, 2 } } };
  return SampleDistance(one, surface, 12).Largest;
}

/// Within a grid of ten cells, in the plane z = 0, with no side parallel to an edge.
const Corners OverTheGrid = { Vector3{ 1.1, 1.3, 0.0 }, { 8.2, 2.1, 0.0 }, { 3.3, 7.9, 0.0 } };

/// A grid of ten cells of which one triangle is left out.
Surface GridWithout(Index triangle)
{
  Surface grid = Grid(10);
  grid.Triangles.erase(grid.Triangles.begin() + triangle);
  return grid;
}

Index TriangleAt(const Surface& surface, const Vector3& position)
{
  return BruteNearest(surface, position).Triangle;
}
}

TEST(OverlayCover, IsAnUpperBoundOfTheDistance)
{
  Random random(3);
  int bounded = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed)
  {
    // Moved along the plane, too, so that some surfaces fold over.
    const Surface surface =
      Shaken(HeightField(10, 1.5, seed), random.Between(0.0, 0.8), seed + 100);
    const CoveringSurface covering(surface);
    const Corners triangle = { Vector3{ 1.0, 1.0, 0.0 } + random.InCube(1.0),
      Vector3{ 8.0, 2.0, 0.0 } + random.InCube(1.0),
      Vector3{ 4.0, 8.0, 0.0 } + random.InCube(1.0) };
    const double bound = covering.Bound(triangle);
    bounded += IsBounded(bound) ? 1 : 0;
    EXPECT_GE(bound * (1.0 + 1e-12), LargestSampled(triangle, surface)) << seed;
  }
  EXPECT_GT(bounded, 30);
}

TEST(OverlayCover, IsExactOverAHeightField)
{
  Surface surface = Grid(10);
  for (Vector3& point : surface.Points)
  {
    point.z() = point.x() == 4.0 && point.y() == 4.0 ? 0.75 : 0.25;
  }
  const CoveringSurface covering(surface);
  const Index flat = TriangleAt(surface, { 6.4, 3.3, 0.25 });
  EXPECT_NEAR(covering.Bound(OverTheGrid, flat), 0.75, 1e-14);
  OverlayCover cover(covering.Set);
  ASSERT_TRUE(cover.Find(OverTheGrid, { flat, flat, flat }, 0.7));
  EXPECT_NEAR(cover.Upper(), 0.25, 1e-14);
  EXPECT_EQ(cover.FarParts().size(), 6U) << "the triangles at the point";
  for (const OverlayCover::Part& part : cover.FarParts())
  {
    EXPECT_NEAR(part.Upper, 0.75, 1e-14);
    EXPECT_LT((part.Corners[part.Farthest] - Vector3(4.0, 4.0, 0.0)).norm(), 1e-13);
    const Triangle& corners = surface.Triangles[part.Nearest];
    EXPECT_TRUE(std::any_of(corners.begin(), corners.end(),
      [&](Index corner) { return surface.Points[corner].z() == 0.75; }));
  }
}

TEST(OverlayCover, HasAllPositionsThatAreFarInFarParts)
{
  int far = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
  {
    Surface surface = Shaken(HeightField(10, 0.1, seed), 0.05, seed + 100);
    for (Vector3& point : surface.Points)
    {
      const bool isPeak = (point - Vector3(4.0, 6.0, 0.0)).norm() < 0.5 ||
        (point - Vector3(6.0, 3.0, 0.0)).norm() < 0.5;
      point.z() += isPeak ? 0.5 : 0.0;
    }
    const CoveringSurface covering(surface);
    const Index flat = TriangleAt(surface, { 3.4, 3.3, 0.0 });
    OverlayCover cover(covering.Set);
    const double limit = 0.5 * LargestSampled(OverTheGrid, surface);
    if (!cover.Find(OverTheGrid, { flat, flat, flat }, limit))
    {
      continue;
    }
    EXPECT_LE(cover.Upper(), limit);
    Surface parts;
    for (const OverlayCover::Part& part : cover.FarParts())
    {
      EXPECT_GT(part.Upper, limit);
      const auto first = static_cast<Index>(parts.Points.size());
      parts.Points.insert(
        parts.Points.end(), part.Corners.begin(), part.Corners.begin() + part.Count);
      for (Index i = 2; i < static_cast<Index>(part.Count); ++i)
      {
        parts.Triangles.push_back({ first, first + i - 1, first + i });
      }
    }
    const Surface whole = { { OverTheGrid[0], OverTheGrid[1], OverTheGrid[2] }, { { 0, 1, 2 } } };
    ForEachSample(whole, whole.Triangles[0], 30,
      [&](const Vector3& position, const std::array<double, 3>&)
      {
        if (BruteNearest(surface, position).Distance > cover.Upper() + 1e-12)
        {
          ++far;
          EXPECT_LT(BruteNearest(parts, position).Distance, 1e-12) << seed;
        }
      });
  }
  EXPECT_GT(far, 100);
}

TEST(OverlayCover, EndsWithTooManyFarParts)
{
  Surface surface = Grid(10);
  const CoveringSurface covering(surface);
  OverlayCover cover(covering.Set);
  const Index seed = TriangleAt(surface, { 4.2, 3.8, 0.0 });
  const Corners above = { OverTheGrid[0] + Vector3::UnitZ(), OverTheGrid[1] + Vector3::UnitZ(),
    OverTheGrid[2] + Vector3::UnitZ() };
  EXPECT_FALSE(cover.Find(above, { seed, seed, seed }, 0.9));
  EXPECT_TRUE(cover.Find(above, { seed, seed, seed }, 1.0));
}

TEST(OverlayCover, IsLargestAtAnyCornerOverOneTriangle)
{
  for (const Vector3& up :
    { Vector3(1.0, 0.0, 0.0), Vector3(0.0, 1.0, 0.0), Vector3(-1.0, -1.0, 0.0) })
  {
    Surface surface = { { { -90.0, -80.0, 0.0 }, { 90.0, -80.0, 0.0 }, { 0.0, 90.0, 0.0 } },
      { { 0, 1, 2 } } };
    double largest = 0.0;
    for (const Vector3& corner : OverTheGrid)
    {
      largest = std::max(
        largest, (20.0 + 0.1 * up.dot(corner)) / Vector3(0.1 * up.x(), 0.1 * up.y(), 1.0).norm());
    }
    for (Vector3& point : surface.Points)
    {
      point.z() = 20.0 + 0.1 * up.dot(point);
    }
    EXPECT_NEAR(CoveringSurface(surface).Bound(OverTheGrid), largest, 1e-9) << up.transpose();
  }
}

TEST(OverlayCover, KnowsNothingOfTheTriangleBeforeANeedle)
{
  const CoveringSurface grid(Grid(10));
  OverlayCover cover(grid.Set);
  ASSERT_TRUE(cover.Find(OverTheGrid, { 44, 45, 66 }, Infinite));
  EXPECT_GT(cover.Met().size(), 3U);
  const Vector3 start(1.1, 1.3, 0.0);
  const Vector3 end(8.2, 2.1, 0.0);
  EXPECT_FALSE(cover.Find({ start, end, 0.5 * (start + end) }, { 3, 5, 3 }, Infinite));
  EXPECT_EQ(cover.Met(), std::vector<Index>({ 3, 5 }));
}

TEST(OverlayCover, IgnoresTheSurfaceBesideTheTriangle)
{
  Surface surface = Grid(10);
  for (Vector3& point : surface.Points)
  {
    point.z() = point.x() >= 9.0 ? 50.0 : 0.25; // the triangle ends at 8.2
  }
  EXPECT_NEAR(CoveringSurface(surface).Bound(OverTheGrid), 0.25 + 0.2 * 49.75, 1e-10)
    << "of the slope from 8 to 9 only the part over the triangle counts";
}

TEST(OverlayCover, HasNoBoundOverAHole)
{
  const Surface grid = Grid(10);
  EXPECT_FALSE(IsBounded(
    CoveringSurface(GridWithout(TriangleAt(grid, { 3.6, 4.3, 0.0 }))).Bound(OverTheGrid)));
  EXPECT_TRUE(
    IsBounded(CoveringSurface(GridWithout(TriangleAt(grid, { 8.6, 8.3, 0.0 }))).Bound(OverTheGrid)))
    << "the hole is beside the triangle";
}

TEST(OverlayCover, HasNoBoundWhereASideLeavesTheSurface)
{
  const Surface grid = Grid(10);
  Corners triangle = OverTheGrid;
  EXPECT_TRUE(IsBounded(CoveringSurface(grid).Bound(triangle)));
  triangle[1].x() = 10.1;
  EXPECT_FALSE(IsBounded(CoveringSurface(grid).Bound(triangle)));
}

TEST(OverlayCover, HasNoBoundUnderTwoLayers)
{
  const Surface plate = FlatPlate(3);
  const Corners larger = { Vector3{ -9.0, -9.0, 0.5 }, { 15.0, -9.0, 0.5 }, { 1.0, 20.0, 0.5 } };
  EXPECT_FALSE(IsBounded(CoveringSurface(plate).Bound(larger)))
    << "the closed surface does not cover the triangle, and its edges all have two triangles";
}

TEST(OverlayCover, CountsLayersOfAFold)
{
  // One strip folded twice: three layers over the middle.
  Surface fold;
  const std::array<Vector3, 4> profile = { Vector3{ 0.0, 0.0, 0.0 }, { 6.0, 0.0, 0.5 },
    { 4.0, 0.0, 1.0 }, { 10.0, 0.0, 1.5 } };
  for (const Vector3& at : profile)
  {
    fold.Points.push_back(at);
    fold.Points.push_back(at + Vector3(0.0, 10.0, 0.0));
  }
  for (Index i = 0; i < 6; i += 2)
  {
    fold.Triangles.push_back({ i, i + 2, i + 3 });
    fold.Triangles.push_back({ i, i + 3, i + 1 });
  }
  const Corners over = { Vector3{ 3.0, 1.0, 0.7 }, { 8.0, 2.0, 0.7 }, { 5.0, 8.0, 0.7 } };
  const double bound = CoveringSurface(fold).Bound(over);
  ASSERT_TRUE(IsBounded(bound));
  EXPECT_GE(bound, LargestSampled(over, fold));
  // Without the last layer the middle has two and the right part none.
  fold.Triangles.resize(4);
  EXPECT_FALSE(IsBounded(CoveringSurface(fold).Bound(over)));
}

TEST(OverlayCover, JoinsTrianglesWithPointsOfTheirOwn)
{
  const Surface surface = HeightField(10, 0.5, 7);
  const double joined = CoveringSurface(surface).Bound(OverTheGrid);
  const double apart = CoveringSurface(Unwelded(surface)).Bound(OverTheGrid);
  ASSERT_TRUE(IsBounded(joined));
  EXPECT_EQ(joined, apart);
}

TEST(OverlayCover, HasNoBoundOverANonManifoldEdge)
{
  Surface surface = Grid(10);
  const Triangle over = surface.Triangles[TriangleAt(surface, { 3.6, 4.3, 0.0 })];
  surface.Points.emplace_back(3.6, 4.3, 2.0);
  surface.Triangles.push_back({ over[0], over[1], static_cast<Index>(surface.Points.size()) - 1 });
  EXPECT_FALSE(IsBounded(CoveringSurface(surface).Bound(OverTheGrid)));
}

TEST(OverlayCover, HasNoBoundForNeedles)
{
  const Corners needle = { Vector3{ 1.0, 1.0, 0.0 }, { 8.0, 1.0, 0.0 }, { 8.0, 1.0 + 1e-3, 0.0 } };
  EXPECT_FALSE(IsBounded(CoveringSurface(Grid(10)).Bound(needle)));
}

TEST(OverlayCover, HasNoBoundFromTrianglesBeside)
{
  const Surface grid = Grid(10);
  const CoveringSurface covering(grid);
  OverlayCover cover(covering.Set);
  const Index beside = TriangleAt(grid, { 9.5, 9.5, 0.0 });
  const Index under = TriangleAt(grid, { 4.5, 3.5, 0.0 });
  EXPECT_FALSE(cover.Find(OverTheGrid, { beside, beside, beside }, Infinite));
  EXPECT_TRUE(cover.Find(OverTheGrid, { under, under, under }, Infinite))
    << "the same workspace afterwards";
  EXPECT_TRUE(cover.Find(OverTheGrid, { beside, under, beside }, Infinite));
}
}
