// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CertificatePairs.h"
#include "Proof/Certificate/EdgeSides.h"
#include "Proof/Certificate/Foot.h"
#include "Run/Decimate.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{

using Edges = std::vector<std::pair<Index, Index>>;

Edges Sorted(Edges edges)
{
  std::sort(edges.begin(), edges.end());
  return edges;
}

Edges BoundariesFound(const Surface& surface)
{
  Edges edges;
  for (const certificate::BoundaryEdge& edge :
    certificate::FindBoundaries(surface, SidesOf(surface)))
  {
    edges.emplace_back(edge.Points[0], edge.Points[1]);
  }
  return Sorted(edges);
}
}

TEST(CertificateBoundaries, AreTheEdgesOfOneTriangle)
{
  for (const std::vector<NamedSurface>& list : { ClosedShapes(), OpenShapes() })
  {
    for (const NamedSurface& shape : list)
    {
      SCOPED_TRACE(shape.Name);
      const bool isWelded = shape.Name.find("Unwelded") == std::string::npos;
      EXPECT_EQ(
        BoundariesFound(shape.Surface), isWelded ? Sorted(BoundaryEdges(shape.Surface)) : Edges());
    }
  }
}

TEST(CertificateBoundaries, SidesAreTheSameForAnyNumberOfThreads)
{
  Surface torn = BumpySphere(5, 10.0, 0.05, 3); // so many points that several threads take part
  torn.Triangles.erase(torn.Triangles.begin() + 100);
  for (const Surface& surface : { torn, Unwelded(torn), Together(torn, RandomSoup(9, 7, 1)) })
  {
    const certificate::EdgeSides one = SidesOf(surface);
    for (const int threads : { 2, 3, 64 })
    {
      EXPECT_EQ(certificate::FindEdgeSides(surface.Points, surface.Triangles, threads), one);
    }
  }
}

TEST(CertificateBoundaries, AreFoundBetweenRepeatedPoints)
{
  for (const Surface& shape : { HoledPlate(6), OpenCylinder(8, 3), Annulus(8, 2) })
  {
    EXPECT_EQ(BoundariesFound(Unwelded(shape)).size(), BoundaryEdges(shape).size());
  }
  EXPECT_TRUE(BoundariesFound(Unwelded(Icosphere(2, 5.0))).empty());
}

TEST(CertificateBoundaries, AreMeasuredCurveToCurve)
{
  // The sides of the hole are 4 mm from the outer boundary, and no surface is far from the other.
  const Surface holed = HoledPlate(12);
  const Surface plate = Grid(12);
  const Certificate found = Certify(holed, plate);
  EXPECT_EQ(found.Boundaries, BoundaryPresence::Both);
  EXPECT_NEAR(found.ReferenceToResult.Distance.Upper, 0.0, 1e-9);
  EXPECT_NEAR(found.BoundaryOfReferenceToResult.Distance.Lower, 4.0, 1e-5);
  EXPECT_NEAR(found.BoundaryOfResultToReference.Distance.Upper, 0.0, 1e-9);
}

TEST(CertificateBoundaries, FindTheMaximumBetweenTheirPoints)
{
  // A triangle's boundary to one with a dent in the middle of an edge.
  Surface straight;
  straight.Points = { { 0, 0, 0 }, { 4, 0, 0 }, { 2, 9, 0 } };
  straight.Triangles = { { 0, 1, 2 } };
  Surface dented = straight;
  dented.Points.emplace_back(2.0, 1.0, 0.0);
  dented.Triangles = { { 0, 3, 2 }, { 3, 1, 2 } };
  const Certificate found = Certify(straight, dented);
  const double expected = 2.0 / std::sqrt(5.0); // from the middle of the edge to the dent's sides
  EXPECT_NEAR(found.BoundaryOfReferenceToResult.Distance.Lower, expected, 1e-5);
  EXPECT_NEAR(found.BoundaryOfReferenceToResult.Distance.Upper, expected, 1e-5);
  EXPECT_NEAR(found.BoundaryOfReferenceToResult.Distance.Position.x(), 2.0, 1e-3);
  EXPECT_NEAR(found.BoundaryOfResultToReference.Distance.Upper, 1.0, 1e-5);
  EXPECT_EQ(found.BoundaryOfReferenceToResult.Distance.Triangle, 0);
}

