// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CertificatePairs.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
constexpr double NoLimit = -1.0;

Certificate Against(
  const Surface& reference, const Surface& result, double tolerance, bool tight = true)
{
  CertificateOptions options;
  options.Tolerance = tolerance;
  options.TightBounds = tight;
  options.NumberOfThreads = 1;
  return Certify(reference, result, options);
}

Certificate AgainstMap(const Surface& reference, const Surface& result, std::vector<double> map,
  std::optional<double> tolerance = {})
{
  CertificateOptions options;
  options.Tolerance = tolerance;
  options.ToleranceMap = std::move(map);
  options.NumberOfThreads = 1;
  return Certify(reference, result, options);
}

std::vector<double> RandomMap(const Surface& surface, double most, std::uint64_t seed)
{
  Random random(seed);
  std::vector<double> map;
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    const double kind = random.Uniform();
    map.push_back(kind < 0.1 ? NoLimit : kind < 0.2 ? 0.0 : random.Between(0.0, most));
  }
  return map;
}

double LimitOf(double tolerance)
{
  return tolerance >= 0.0 ? tolerance : Infinity;
}

/// Linear between the corners; infinite if one that counts is.
double LimitAt(
  const std::vector<double>& map, const Triangle& corners, const std::array<double, 3>& weights)
{
  double limit = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    limit += weights[i] > 0.0 ? weights[i] * LimitOf(map[corners[i]]) : 0.0;
  }
  return limit;
}

/// Largest sampled excess of the reference over its tolerance, mm.
double SampledExcess(
  const Surface& reference, const Surface& result, const std::vector<double>& map)
{
  double largest = -Infinity;
  for (const Triangle& c : reference.Triangles)
  {
    ForEachSample(reference, c, 10,
      [&](const Vector3& position, const std::array<double, 3>& weights)
      {
        largest =
          std::max(largest, BruteNearest(result, position).Distance - LimitAt(map, c, weights));
      });
  }
  return largest;
}

/// Largest sampled excess of the result over the best triangle of the reference, mm.
double SampledExcessBack(
  const Surface& reference, const Surface& result, const std::vector<double>& map)
{
  double largest = -Infinity;
  const std::vector<Vector3>& p = reference.Points;
  for (const Triangle& corners : result.Triangles)
  {
    ForEachSample(result, corners, 10,
      [&](const Vector3& position, const auto&)
      {
        double least = Infinity;
        for (const Triangle& c : reference.Triangles)
        {
          const double limit =
            std::min({ LimitOf(map[c[0]]), LimitOf(map[c[1]]), LimitOf(map[c[2]]) });
          least =
            std::min(least, PointTriangleDistance(position, p[c[0]], p[c[1]], p[c[2]]) - limit);
        }
        largest = std::max(largest, least);
      });
  }
  return largest;
}
}

TEST(CertificateTolerance, IsProvedAboveTheDistanceAndViolatedBelow)
{
  for (const NamedPair& pair : SmallPairs())
  {
    SCOPED_TRACE(pair.Name);
    CertificateOptions bare;
    bare.WithBoundaries = false;
    const Certificate known = Certify(pair.Reference, pair.Result, bare);
    for (const bool tight : { true, false })
    {
      bare.TightBounds = tight;
      bare.Tolerance = known.Upper() * (1.0 + 1e-9);
      EXPECT_EQ(Certify(pair.Reference, pair.Result, bare).Proof, ProofStatus::Proved);
      bare.Tolerance = known.Lower() * (1.0 - 1e-9);
      EXPECT_EQ(Certify(pair.Reference, pair.Result, bare).Proof, ProofStatus::Violated);
    }
  }
}

TEST(CertificateTolerance, InsideOfTheGapIsRefinedFurther)
{
  const Surface reference = BumpySphere(3, 10.0, 0.05, 3);
  const Surface result = Icosphere(2, 10.0);
  const Certificate known = Certify(reference, result);
  CertificateOptions coarse;
  coarse.RelativeGap = 0.5;
  coarse.Tolerance = known.Upper() * (1.0 + 1e-9);
  EXPECT_EQ(Certify(reference, result, coarse).Proof, ProofStatus::Proved);
}

