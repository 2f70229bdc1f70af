// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CertificatePairs.h"
#include "Proof/Certificate/Frame.h"
#include "Proof/Certificate/JointCover.h"
#include "Proof/Certificate/Search.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bonedecimate::testsupport
{
namespace
{
using certificate::Corners;
using certificate::JointCover;
using certificate::Target;
using Outcome = JointCover::Outcome;

Corners CornersOf(const Surface& surface, Index triangle)
{
  const auto& [a, b, c] = surface.Triangles[triangle];
  return { surface.Points[a], surface.Points[b], surface.Points[c] };
}

/// mm, for the coordinates of these tests.
constexpr double Slack = 1e-11;

/// A cover of the triangle without candidates.
JointCover CoverOf(const Corners& triangle)
{
  JointCover cover;
  cover.Begin(Slack);
  cover.Cover(triangle.data(), triangle.size());
  return cover;
}

/// A cover of the triangle by all triangles of a surface.
JointCover CoverBy(const Surface& surface, const Corners& triangle)
{
  JointCover cover = CoverOf(triangle);
  for (Index i = 0; i < static_cast<Index>(surface.Triangles.size()); ++i)
  {
    EXPECT_TRUE(cover.Add(CornersOf(surface, i), i));
  }
  return cover;
}

double LargestSampled(const Corners& triangle, const Surface& surface)
{
  const Surface one = { { triangle[0], triangle[1], triangle[2] }, { { 0, 1, 2 } } };
  return SampleDistance(one, surface, 24).Largest;
}

Corners RandomTriangle(Random& random)
{
  return { random.InCube(5.0), random.InCube(5.0), random.InCube(5.0) };
}

/// A square of two triangles in the plane z = 0, from x to x + 1.
Surface SquareFrom(double x)
{
  return { { { x, 0.0, 0.0 }, { x + 1.0, 0.0, 0.0 }, { x + 1.0, 1.0, 0.0 }, { x, 1.0, 0.0 } },
    { { 0, 1, 2 }, { 0, 2, 3 } } };
}
}

TEST(JointCover, MeasuresTheDistanceOfAPoint)
{
  std::vector<Surface> surfaces = { Needles(5), Envelope(), Grid(3), SingleTriangle() };
  for (const std::uint64_t seed : { 1, 2, 3, 4, 5, 6, 7, 8 })
  {
    surfaces.push_back(RandomSoup(20, 30, seed));
  }
  Surface withoutArea = RandomSoup(9, 1, 3);
  withoutArea.Triangles = { { 0, 0, 1 }, { 2, 3, 2 }, { 4, 4, 4 }, { 5, 6, 6 } };
  surfaces.push_back(withoutArea);
  Random random(5);
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    for (int k = 0; k < 200; ++k)
    {
      const Vector3 p = random.InCube(8.0);
      JointCover cover = CoverBy(surfaces[i], { p, p, p });
      ASSERT_EQ(cover.Run(1e3, 3), Outcome::Covered);
      EXPECT_NEAR(cover.Upper(), BruteNearest(surfaces[i], p).Distance, 1e-12) << i;
    }
  }
}

TEST(JointCover, MeasuresToTrianglesOfAnySize)
{
  Random random(6);
  for (int exponent = -170; exponent <= 30; exponent += 2)
  {
    const double size = std::pow(10.0, exponent);
    const Vector3 p = std::max(size, 1.0) * Vector3(0.3, 0.4, 1.2);
    const Corners candidate = { size * random.InCube(1e-3), size * random.InCube(1e-3),
      size * random.InCube(1e-3) };
    JointCover cover = CoverOf({ p, p, p });
    cover.Add(candidate, 0);
    ASSERT_EQ(cover.Run(1e32, 3), Outcome::Covered);
    const Surface one = { { candidate[0], candidate[1], candidate[2] }, { { 0, 1, 2 } } };
    const double exact = size < 1e-100 ? p.norm() : BruteNearest(one, p).Distance;
    EXPECT_NEAR(cover.Upper() / exact, 1.0, 1e-12) << exponent;
  }
}

TEST(JointCover, IsAnUpperBoundOfTheDistance)
{
  Random random(3);
  int covered = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed)
  {
    const Surface surface = RandomSoup(20, 1 + static_cast<int>(seed % 60), seed);
    const Corners triangle = RandomTriangle(random);
    const double largest = LargestSampled(triangle, surface);
    for (const double factor : { 0.9, 1.0, 1.05, 1.2, 1.5, 3.0 })
    {
      JointCover cover = CoverBy(surface, triangle);
      if (cover.Run(factor * largest, JointCover::MaxCorners) == Outcome::Covered)
      {
        ++covered;
        EXPECT_GE(cover.Upper() * (1.0 + 1e-12), largest) << seed;
        EXPECT_LE(cover.Upper(), factor * largest * (1.0 + 1e-12)) << seed;
      }
    }
  }
  EXPECT_GT(covered, 400);
}

