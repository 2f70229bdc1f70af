// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CertificatePairs.h"
#include "Proof/Certificate/Frame.h"
#include "Proof/Certificate/Search.h"
#include "Proof/Certificate/Target.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
constexpr double Tiny = 1e-7; // mm, more than the least gap of these small shapes

bool GoOn(double)
{
  return true;
}

/// The position is on its triangle, and its distance to the other surface is within the bounds.
void ExpectGoodPosition(const DistanceBounds& bounds, const Surface& from, const Surface& to)
{
  ASSERT_NE(bounds.Triangle, None);
  const Triangle& corners = from.Triangles[bounds.Triangle];
  EXPECT_LE(PointTriangleDistance(bounds.Position, from.Points[corners[0]], from.Points[corners[1]],
              from.Points[corners[2]]),
    Tiny);
  EXPECT_GE(BruteNearest(to, bounds.Position).Distance, bounds.Lower);
  EXPECT_LE(BruteNearest(to, bounds.Position).Distance, bounds.Upper);
}

void ExpectBracket(const DistanceBounds& bounds, const Surface& from, const Surface& to)
{
  const Sampled sampled = SampleDistance(from, to, 12);
  EXPECT_LE(sampled.Largest, bounds.Upper);
  EXPECT_GE(sampled.Largest + sampled.Reach, bounds.Lower);
  EXPECT_LE(bounds.Lower, bounds.Upper);
  EXPECT_LE(bounds.Upper - bounds.Lower, 1e-6 * bounds.Upper + Tiny);
  ExpectGoodPosition(bounds, from, to);
}

Certificate Compare(const Surface& reference, const Surface& result, int threads = 1)
{
  CertificateOptions options;
  options.NumberOfThreads = threads;
  return Certify(reference, result, options);
}

void ExpectSame(const DistanceBounds& a, const DistanceBounds& b)
{
  EXPECT_EQ(a.Lower, b.Lower);
  EXPECT_EQ(a.Upper, b.Upper);
  EXPECT_EQ(a.Position, b.Position);
  EXPECT_EQ(a.Triangle, b.Triangle);
  EXPECT_EQ(a.NearestTriangle, b.NearestTriangle);
  EXPECT_EQ(a.Cuts, b.Cuts);
}

void ExpectBoth(const Certificate& found, double distance)
{
  for (const DirectedCertificate& side : { found.ReferenceToResult, found.ResultToReference })
  {
    EXPECT_NEAR(side.Distance.Lower, distance, 1e-6 * distance + Tiny);
    EXPECT_NEAR(side.Distance.Upper, distance, 1e-6 * distance + Tiny);
  }
}
}

TEST(Certificate, BoundsContainTheMaximumOfDenseSamples)
{
  for (const NamedPair& pair : SmallPairs())
  {
    SCOPED_TRACE(pair.Name);
    const Certificate found = Compare(pair.Reference, pair.Result);
    ASSERT_EQ(found.Status, CertificateStatus::Good);
    ExpectBracket(found.ReferenceToResult.Distance, pair.Reference, pair.Result);
    ExpectBracket(found.ResultToReference.Distance, pair.Result, pair.Reference);
  }
}

TEST(Certificate, OfASurfaceWithItselfIsExactlyZero)
{
  for (const NamedSurface& shape : AllShapes())
  {
    SCOPED_TRACE(shape.Name);
    const Certificate found = Compare(shape.Surface, shape.Surface);
    EXPECT_EQ(found.Lower(), 0.0);
    EXPECT_EQ(found.Upper(), 0.0);
    EXPECT_EQ(found.BoundaryOfReferenceToResult.Distance.Upper, 0.0);
    EXPECT_EQ(found.BoundaryOfResultToReference.Distance.Upper, 0.0);
  }
}

TEST(Certificate, ParallelPlatesAreAsFarApartAsTheyWereMoved)
{
  ExpectBoth(Compare(Grid(10), Moved(Grid(10), { 0.0, 0.0, 0.5 })), 0.5);
  ExpectBoth(Compare(Grid(12), Moved(Scaled(Grid(4), 3.0), { 0.0, 0.0, 0.25 })), 0.25);
}

TEST(Certificate, AFlatPlateInOtherTrianglesIsAtNoDistance)
{
  ExpectBoth(Compare(Cube(7), Scaled(Scaled(Cube(3), 0.5), 2.0)), 0.0);
}

TEST(Certificate, OfCubesIsTheDistanceOfTheirCorners)
{
  // The larger cube's corners are sqrt(3) away, the smaller one's sides 1.
  const Surface inner = Moved(Scaled(Cube(3), 2.0), { 1.0, 1.0, 1.0 });
  const Certificate found = Compare(Scaled(Cube(2), 4.0), inner);
  EXPECT_NEAR(found.ReferenceToResult.Distance.Upper, std::sqrt(3.0), 1e-5);
  EXPECT_NEAR(found.ReferenceToResult.Distance.Lower, std::sqrt(3.0), 1e-5);
  EXPECT_NEAR(found.ResultToReference.Distance.Upper, 1.0, 1e-5);
  EXPECT_NEAR(found.ResultToReference.Distance.Lower, 1.0, 1e-5);
}

