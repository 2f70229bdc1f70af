// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The certificate confirms that tolerances are kept; points with a tolerance of 0 do not change in
// any bit.
#include "Proof/Certificate/Certificate.h"
#include "Proof/ErrorBound/ErrorBound.h"
#include "Random.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
using Map = std::vector<double>;

Result DecimateWith(const Surface& input, const Options& options, const Map& tolerances)
{
  return Decimate(input, options, {}, { false, false, &tolerances });
}

/// Proved, or undecided within the slack of the certificate, which is the best possible for a
/// distance of 0 in a soup.
ProofStatus CheckMap(const Surface& input, const Surface& result, const Map& tolerances)
{
  CertificateOptions options;
  options.ToleranceMap = tolerances;
  options.TightBounds = false;
  options.NumberOfThreads = 1;
  const Certificate found = Certify(input, result, options);
  const double excess = std::max({ found.ReferenceToResult.Excess.Upper,
    found.ResultToReference.Excess.Upper, found.BoundaryOfReferenceToResult.Excess.Upper,
    found.BoundaryOfResultToReference.Excess.Upper });
  return excess <= 2.0 * found.Slack ? ProofStatus::Proved : found.Proof;
}

/// A few constrained, a few without a limit, the rest anything up to that; smooth enough for values
/// in between.
Map RandomMap(const Surface& surface, double most, std::uint64_t seed)
{
  Random random(seed);
  const Vector3 constrained =
    surface
      .Points[static_cast<std::size_t>(random.Below(static_cast<Index>(surface.Points.size())))];
  const Vector3 free =
    surface
      .Points[static_cast<std::size_t>(random.Below(static_cast<Index>(surface.Points.size())))];
  const double reach = random.Between(0.0, 6.0); // mm
  Map map;
  for (const Vector3& p : surface.Points)
  {
    const double ramp = std::min(1.0, std::max(0.0, (p - constrained).norm() - reach) / 4.0);
    const bool isFree = (p - free).norm() < 2.0 && ramp > 0.5;
    map.push_back(isFree ? -1.0 : most * ramp * random.Between(0.5, 1.0));
  }
  return map;
}

/// One tolerance above the plane z = 0, another below it.
Map Halves(const Surface& surface, double above, double below)
{
  Map map;
  for (const Vector3& p : surface.Points)
  {
    map.push_back(p[2] > 0.0 ? above : below);
  }
  return map;
}

using Corners = std::array<double, 9>;

Corners CornersOf(const Surface& surface, const Triangle& t)
{
  Corners corners;
  for (std::size_t i = 0; i < 9; ++i)
  {
    corners[i] = surface.Points[t[i / 3]][static_cast<Eigen::Index>(i % 3)];
  }
  return corners;
}

/// Every input triangle at a point of tolerance 0 is in the result, and as often as in the input.
void ExpectConstrained(const Surface& input, const Map& map, const Surface& result)
{
  std::map<Corners, int> missing;
  std::map<std::array<double, 3>, bool> constrained;
  for (std::size_t i = 0; i < map.size(); ++i)
  {
    const Vector3& p = input.Points[i];
    bool& isConstrained = constrained[{ p[0], p[1], p[2] }];
    isConstrained = isConstrained || map[i] == 0.0;
  }
  for (const Triangle& t : input.Triangles)
  {
    const bool stays = std::any_of(t.begin(), t.end(),
      [&](Index v)
      {
        const Vector3& p = input.Points[v];
        return constrained[{ p[0], p[1], p[2] }];
      });
    missing[CornersOf(input, t)] += stays ? 1 : 0;
  }
  for (const Triangle& t : result.Triangles)
  {
    const auto found = missing.find(CornersOf(result, t));
    if (found != missing.end())
    {
      --found->second;
    }
  }
  for (const auto& entry : missing)
  {
    EXPECT_LE(entry.second, 0);
  }
}

class EachTolerance : public EachShape
{
};
}

