// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CertificatePairs.h"
#include "Proof/Certificate/SideFinder.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
CertificateOptions WithEverything()
{
  CertificateOptions options;
  options.WithMeans = true;
  options.WithPointDistances = true;
  options.RelativeGap = 1e-3;
  options.MeanPrecision = 1e-2;
  return options;
}

/// Query points that belong to no triangle, or to one far away.
Surface Cloud(int count, double half, std::uint64_t seed)
{
  Surface cloud = Moved(Scaled(Tetrahedron(), 0.01), { 50.0, 50.0, 50.0 });
  Random random(seed);
  for (int i = 0; i < count; ++i)
  {
    cloud.Points.push_back(random.InCube(half));
  }
  return cloud;
}

/// The solid angle under which a closed surface is seen, over 4 pi: 1 inside, 0 outside (A. Van
/// Oosterom, J. Strackee, The solid angle of a plane triangle, 1983).
double WindingNumber(const Surface& surface, const Vector3& p)
{
  double sum = 0.0;
  for (const Triangle& t : surface.Triangles)
  {
    const Vector3 a = surface.Points[t[0]] - p;
    const Vector3 b = surface.Points[t[1]] - p;
    const Vector3 c = surface.Points[t[2]] - p;
    const double volume = a.dot(b.cross(c));
    const double rest = a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() + b.dot(c) * a.norm() +
      c.dot(a) * b.norm();
    sum += 2.0 * std::atan2(volume, rest);
  }
  return sum / (4.0 * std::acos(-1.0));
}
}

TEST(CertificatePoints, HaveTheSideOfTheWindingNumber)
{
  for (const Surface& solid :
    { Scaled(Moved(Cube(2), { -0.5, -0.5, -0.5 }), 8.0), BumpySphere(2, 5.0, 0.3, 4), Torus(9, 6),
      Moved(Scaled(TunnelBlock(3), 2.0), { -3, -3, -3 }), Unwelded(Icosphere(1, 5.0)) })
  {
    const Surface cloud = Cloud(400, 9.0, 8);
    const Certificate found = Certify(cloud, solid, WithEverything());
    const SignedDistances& points = found.ReferenceToResult.Points;
    ASSERT_EQ(points.Side.size(), cloud.Points.size());
    for (std::size_t i = 0; i < cloud.Points.size(); ++i)
    {
      EXPECT_EQ(points.Side[i], WindingNumber(solid, cloud.Points[i]) > 0.5 ? -1 : 1);
      EXPECT_NEAR(points.Distance[i], BruteNearest(solid, cloud.Points[i]).Distance, 1e-9);
    }
  }
}

TEST(CertificatePoints, HaveNoSideOfABoundary)
{
  Surface cloud = Cloud(0, 1.0, 1);
  cloud.Points.emplace_back(1.5, 1.5, 0.25);  // above the plate
  cloud.Points.emplace_back(1.5, 1.5, -0.25); // below it
  cloud.Points.emplace_back(-1.0, 1.5, 0.25); // beyond its boundary
  cloud.Points.emplace_back(1.5, 1.5, 0.0);   // on it
  const Certificate found = Certify(cloud, Grid(3), WithEverything());
  const std::vector<signed char>& side = found.ReferenceToResult.Points.Side;
  const std::vector<signed char> expected = { 1, -1, 0, 0 };
  EXPECT_EQ(std::vector<signed char>(side.end() - 4, side.end()), expected);
}

TEST(CertificatePoints, ThatAreNotFiniteHaveNoDistance)
{
  Surface cloud = Cloud(1, 5.0, 1);
  cloud.Points.emplace_back(1e300, 0.0, 0.0);
  cloud.Points.emplace_back(std::nan(""), 0.0, 0.0);
  const Certificate found = Certify(cloud, Cube(1), WithEverything());
  ASSERT_EQ(found.Status, CertificateStatus::Good);
  EXPECT_TRUE(std::isnan(found.ReferenceToResult.Points.Distance.back()));
  EXPECT_TRUE(std::isnan(*(found.ReferenceToResult.Points.Distance.end() - 2)));
  EXPECT_EQ(found.ReferenceToResult.Points.Side.back(), 0);
}