TEST(Certificate, FindsTheMaximumInsideOfATriangleWhereNoPointIs)
{
  // Above the middle of the triangle both surfaces are equally far.
  Surface middle = SingleTriangle();
  const Surface surfaces = Together(
    Moved(Scaled(Grid(1), 4.0), { -1.0, -1.0, 0.25 }), Moved(Scaled(Grid(1), 0.1), { 0, 0, 0 }));
  const Certificate found = Compare(middle, surfaces);
  ExpectBracket(found.ReferenceToResult.Distance, middle, surfaces);
  EXPECT_NEAR(found.ReferenceToResult.Distance.Lower, 0.25, 1e-6);
}

TEST(Certificate, OfSpheresIsBetweenTheRadii)
{
  const Certificate found = Compare(Icosphere(3, 10.0), Icosphere(3, 10.5));
  EXPECT_GT(found.Lower(), 0.48);
  EXPECT_NEAR(found.Upper(), 0.5, 1e-5);
  EXPECT_LE(found.Upper() - found.Lower(), 1e-6);
}

TEST(Certificate, NarrowsTheGapHoweverSmallTheDistance)
{
  const Surface sphere = Icosphere(1, 5.0);
  for (double amplitude = 1.0; amplitude > 1e-6; amplitude *= 0.1)
  {
    const Certificate found = Compare(sphere, Shaken(sphere, amplitude, 5));
    EXPECT_GT(found.Lower(), 0.1 * amplitude);
    EXPECT_LE(found.Upper() - found.Lower(), 1e-6 * found.Upper() + 1e-8);
  }
}

TEST(Certificate, SwapsItsDirectionsWithTheSurfaces)
{
  for (const NamedPair& pair : SmallPairs())
  {
    SCOPED_TRACE(pair.Name);
    const Certificate found = Compare(pair.Reference, pair.Result);
    const Certificate swapped = Compare(pair.Result, pair.Reference);
    ExpectSame(found.ReferenceToResult.Distance, swapped.ResultToReference.Distance);
    ExpectSame(found.ResultToReference.Distance, swapped.ReferenceToResult.Distance);
    ExpectSame(
      found.BoundaryOfReferenceToResult.Distance, swapped.BoundaryOfResultToReference.Distance);
  }
}

TEST(Certificate, IsTheSameForAnyNumberOfThreads)
{
  const Surface reference = BumpySphere(5, 10.0, 0.05, 3);
  const Surface result = Together(Icosphere(3, 10.0), HoledPlate(6));
  const Certificate one = Compare(Together(reference, Grid(6)), result, 1);
  for (const int threads : { 2, 4, 8 })
  {
    const Certificate many = Compare(Together(reference, Grid(6)), result, threads);
    ExpectSame(one.ReferenceToResult.Distance, many.ReferenceToResult.Distance);
    ExpectSame(one.ResultToReference.Distance, many.ResultToReference.Distance);
    ExpectSame(one.BoundaryOfReferenceToResult.Distance, many.BoundaryOfReferenceToResult.Distance);
    ExpectSame(one.BoundaryOfResultToReference.Distance, many.BoundaryOfResultToReference.Distance);
  }
}

TEST(Certificate, ScalesWithTheSurfaces)
{
  const Surface reference = BumpySphere(3, 10.0, 0.05, 3);
  const Surface result = Icosphere(2, 10.0);
  const Certificate found = Compare(reference, result);
  const Certificate scaled = Compare(Scaled(reference, 1024.0), Scaled(result, 1024.0));
  EXPECT_EQ(scaled.ReferenceToResult.Distance.Cuts, found.ReferenceToResult.Distance.Cuts);
  EXPECT_NEAR(scaled.Lower(), 1024.0 * found.Lower(), 1e-9);
  EXPECT_NEAR(scaled.Upper(), 1024.0 * found.Upper(), 1e-9);
}

TEST(Certificate, LosesNothingFarFromTheOrigin)
{
  // Multiples of 1/1024 so that moving is exact.
  const auto rounded = [](Surface surface)
  {
    for (Vector3& point : surface.Points)
    {
      point = (point * 1024.0).array().round() / 1024.0;
    }
    return surface;
  };
  const Surface reference = Moved(rounded(BumpySphere(3, 10.0, 0.05, 3)), { 16.0, 16.0, -16.0 });
  const Surface result = Moved(rounded(Icosphere(2, 10.0)), { 16.0, 16.0, -16.0 });
  const Vector3 far(1048576.0, 2097152.0, -1048576.0);
  const Certificate here = Compare(reference, result);
  const Certificate there = Compare(Moved(reference, far), Moved(result, far));
  EXPECT_LE(there.Slack, here.Slack);
  EXPECT_NEAR(there.Lower(), here.Lower(), 1e-6 * here.Lower());
  EXPECT_NEAR(there.Upper(), here.Upper(), 1e-6 * here.Upper());
  const Vector3 moved = there.ReferenceToResult.Distance.Position - far;
  EXPECT_LE((moved - here.ReferenceToResult.Distance.Position).norm(), 1e-3);
}