TEST(CertificateBoundaries, OfOneSurfaceAloneAreInfinitelyFar)
{
  CertificateOptions options;
  options.Tolerance = 100.0;
  const Surface open = Grid(2);
  const Surface closed = Cube(2);
  const Certificate lost = Certify(open, closed, options);
  EXPECT_EQ(lost.Boundaries, BoundaryPresence::ReferenceOnly);
  EXPECT_EQ(lost.BoundaryOfReferenceToResult.Distance.Lower, Infinity);
  EXPECT_EQ(lost.BoundaryOfResultToReference.Distance.Upper, 0.0);
  EXPECT_EQ(lost.Proof, ProofStatus::Violated);
  const Certificate torn = Certify(closed, open, options);
  EXPECT_EQ(torn.Boundaries, BoundaryPresence::ResultOnly);
  EXPECT_EQ(torn.Proof, ProofStatus::Violated);
  options.WithBoundaries = false;
  EXPECT_EQ(Certify(open, closed, options).Proof, ProofStatus::Proved);
}

TEST(CertificateBoundaries, OfClosedSurfacesKeepAnyTolerance)
{
  CertificateOptions options;
  options.Tolerance = 0.1;
  const Certificate found = Certify(Cube(2), Cube(3), options);
  EXPECT_EQ(found.Boundaries, BoundaryPresence::Neither);
  EXPECT_EQ(found.BoundaryOfReferenceToResult.Distance.Upper, 0.0);
  EXPECT_EQ(found.Proof, ProofStatus::Proved);
}

TEST(CertificateBoundaries, AreInTheReportOfEveryMode)
{
  const Surface open = OpenCylinder(60, 20);
  for (const Mode mode : AllModes())
  {
    Options options;
    options.Mode = mode;
    options.TargetReduction = 0.8;
    options.TargetReductionIsExplicit = true;
    const Result result = Decimate(open, options);
    CertificateOptions boundariesAlone;
    boundariesAlone.WithSurfaces = false;
    const Certificate found = Certify(open, result.Surface, boundariesAlone);
    ASSERT_TRUE(result.Report.BoundariesMeasured);
    const DistanceBounds& there = found.BoundaryOfReferenceToResult.Distance;
    const DistanceBounds& back = found.BoundaryOfResultToReference.Distance;
    EXPECT_NEAR(result.Report.BoundaryInputToOutput.Lower, there.Lower, 1e-9);
    EXPECT_NEAR(result.Report.BoundaryInputToOutput.Upper, there.Upper, 1e-9);
    EXPECT_NEAR(result.Report.BoundaryOutputToInput.Upper, back.Upper, 1e-9);
    EXPECT_FALSE(Decimate(Icosphere(2, 5.0), options).Report.BoundariesMeasured);
    options.MeasureDistances = false;
    EXPECT_FALSE(Decimate(open, options).Report.BoundariesMeasured);
  }
}

TEST(CertificateFoot, BoundsTheDistanceInAnyTriangle)
{
  Random random(11);
  for (int i = 0; i < 200000; ++i)
  {
    // From fat triangles to needles and points: the third corner ever nearer to the line of the
    // others.
    const Vector3 a = random.InCube(10.0);
    const Vector3 b = a + random.InCube(i % 2 == 0 ? 10.0 : 1e-3);
    const double off = std::pow(10.0, -random.Between(-1.0, 17.0));
    const Vector3 c = a + random.Between(-0.5, 1.5) * (b - a) + random.InCube(off);
    const Vector3 p =
      i % 3 == 0 ? Vector3(0.3 * a + 0.3 * b + 0.4 * c + random.InCube(1e-6)) : random.InCube(10.0);
    const double distance = PointTriangleDistance(p, a, b, c);
    const certificate::Corners corners = { a, b, c };
    const certificate::Foot foot = certificate::FindFoot(p, corners);
    const double slack = 1e-9; // the oracle's own: it is worse in needles
    EXPECT_GE(foot.Distance, distance - slack);
    EXPECT_LE(foot.Distance, distance + 1e-9);
    EXPECT_LE(certificate::DistanceFromBelow(p, corners, foot), distance + slack);
    EXPECT_GE(certificate::DistanceFromBelow(p, corners, foot), distance * (1.0 - 1e-7) - slack);
  }
}