TEST(JointCover, IsTheLargestDistanceOfACornerToOneTriangle)
{
  Random random(8);
  for (int k = 0; k < 100; ++k)
  {
    const Surface one = { { random.InCube(5.0), random.InCube(5.0), random.InCube(5.0) },
      { { 0, 1, 2 } } };
    const Corners triangle = RandomTriangle(random);
    double largest = 0.0;
    for (const Vector3& corner : triangle)
    {
      largest = std::max(largest, BruteNearest(one, corner).Distance);
    }
    JointCover cover = CoverBy(one, triangle);
    ASSERT_EQ(cover.Run(100.0, 3), Outcome::Covered);
    EXPECT_NEAR(cover.Upper(), largest, 1e-12);
  }
}

TEST(JointCover, NeedsAllTrianglesThatOnlyTogetherAreNear)
{
  // Nine squares in a row, and a triangle 0.1 above them.
  const Corners over = { Vector3{ 0.1, 0.1, 0.1 }, { 8.9, 0.5, 0.1 }, { 0.1, 0.9, 0.1 } };
  JointCover cover = CoverOf(over);
  Index id = 0;
  for (int x = 0; x < 9; ++x)
  {
    for (Index i = 0; i < 2; ++i)
    {
      EXPECT_TRUE(i == 1 || cover.Run(0.3, JointCover::MaxCorners) != Outcome::Covered) << x;
      EXPECT_TRUE(cover.Add(CornersOf(SquareFrom(x), i), id++));
    }
  }
  ASSERT_EQ(cover.Run(0.3, JointCover::MaxCorners), Outcome::Covered);
  EXPECT_GE(cover.Upper(), 0.1);
  EXPECT_LE(cover.Upper(), 0.3);
}

TEST(JointCover, NamesAPositionThatIsFar)
{
  Surface surface = SquareFrom(0.0);
  const Corners over = { Vector3{ 0.1, 0.1, 0.1 }, { 8.9, 0.5, 0.1 }, { 0.1, 0.9, 0.1 } };
  JointCover cover = CoverBy(surface, over);
  ASSERT_EQ(cover.Run(7.0, JointCover::MaxCorners), Outcome::Far);
  EXPECT_GT(BruteNearest(surface, cover.FarPosition()).Distance, 7.0);
  EXPECT_EQ(cover.NearestToFar(), BruteNearest(surface, cover.FarPosition()).Triangle);
  EXPECT_EQ(cover.Run(8.0, JointCover::MaxCorners), Outcome::Covered) << "with a larger limit";
  EXPECT_NEAR(cover.Upper(), Vector3(7.9, 0.0, 0.1).norm(), 1e-12);
}

TEST(JointCover, MeasuresToCandidatesThatAreAddedLater)
{
  const Corners over = { Vector3{ 0.1, 0.1, 0.1 }, { 8.9, 0.5, 0.1 }, { 0.1, 0.9, 0.1 } };
  JointCover cover = CoverOf(over);
  Index id = 0;
  const auto add = [&](double x)
  {
    for (Index i = 0; i < 2; ++i)
    {
      EXPECT_TRUE(cover.Add(CornersOf(SquareFrom(x), i), id++));
    }
  };
  for (const double x : { 0.0, 4.0, 8.0, 50.0 })
  {
    add(x);
  }
  ASSERT_EQ(cover.Run(0.3, JointCover::MaxCorners), Outcome::Far) << "beside the middle";
  for (const double x : { 60.0, 70.0, 80.0 })
  {
    add(x);
    EXPECT_EQ(cover.Run(0.3, JointCover::MaxCorners), Outcome::Far) << "these are far, too";
  }
  for (const double x : { 1.0, 2.0, 3.0, 5.0, 6.0, 7.0 })
  {
    add(x);
  }
  ASSERT_EQ(cover.Run(0.3, JointCover::MaxCorners), Outcome::Covered);
  EXPECT_GE(cover.Upper(), 0.1);
}

TEST(JointCover, EndsWithTheLargestNumberOfCorners)
{
  const Corners over = { Vector3{ 0.1, 0.1, 0.1 }, { 3.9, 0.5, 0.1 }, { 0.1, 0.9, 0.1 } };
  Surface row = SquareFrom(0.0);
  for (const double x : { 1.0, 2.0, 3.0 })
  {
    const Surface square = SquareFrom(x);
    for (const Triangle& corners : square.Triangles)
    {
      const auto first = static_cast<Index>(row.Points.size());
      row.Triangles.push_back({ first, first + 1, first + 2 });
      for (const Index corner : corners)
      {
        row.Points.push_back(square.Points[corner]);
      }
    }
  }
  JointCover cover = CoverBy(row, over);
  EXPECT_EQ(cover.Run(0.2, 3), Outcome::Exceeded);
  EXPECT_EQ(cover.Run(0.2, JointCover::MaxCorners), Outcome::Covered) << "continues";
  EXPECT_GE(cover.Upper(), 0.1);
}