TEST(Certificate, HoldsForAnyCandidatesOfTheSearch)
{
  for (const NamedPair& pair : SmallPairs())
  {
    SCOPED_TRACE(pair.Name);
    using namespace bonedecimate::certificate;
    const Frame frame = FindFrame(pair.Reference, pair.Result);
    const EdgeSides ofReference = SidesOf(pair.Reference);
    const EdgeSides ofResult = SidesOf(pair.Result);
    const Simplices source = WholeSurface(pair.Reference, ofReference, frame);
    const Simplices other = WholeSurface(pair.Result, ofResult, frame);
    const Target target(other, 1, [] {});
    PointValues values = FindPointValues(source, target, false, -1.0, 1, GoOn);
    Random random(17);
    for (std::size_t point = 0; point < source.Points.size(); ++point)
    {
      values.Simplex[point] = random.Below(static_cast<Index>(other.Size()));
      values.Value[point] = target.ValueTo(source.Points[point], values.Simplex[point]);
    }
    SearchGoal goal;
    goal.CloseBelow = -Infinity;
    goal.RelativeGap = 1e-6;
    goal.Slack = Slack(frame.Extent);
    goal.MinGap = 4.0 * goal.Slack;
    goal.MaxCuts = 1000;
    goal.NumberOfThreads = 1;
    const DistanceBounds found = FindMaxExcess(source, target, values, goal, {}, GoOn);
    const Sampled sampled = SampleDistance(pair.Reference, pair.Result, 8);
    EXPECT_LE(sampled.Largest, found.Upper);
    EXPECT_GE(sampled.Largest + sampled.Reach, found.Lower);
  }
}

TEST(Certificate, BoundsAreValidWithFewCuts)
{
  const Surface reference = BumpySphere(3, 10.0, 0.1, 5);
  const Surface result = Icosphere(1, 10.0);
  CertificateOptions options;
  options.MaxCuts = 1;
  const Certificate few = Certify(reference, result, options);
  const Certificate full = Certify(reference, result);
  EXPECT_GE(few.Upper(), full.Lower());
  EXPECT_LE(few.Lower(), full.Upper());
  EXPECT_LT(few.Upper(), Infinity);
}

TEST(Certificate, ReportsSurfacesThatCannotBeCompared)
{
  const Surface good = Tetrahedron();
  Surface outside = good;
  outside.Triangles[0][0] = 4;
  Surface infinite = good;
  infinite.Points[2].y() = std::nan("");
  Surface unused = good;
  unused.Points.emplace_back(std::nan(""), 0.0, 0.0);
  EXPECT_EQ(Certify(Surface(), good).Status, CertificateStatus::EmptyReference);
  EXPECT_EQ(Certify(good, Surface()).Status, CertificateStatus::EmptyResult);
  EXPECT_EQ(Certify(outside, good).Status, CertificateStatus::BadReference);
  EXPECT_EQ(Certify(good, infinite).Status, CertificateStatus::BadResult);
  EXPECT_EQ(Certify(unused, good).Upper(), 0.0);
  CertificateOptions options;
  EXPECT_EQ(Certify(good, Surface(), options).Proof, ProofStatus::NotRequested);
  options.Tolerance = 1.0;
  EXPECT_EQ(Certify(good, Surface(), options).Proof, ProofStatus::Violated);
  EXPECT_EQ(Certify(Surface(), good, options).Proof, ProofStatus::Violated);
  options = {};
  options.ToleranceMap = { 1.0 };
  EXPECT_EQ(Certify(good, good, options).Status, CertificateStatus::BadTolerance);
  options.ToleranceMap.clear();
  options.Tolerance = -1.0;
  EXPECT_EQ(Certify(good, good, options).Status, CertificateStatus::BadTolerance);
}

/// In single precision the points of a flat grid lie on lines that are not quite straight: 15
/// million cuts to the last digit.
TEST(Certificate, OfAFlatPartInOtherTrianglesEndsSoonWithALeastGap)
{
  Surface grid = Scaled(Grid(28), 1.0 / 28.0);
  for (Vector3& p : grid.Points)
  {
    p = p.unaryExpr([](double x) { return static_cast<double>(static_cast<float>(x)); });
  }
  CertificateOptions options;
  options.MinGap = 1e-5;
  const Certificate found = Certify(grid, Grid(1), options);
  EXPECT_LE(found.Upper(), 1e-5);
  EXPECT_LT(found.ResultToReference.Distance.Cuts, 200000);
}