TEST(CertificateTolerance, OfZeroIsProvedOnlyForTheSameTriangles)
{
  const Surface plate = HoledPlate(6);
  EXPECT_EQ(Against(plate, plate, 0.0).Proof, ProofStatus::Proved);
  EXPECT_EQ(Against(plate, Unwelded(plate), 0.0).Proof, ProofStatus::Proved);
  EXPECT_EQ(Against(plate, Moved(plate, { 0.0, 0.0, 1e-6 }), 0.0).Proof, ProofStatus::Violated);
}

TEST(CertificateTolerance, WithinRoundingIsUndecided)
{
  const Surface plate = Grid(3);
  const Certificate found = Against(plate, Moved(plate, { 0.0, 0.0, 0.5 }), 0.5);
  EXPECT_EQ(found.Proof, ProofStatus::Undecided);
  EXPECT_LE(found.Lower(), 0.5);
  EXPECT_GE(found.Upper(), 0.5);
}

TEST(CertificateTolerance, BoundsOfMapsContainTheMaximumOfDenseSamples)
{
  for (const NamedPair& pair : SmallPairs())
  {
    SCOPED_TRACE(pair.Name);
    const std::vector<double> map = RandomMap(pair.Reference, 0.5, 7);
    const Certificate found = AgainstMap(pair.Reference, pair.Result, map);
    const double reach = SampleDistance(pair.Reference, pair.Result, 10).Reach;
    const double sampled = SampledExcess(pair.Reference, pair.Result, map);
    EXPECT_LE(std::max(0.0, sampled), std::max(0.0, found.ReferenceToResult.Excess.Upper));
    EXPECT_GE(sampled + 2.0 * reach, found.ReferenceToResult.Excess.Lower);
    const double reachBack = SampleDistance(pair.Result, pair.Reference, 10).Reach;
    const double sampledBack = SampledExcessBack(pair.Reference, pair.Result, map);
    EXPECT_LE(std::max(0.0, sampledBack), std::max(0.0, found.ResultToReference.Excess.Upper));
    EXPECT_GE(sampledBack + reachBack, found.ResultToReference.Excess.Lower);
  }
}

TEST(CertificateTolerance, AConstantMapIsASingleTolerance)
{
  for (const NamedPair& pair : SmallPairs())
  {
    SCOPED_TRACE(pair.Name);
    const Certificate known = Certify(pair.Reference, pair.Result);
    for (const double fraction : { 0.9, 1.1 })
    {
      const double tolerance = fraction * known.Upper();
      const std::vector<double> map(pair.Reference.Points.size(), tolerance);
      EXPECT_EQ(AgainstMap(pair.Reference, pair.Result, map).Proof,
        Against(pair.Reference, pair.Result, tolerance).Proof);
    }
  }
}

TEST(CertificateTolerance, ARampAllowsWhatRisesWithIt)
{
  // Along x the plate rises by 0.1 mm each millimeter, and so does the tolerance.
  const Surface plate = Grid(8);
  Surface raised = plate;
  std::vector<double> map;
  for (Vector3& point : raised.Points)
  {
    map.push_back(0.1 * point.x());
    point.z() += 0.0999 * point.x();
  }
  const Certificate good = AgainstMap(plate, raised, map);
  EXPECT_EQ(good.ReferenceToResult.Proof, ProofStatus::Proved);
  for (double& tolerance : map)
  {
    tolerance *= 0.9;
  }
  EXPECT_EQ(AgainstMap(plate, raised, map).ReferenceToResult.Proof, ProofStatus::Violated);
}

TEST(CertificateTolerance, OfZeroConstrainsItsPointsOnly)
{
  const Surface sphere = Icosphere(3, 10.0);
  Surface result = sphere;
  std::vector<double> map(sphere.Points.size(), 0.5);
  for (std::size_t i = 0; i < map.size(); ++i)
  {
    map[i] = sphere.Points[i].z() > 0.0 ? 0.0 : 0.5;
    result.Points[i] *= sphere.Points[i].z() < -4.0 ? 1.03 : 1.0;
  }
  EXPECT_EQ(AgainstMap(sphere, result, map).Proof, ProofStatus::Proved);
  const auto top = std::max_element(result.Points.begin(), result.Points.end(),
    [](const Vector3& a, const Vector3& b) { return a.z() < b.z(); });
  top->z() += 1e-6;
  EXPECT_EQ(AgainstMap(sphere, result, map).Proof, ProofStatus::Violated);
}