TEST_P(EachTolerance, IsKeptWhateverTheShape)
{
  const Surface& input = GetParam().Surface;
  if (!CanBeCertified(input))
  {
    GTEST_SKIP() << "what cleaning drops from it may be farther away than anything";
  }
  double most = 0.1; // mm
  std::uint64_t seed = 1;
  for (const Mode mode : ProvingModes())
  {
    const Map map = RandomMap(input, most, ++seed);
    Options options = InMode(mode, Unmeasured());
    options.MaximumError = mode == Mode::Balanced ? 0.7 * most : 0.0;
    const Result result = DecimateWith(input, options, map);
    EXPECT_EQ(CheckMap(input, result.Surface, map), ProofStatus::Proved)
      << WordOf(mode) << " " << most;
    ExpectConstrained(input, map, result.Surface);
    most *= 3.0;
  }
}

TEST_P(EachTolerance, OfZeroConstrainsInEveryMode)
{
  const Surface& input = GetParam().Surface;
  Map map = RandomMap(input, 1.0, 5);
  for (double& tolerance : map)
  {
    tolerance = tolerance == 0.0 ? 0.0 : -1.0;
  }
  if (!CanBeCertified(input))
  {
    GTEST_SKIP() << "what cleaning drops from it may be farther away than anything";
  }
  for (const Mode mode : AllModes())
  {
    const Result result = DecimateWith(input, InMode(mode, Reduction(0.9)), map);
    ExpectConstrained(input, map, result.Surface);
    EXPECT_EQ(result.Report.Edits.Rejections[static_cast<std::size_t>(Rejection::ErrorBound)], 0)
      << WordOf(mode);
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, EachTolerance, testing::ValuesIn(AllShapes()), NameOf);

TEST(Tolerance, OfZeroLeavesTheRestToBeSimplified)
{
  const Surface input = Icosphere(4, 20.0); // 5,120 triangles
  const Map map = Halves(input, 0.0, -1.0);
  for (const Mode mode : AllModes())
  {
    const Result result = DecimateWith(input, InMode(mode, Triangles(3000)), map);
    EXPECT_EQ(result.Surface.Triangles.size(), 3000U) << WordOf(mode);
    EXPECT_EQ(result.Report.Stop, StopReason::TargetReached) << WordOf(mode);
    ExpectConstrained(input, map, result.Surface);
  }
}

TEST(Tolerance, OfZeroEverywhereLeavesEverything)
{
  const Surface input = BumpySphere(3, 10.0, 0.1, 2);
  const Result result = DecimateWith(input, Unmeasured(), Map(input.Points.size(), 0.0));
  EXPECT_EQ(result.Surface.Triangles.size(), input.Triangles.size());
  EXPECT_EQ(
    result.Report.Cleaning.ConstrainedPoints, static_cast<std::int64_t>(input.Points.size()));
}

TEST(Tolerance, CountsOnlyPointsWithAToleranceOfZero)
{
  const Surface input = Icosphere(3, 10.0);
  Map map(input.Points.size(), -1.0);
  map[7] = 0.0;
  const Result result = DecimateWith(input, Reduction(0.5), map);
  EXPECT_EQ(result.Report.Cleaning.ConstrainedPoints, 1);
  EXPECT_EQ(result.Report.Cleaning.NonManifoldPoints, 0);
  ExpectConstrained(input, map, result.Surface);
}

TEST(Tolerance, AllowsFewerTrianglesTheLargerItIs)
{
  const Surface input = Icosphere(4, 20.0);
  std::size_t before = input.Triangles.size();
  for (const double tolerance : { 0.1, 0.5, 2.0 })
  {
    const Map map = Halves(input, tolerance, tolerance * 2.0);
    const Result result = DecimateWith(input, InMode(Mode::Fast, Unmeasured()), map);
    EXPECT_LT(2 * result.Surface.Triangles.size(), before) << tolerance;
    EXPECT_EQ(result.Report.Stop, StopReason::ErrorReached);
    EXPECT_EQ(CheckMap(input, result.Surface, map), ProofStatus::Proved);
    before = result.Surface.Triangles.size();
  }
}

TEST(Tolerance, IsUsedWhereItIsPositive)
{
  const Surface input = Icosphere(4, 20.0);
  const Result result =
    DecimateWith(input, InMode(Mode::Fast, Unmeasured()), Halves(input, 0.1, 2.0));
  int above = 0;
  for (const Vector3& p : result.Surface.Points)
  {
    above += p[2] > 0.0 ? 1 : 0;
  }
  EXPECT_GT(above, 4 * (static_cast<int>(result.Surface.Points.size()) - above));
}

TEST(Tolerance, OfTheSameEverywhereIsALargestError)
{
  const Surface input = BumpySphere(3, 20.0, 0.01, 8);
  for (const Mode mode : { Mode::Fast, Mode::Balanced })
  {
    const Surface alone = Decimate(input, InMode(mode, Error(0.2))).Surface;
    const Map map(input.Points.size(), 0.2);
    const Result result = DecimateWith(input, InMode(mode, Unmeasured()), map);
    EXPECT_TRUE(SameBytes(result.Surface, alone)) << WordOf(mode);
  }
}

TEST(Tolerance, IsCappedByTheLargestError)
{
  const Surface input = BumpySphere(4, 20.0, 0.01, 8);
  Map map(input.Points.size(), 3.0);
  map[5] = -1.0;
  const Result result = DecimateWith(input, InMode(Mode::Fast, Error(0.4)), map);
  EXPECT_LT(result.Surface.Triangles.size(), input.Triangles.size() / 2);
  EXPECT_EQ(CheckMap(input, result.Surface, Map(input.Points.size(), 0.4)), ProofStatus::Proved);
}

TEST(Tolerance, NegativeEverywhereChangesNothing)
{
  const Surface input = BumpySphere(3, 20.0, 0.05, 8);
  const Map none(input.Points.size(), -1.0);
  for (const Mode mode : AllModes())
  {
    const Options options = InMode(mode, Reduction(0.8));
    EXPECT_TRUE(
      SameBytes(DecimateWith(input, options, none).Surface, Decimate(input, options).Surface))
      << WordOf(mode);
  }
}

TEST(Tolerance, EndsAtTheNumberOfTrianglesIfThatComesFirst)
{
  const Surface input = BumpySphere(4, 20.0, 0.01, 8);
  const Map map = Halves(input, 0.3, -1.0);
  for (const Mode mode : ProvingModes())
  {
    const Result result = DecimateWith(input, InMode(mode, Triangles(2500)), map);
    EXPECT_EQ(result.Report.Stop, StopReason::TargetReached) << WordOf(mode);
    EXPECT_EQ(result.Surface.Triangles.size(), 2500U) << WordOf(mode);
    EXPECT_EQ(CheckMap(input, result.Surface, map), ProofStatus::Proved) << WordOf(mode);
  }
}

TEST(Tolerance, LeavesTheDefaultReductionInForceWhereSomePointsHaveNone)
{
  const Surface input = BumpySphere(4, 20.0, 0.01, 8);
  const Result some = DecimateWith(input, Unmeasured(), Halves(input, 2.0, -1.0));
  EXPECT_EQ(some.Report.Stop, StopReason::TargetReached);
  EXPECT_EQ(some.Surface.Triangles.size(), input.Triangles.size() / 10);
  const Result all = DecimateWith(input, Unmeasured(), Halves(input, 2.0, 2.0));
  EXPECT_LT(all.Surface.Triangles.size(), input.Triangles.size() / 10);
}

TEST(Tolerance, OfEqualPointsIsTheSmallest)
{
  const Surface input = Unwelded(Icosphere(3, 10.0));
  Map map(input.Points.size(), -1.0);
  map[11] = 0.0;
  const Result result = DecimateWith(input, Reduction(0.9), map);
  EXPECT_EQ(result.Report.Cleaning.ConstrainedPoints, 1);
  ExpectConstrained(input, map, result.Surface);
}

TEST(Tolerance, IsRejectedIfItIsNaNOrMissingForAPoint)
{
  const Surface input = Icosphere(2, 10.0);
  for (const double bad : { std::nan(""), std::numeric_limits<double>::infinity(), 1e31 })
  {
    Map map(input.Points.size(), 1.0);
    map[3] = bad;
    const Report report = DecimateWith(input, Unmeasured(), map).Report;
    EXPECT_EQ(report.Status, InputStatus::BadTolerances);
    EXPECT_NE(InputMessage(report).find("point 3"), std::string::npos);
  }
  const Report report = DecimateWith(input, Unmeasured(), Map(5, 1.0)).Report;
  EXPECT_EQ(report.Status, InputStatus::BadTolerances);
  EXPECT_FALSE(InputMessage(report).empty());
}

TEST(Tolerance, ThatIsPositiveIsRejectedInThesisMode)
{
  const Surface input = Icosphere(2, 10.0);
  const Options thesis = InMode(Mode::Thesis, Unmeasured());
  const Report report = DecimateWith(input, thesis, Halves(input, 0.5, 0.0)).Report;
  EXPECT_EQ(report.Status, InputStatus::UnprovableTolerances);
  EXPECT_NE(InputMessage(report).find("Thesis"), std::string::npos);
}

TEST(Tolerance, GivesTheSameBytesForAnyNumberOfThreads)
{
  Surface input = Grid(140); // enough points for blocks
  Map map;
  for (Vector3& p : input.Points)
  {
    p[2] += 0.8 * std::sin(0.31 * p[0]) * std::cos(0.23 * p[1]);
    map.push_back(0.0015 * std::max(0.0, p[0] - 40.0));
  }
  ExpectTheSameBytesForAnyNumberOfThreads(input, InMode(Mode::Fast, Triangles(32000)), &map);
  for (double& tolerance : map)
  {
    tolerance = tolerance == 0.0 ? 0.0 : -1.0;
  }
  ExpectTheSameBytesForAnyNumberOfThreads(input, InMode(Mode::Balanced, Triangles(32000)), &map);
}

TEST(Tolerance, DoesNotDependOnTheUnitOfLength)
{
  const Surface input = BumpySphere(3, 20.0, 0.02, 8);
  Map map = RandomMap(input, 1.0, 3);
  const Options options = InMode(Mode::Fast, Unmeasured());
  const Surface small = DecimateWith(input, options, map).Surface;
  for (double& tolerance : map)
  {
    tolerance *= 4.0;
  }
  const Surface large = DecimateWith(Scaled(input, 4.0), options, map).Surface;
  EXPECT_TRUE(SameBytes(Scaled(small, 4.0), large));
}

TEST(ErrorLimits, AreTheSmallerOfToleranceAndErrorAndLinearInBetween)
{
  const Surface grid = Grid(4);
  const HalfEdgeMesh mesh(grid);
  Map map(grid.Points.size(), 0.5);
  map[0] = 0.0;
  map[1] = 2.0;
  map[2] = -1.0;
  ErrorBoundSettings settings;
  settings.Error = 1.0;
  settings.Tolerances = &map;
  const ErrorLimits limits(mesh, settings);
  EXPECT_FALSE(limits.IsUniform());
  EXPECT_EQ(limits.At(0), 0.0);
  EXPECT_NEAR(limits.At(1), 1.0, 3e-4);
  EXPECT_NEAR(limits.At(2), 1.0, 3e-4);
  EXPECT_NEAR(limits.At(3), 0.5, 3e-4);
  for (const Index v : { 1, 2, 3 })
  {
    EXPECT_LT(limits.At(v), v == 3 ? 0.5 : 1.0) << "no slack";
  }
  for (Index face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    const Triangle c = mesh.Corners(face);
    EXPECT_EQ(
      limits.OfTriangle(face), std::min({ limits.At(c[0]), limits.At(c[1]), limits.At(c[2]) }));
  }
  EXPECT_DOUBLE_EQ(ErrorLimits::Interpolate(1.0, 3.0, 0.25), 1.5);
  settings.Error = ErrorBoundSettings().Error;
  EXPECT_TRUE(std::isinf(ErrorLimits(mesh, settings).At(2)));
  EXPECT_TRUE(std::isinf(ErrorLimits::Interpolate(ErrorBoundSettings().Error, 3.0, 0.5)));
}