TEST(JointCover, HasUpTo64Candidates)
{
  const Corners any = CornersOf(SquareFrom(0.0), 0);
  JointCover cover = CoverOf(any);
  for (Index id = 0; id < 64; ++id)
  {
    EXPECT_FALSE(cover.Has(100 + id));
    EXPECT_TRUE(cover.Add(any, 100 + id));
    EXPECT_TRUE(cover.Has(100 + id));
  }
  EXPECT_FALSE(cover.Add(any, 1));
  EXPECT_EQ(cover.Run(1.0, 3), Outcome::Covered);
  EXPECT_EQ(cover.Upper(), 0.0);
}

TEST(JointCover, CoversMostOfASurfaceWithoutCuts)
{
  const Surface fine = BumpySphere(4, 10.0, 0.05, 5);
  const Surface coarse = BumpySphere(3, 10.0, 0.05, 5);
  CertificateOptions options;
  options.RelativeGap = 1e-2;
  const Certificate found = Certify(fine, coarse, options);
  EXPECT_LT(found.ReferenceToResult.Distance.Cuts, static_cast<int>(fine.Triangles.size()) / 20);
  EXPECT_LT(found.ResultToReference.Distance.Cuts, static_cast<int>(coarse.Triangles.size()) / 20);
}

TEST(PointValues, AreExactAboveWhatIsEnough)
{
  const Surface reference = BumpySphere(3, 10.0, 0.6, 5);
  const Surface result = Icosphere(2, 10.0);
  const certificate::EdgeSides sides = SidesOf(result);
  const certificate::Frame frame = certificate::FindFrame(reference, result);
  const certificate::Simplices source = certificate::WholeSurface(reference, sides, frame);
  const certificate::Simplices other = certificate::WholeSurface(result, sides, frame);
  const Target target(other, 1, [] {});
  for (const double enough : { -1.0, 0.0, 0.2, 0.4, 1e3 })
  {
    const certificate::PointValues values =
      certificate::FindPointValues(source, target, false, enough, 2, [](double) { return true; });
    for (std::size_t point = 0; point < reference.Points.size(); ++point)
    {
      const double exact = BruteNearest(result, reference.Points[point]).Distance;
      const double value = values.Value[point];
      EXPECT_GE(value, exact - 1e-12);
      EXPECT_LE(value, std::max(exact + 1e-12, enough));
      EXPECT_EQ(value, target.ValueTo(source.Points[point], values.Simplex[point]));
    }
  }
}

TEST(PointValues, AreNotThoseOfAnotherLayer)
{
  const Surface layers = Together(Grid(4), Moved(Grid(4), { 0.0, 0.0, 1.0 }));
  const certificate::EdgeSides sides = SidesOf(layers);
  const certificate::Frame frame = certificate::FindFrame(layers, layers);
  const certificate::Simplices set = certificate::WholeSurface(layers, sides, frame);
  const Target target(set, 1, [] {});
  Random random(7);
  for (int k = 0; k < 100; ++k)
  {
    const Vector3 p(random.Between(0.0, 4.0), random.Between(0.0, 4.0), random.Between(0.0, 1.0));
    const double exact = BruteNearest(layers, p).Distance;
    for (const double enough : { 0.1, 0.3, 0.6 })
    {
      for (const Index hint : { 5, 40 }) // of either layer
      {
        const Target::Candidate found = target.FindNear(p, hint, enough);
        EXPECT_LE(found.Value, std::max(exact + 1e-12, enough)) << k;
        EXPECT_EQ(found.Value, target.ValueTo(p, found.Simplex));
      }
    }
  }
}

TEST(EdgeSides, JoinPointsWithZerosOfDifferentSigns)
{
  Surface square = Unwelded(SquareFrom(0.0));
  for (Vector3& point : square.Points)
  {
    point -= Vector3(1.0, 1.0, 0.0); // both ends of the diagonal have zeros
  }
  const auto& of = square.Triangles[1];
  for (const Index corner : of)
  {
    Vector3& point = square.Points[corner];
    for (Eigen::Index axis = 0; axis < 3; ++axis)
    {
      point[axis] = point[axis] == 0.0 ? -0.0 : point[axis];
    }
  }
  const certificate::EdgeSides sides = SidesOf(square);
  EXPECT_EQ(std::count(sides[0].begin(), sides[0].end(), 1), 1);
  EXPECT_EQ(std::count(sides[1].begin(), sides[1].end(), 0), 1);
  EXPECT_EQ(certificate::FindBoundaries(square, sides).size(), 4U);
}
}