TEST(CertificateTolerance, OfZeroNextToNoLimitOrToARampIsDecided)
{
  const Surface sphere = Icosphere(3, 10.0);
  for (const double below : { NoLimit, 0.05 })
  {
    Surface result = sphere;
    std::vector<double> map;
    for (std::size_t i = 0; i < sphere.Points.size(); ++i)
    {
      const double z = sphere.Points[i].z();
      map.push_back(z > 0.0 ? 0.0 : below < 0.0 ? NoLimit : -below * z);
      result.Points[i] *= z < -4.0 ? 1.01 : 1.0;
    }
    EXPECT_EQ(AgainstMap(sphere, result, map).Proof, ProofStatus::Proved) << below;
    result.Points[0] *= 1.0 + 1e-7;
    map[0] = 0.0;
    EXPECT_EQ(AgainstMap(sphere, result, map).Proof, ProofStatus::Violated) << below;
  }
}

TEST(CertificateTolerance, MapWithoutLimitsIsAlwaysProved)
{
  const Surface plate = Grid(4);
  const Surface away = Moved(plate, { 0.0, 0.0, 9.0 });
  const std::vector<double> none(plate.Points.size(), NoLimit);
  EXPECT_EQ(AgainstMap(plate, away, none).Proof, ProofStatus::Proved);
  const std::vector<double> unknown(plate.Points.size(), std::nan(""));
  EXPECT_EQ(AgainstMap(plate, away, unknown).Proof, ProofStatus::Proved);
  EXPECT_EQ(AgainstMap(plate, away, none, 1.0).Proof, ProofStatus::Violated);
  EXPECT_EQ(AgainstMap(plate, away, none, 10.0).Proof, ProofStatus::Proved);
}

TEST(CertificateTolerance, ASingleLimitedPointIsChecked)
{
  const Surface plate = Grid(4);
  Surface result = Moved(plate, { 0.0, 0.0, 9.0 });
  std::vector<double> map(plate.Points.size(), NoLimit);
  map[12] = 0.25;
  EXPECT_EQ(AgainstMap(plate, result, map).ReferenceToResult.Proof, ProofStatus::Violated);
  result.Points[12].z() = 0.2;
  EXPECT_EQ(AgainstMap(plate, result, map).Proof, ProofStatus::Proved);
}

TEST(CertificateTolerance, AHugeMapDoesNotAffectTheSingleTolerance)
{
  // The slack depends on finite tolerances only.
  const Surface reference = Icosphere(2, 10.0);
  Surface result = reference;
  for (Vector3& point : result.Points)
  {
    point *= 1.0 + 1e-3; // 0.01 mm at the corners
  }
  const std::vector<double> huge(reference.Points.size(), 1e9);
  const double above = 0.01 * (1.0 + 1e-5);
  const double below = 0.01 * (1.0 - 1e-5);
  EXPECT_EQ(AgainstMap(reference, result, huge, above).Proof, ProofStatus::Proved);
  EXPECT_EQ(AgainstMap(reference, result, huge, below).Proof, ProofStatus::Violated);
}

TEST(CertificateTolerance, TheSingleToleranceCapsTheMap)
{
  const Surface plate = Grid(4);
  const Surface moved = Moved(plate, { 0.0, 0.0, 0.5 });
  const std::vector<double> generous(plate.Points.size(), 3.0);
  EXPECT_EQ(AgainstMap(plate, moved, generous).Proof, ProofStatus::Proved);
  EXPECT_EQ(AgainstMap(plate, moved, generous, 0.4).Proof, ProofStatus::Violated);
}

TEST(CertificateTolerance, ToleranceBeyondEveryDistanceDoesNotLoosenTheBounds)
{
  const Surface reference = Icosphere(2, 10.0);
  const Surface result = Moved(reference, { 0.05, 0.0, 0.0 });
  for (const bool isMap : { false, true })
  {
    CertificateOptions options;
    options.ToleranceMap.assign(isMap ? reference.Points.size() : 0, 0.1);
    (isMap ? options.ToleranceMap[0] : options.Tolerance.emplace()) = 1e12;
    const Certificate found = Certify(reference, result, options);
    EXPECT_EQ(found.Proof, ProofStatus::Proved);
    EXPECT_LE(found.Upper(), 0.0501);
    EXPECT_GE(found.Upper(), found.Lower());
  }
}