TEST(CertificatePoints, AnglesAreThoseOfTheArcCosine)
{
  Random random(3);
  for (int i = 0; i < 10000; ++i)
  {
    const Vector3 a = random.InCube(2.0);
    const Vector3 b = i % 2 == 0 ? random.InCube(2.0) : Vector3(random.Between(-1, 1) * a);
    const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
    EXPECT_NEAR(certificate::AngleBetween(a, b), angle, 1e-8);
  }
  EXPECT_EQ(certificate::AngleBetween(Vector3::Zero(), Vector3::Ones()), 0.0);
}

TEST(CertificateMeans, OfParallelPlatesAreTheirDistance)
{
  const Certificate found = Certify(Grid(10), Moved(Grid(10), { 0.0, 0.0, 0.5 }), WithEverything());
  EXPECT_NEAR(found.ReferenceToResult.Mean.Mean, 0.5, 1e-12);
  EXPECT_NEAR(found.ReferenceToResult.Mean.RootMeanSquare, 0.5, 1e-12);
  EXPECT_NEAR(found.ReferenceToResult.Mean.Area, 100.0, 1e-9);
}

TEST(CertificateMeans, AreNotRefinedBelowRounding)
{
  const Surface ball = Icosphere(2, 10.0);
  const Certificate found = Certify(ball, ball, WithEverything());
  EXPECT_LE(found.ReferenceToResult.Mean.Mean, found.Slack);
  EXPECT_LE(found.ReferenceToResult.Mean.Samples, 1 << 16);
}

TEST(CertificateMeans, EqualTheIntegralWithinTheReportedError)
{
  // A plate above a tilted one: the distance rises linearly, d = h cos(angle).
  Surface tilted = Moved(Scaled(Grid(1), 40.0), { -15.0, -15.0, 0.0 });
  for (Vector3& point : tilted.Points)
  {
    point.z() = 0.1 * point.x();
  }
  const Surface plate = Moved(Grid(10), { 0.0, 0.0, 2.0 });
  const Certificate found = Certify(plate, tilted, WithEverything());
  const double cosine = 1.0 / std::sqrt(1.01);
  const MeanDistance& mean = found.ReferenceToResult.Mean;
  EXPECT_NEAR(mean.Mean, 1.5 * cosine, 1e-9);
  EXPECT_NEAR(mean.RootMeanSquare, std::sqrt(2.25 + 1.0 / 12.0) * cosine, mean.RootMeanSquareError);
  EXPECT_LE(mean.RootMeanSquareError, 1e-2 * mean.RootMeanSquare);
}

TEST(CertificateMeans, OfSpheresAgreeWithManyMoreSamples)
{
  const Surface fine = BumpySphere(4, 10.0, 0.02, 3);
  const Surface coarse = Icosphere(2, 10.0);
  const Certificate found = Certify(fine, coarse, WithEverything());
  CertificateOptions finer = WithEverything();
  finer.MeanPrecision = 3e-3;
  const Certificate reference = Certify(fine, coarse, finer);
  for (const auto& [a, b] :
    { std::pair(found.ReferenceToResult.Mean, reference.ReferenceToResult.Mean),
      std::pair(found.ResultToReference.Mean, reference.ResultToReference.Mean) })
  {
    EXPECT_LE(a.MeanError, 1e-2 * a.Mean);
    EXPECT_LE(a.RootMeanSquareError, 1e-2 * a.RootMeanSquare);
    EXPECT_LE(b.MeanError, a.MeanError);
    EXPECT_NEAR(a.Mean, b.Mean, a.MeanError + b.MeanError);
    EXPECT_NEAR(a.RootMeanSquare, b.RootMeanSquare, a.RootMeanSquareError + b.RootMeanSquareError);
  }
}
