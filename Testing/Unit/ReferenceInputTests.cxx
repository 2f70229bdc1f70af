// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The certificate confirms that a result used as input again keeps the largest error relative to
// the first original.
#include "Proof/Certificate/Certificate.h"
#include "Run/Input/ReferenceInput.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
constexpr double Settings = 0.4; // mm

using Map = std::vector<double>;

/// No tolerance above the plane x + y + z = 0, or below it; constrained on the other side.
Map Brush(const Surface& surface, bool above)
{
  Map map;
  for (const Vector3& p : surface.Points)
  {
    map.push_back((p.sum() > 0.0) == above ? -1.0 : 0.0);
  }
  return map;
}

Result Again(
  const Surface& input, const Options& options, const Surface& reference, const Map* map = nullptr)
{
  return Decimate(input, options, {}, { false, false, map, &reference });
}

ProofStatus Evaluate(const Surface& reference, const Surface& result, double error)
{
  CertificateOptions options;
  options.Tolerance = error;
  options.TightBounds = false;
  options.NumberOfThreads = 1;
  return Certify(reference, result, options).Proof;
}

using Corners = std::array<double, 9>;

std::multiset<Corners> ConstrainedTriangles(const Surface& surface, const Map& map)
{
  std::multiset<Corners> found;
  for (const Triangle& t : surface.Triangles)
  {
    if (std::any_of(t.begin(), t.end(), [&](Index v) { return map.empty() || map[v] == 0.0; }))
    {
      Corners corners;
      for (std::size_t i = 0; i < 9; ++i)
      {
        corners[i] = surface.Points[t[i / 3]][static_cast<Eigen::Index>(i % 3)];
      }
      found.insert(corners);
    }
  }
  return found;
}

/// The surface displaced along z by a wave.
Surface Wavy(Surface surface, double height)
{
  for (Vector3& p : surface.Points)
  {
    p[2] += height * std::sin(p[0]);
  }
  return surface;
}

class EachReference : public EachShape
{
};
}

TEST_P(EachReference, IsKeptOverThreeBrushes)
{
  const Surface& first = GetParam().Surface;
  if (!CanBeCertified(first))
  {
    GTEST_SKIP() << "triangles are left out";
  }
  Surface surface = first;
  for (const bool above : { true, false, true })
  {
    const Map map = Brush(surface, above);
    const Result next = Again(surface, InMode(Mode::Fast, ErrorOfAnySize(Settings)), first, &map);
    ASSERT_EQ(next.Report.Status, InputStatus::Good);
    EXPECT_EQ(next.Report.Proof.Status, ProofStatus::Proved) << ProofMessage(next.Report);
    EXPECT_EQ(Evaluate(first, next.Surface, Settings), ProofStatus::Proved);
    const std::multiset<Corners> before = ConstrainedTriangles(surface, map);
    const std::multiset<Corners> after = ConstrainedTriangles(next.Surface, {});
    EXPECT_TRUE(std::includes(after.begin(), after.end(), before.begin(), before.end()));
    surface = next.Surface;
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, EachReference, testing::ValuesIn(AllShapes()), NameOf);

TEST(ReferenceInput, LetsAnotherBrushSimplifyWhatTheFirstLeftAlone)
{
  const Surface first = BumpySphere(4, 20.0, 0.02, 3);
  const Options options = InMode(Mode::Fast, Error(Settings));
  const Map above = Brush(first, true);
  const Surface half = Again(first, options, first, &above).Surface;
  const Map below = Brush(half, false);
  const Result both = Again(half, options, first, &below);
  const std::size_t atOnce = Decimate(first, options).Surface.Triangles.size();
  EXPECT_LT(both.Surface.Triangles.size(), 2 * atOnce);
  EXPECT_LT(both.Surface.Triangles.size(), half.Triangles.size() / 2);
  EXPECT_EQ(Evaluate(first, both.Surface, Settings), ProofStatus::Proved);
}

TEST(ReferenceInput, WithoutItErrorsAddUpAndWithItTheyDoNot)
{
  const Surface first = BumpySphere(3, 20.0, 0.02, 3);
  const Options options = InMode(Mode::Fast, Error(Settings));
  Surface with = first;
  Surface without = first;
  for (int run = 0; run < 4; ++run)
  {
    with = Again(with, options, first).Surface;
    without = Decimate(without, options).Surface;
  }
  EXPECT_EQ(Evaluate(first, without, Settings), ProofStatus::Violated);
  EXPECT_EQ(Evaluate(first, with, Settings), ProofStatus::Proved);
}

TEST(ReferenceInput, OfItselfLeavesEverything)
{
  const Surface first = BumpySphere(3, 20.0, 0.02, 3);
  const Options options = InMode(Mode::Balanced, Error(Settings));
  const double alone = static_cast<double>(Decimate(first, options).Surface.Triangles.size());
  const double twice = static_cast<double>(Again(first, options, first).Surface.Triangles.size());
  EXPECT_NEAR(twice, alone, 0.03 * alone);
}

/// By brute force: a point of the reference is no farther than the error used at the nearest
/// triangle.
TEST(ReferenceInput, LeavesNoPointMoreThanItsNeighborsOfTheReferenceAllow)
{
  const Surface reference = Wavy(Grid(24), 0.0);
  const Surface input = Wavy(Grid(8), 0.2);
  const Surface scaled = Scaled(input, 3.0);
  const ReferenceInput found = CompareWithReference(
    reference, scaled, Clean(scaled, true), InMode(Mode::Fast, Error(1.5)), {});
  ASSERT_EQ(found.Status, InputStatus::Good);
  for (const Vector3& p : reference.Points)
  {
    const auto nearest = BruteNearest(scaled, p);
    for (const Index corner : scaled.Triangles[nearest.Triangle])
    {
      EXPECT_LE(nearest.Distance + found.Left[corner], 1.5 + 1e-9);
    }
  }
  for (std::size_t v = 0; v < scaled.Points.size(); ++v)
  {
    EXPECT_LE(BruteNearest(reference, scaled.Points[v]).Distance + found.Left[v], 1.5 + 1e-9);
  }
  EXPECT_GT(*std::max_element(found.Left.begin(), found.Left.end()), 0.3);
}

TEST(ReferenceInput, TakesWhatItsBoundariesUseFromBoundaryPoints)
{
  const Surface reference = Grid(8);
  const Surface input = Moved(Grid(8), Vector3(0.3, 0.0, 0.0)); // inside it lies on the reference
  const ReferenceInput found =
    CompareWithReference(reference, input, Clean(input, true), InMode(Mode::Fast, Error(0.5)), {});
  ASSERT_EQ(found.Status, InputStatus::Good);
  for (std::size_t v = 0; v < input.Points.size(); ++v)
  {
    const double y = input.Points[v][1];
    const bool isAtBoundary = y < 0.5 || y > 7.5;
    if (isAtBoundary)
    {
      EXPECT_LE(found.Left[v], 0.2 + 1e-9);
    }
    else if (input.Points[v][0] > 3.0 && input.Points[v][0] < 6.0)
    {
      EXPECT_GT(found.Left[v], 0.48);
    }
  }
}

TEST(ReferenceInput, IsRejectedIfItCannotBeUsed)
{
  const Surface first = Icosphere(3, 10.0);
  const Surface far = Icosphere(3, 11.0);
  const Options error = InMode(Mode::Fast, Error(Settings));
  const auto status = [&](const Options& options, const Surface& reference)
  {
    const Result rejected = Again(first, options, reference);
    EXPECT_TRUE(rejected.Surface.Triangles.empty());
    EXPECT_NE(InputMessage(rejected.Report), "");
    return rejected.Report.Status;
  };
  EXPECT_EQ(status(error, far), InputStatus::FarFromReference);
  EXPECT_EQ(status(error, Surface()), InputStatus::BadReference);
  EXPECT_EQ(status(Reduction(0.5), first), InputStatus::ReferenceWithoutError);
  EXPECT_EQ(
    status(InMode(Mode::Thesis, Error(Settings)), first), InputStatus::ReferenceWithoutError);
  Surface broken = first;
  broken.Points[0][1] = std::nan("");
  EXPECT_EQ(status(error, broken), InputStatus::BadReference);
  EXPECT_EQ(status(error, Grid(4)), InputStatus::FarFromReference);
}

TEST(ReferenceInput, IsWhatDistancesAreMeasuredTo)
{
  const Surface first = BumpySphere(3, 20.0, 0.02, 3);
  Options options = InMode(Mode::Fast, Error(Settings));
  const Surface once = Decimate(first, options).Surface;
  options.MeasureDistances = true;
  const Map constrained(once.Points.size(), 0.0);
  const Result same = Again(once, options, first, &constrained);
  EXPECT_EQ(ConstrainedTriangles(same.Surface, {}), ConstrainedTriangles(once, {}));
  EXPECT_GT(same.Report.OutputToInput.Maximum, 0.1);
  EXPECT_GT(same.Report.InputToOutput.Maximum, 0.1);
  EXPECT_LE(same.Report.InputToOutput.Maximum, same.Report.Proof.Upper());
  EXPECT_NEAR(same.Report.Reference.ToInput.Upper, same.Report.Proof.Upper(), 0.01 * Settings);
  EXPECT_EQ(same.Report.Reference.Faces, static_cast<std::int64_t>(first.Triangles.size()));
}

TEST(ReferenceInput, LeavesTolerancesWhatTheyAreAgainstTheInput)
{
  const Surface first = BumpySphere(3, 20.0, 0.02, 3);
  const Options options = InMode(Mode::Fast, Error(Settings));
  const Map above = Brush(first, true);
  const Surface half = Decimate(first, options, {}, { false, false, &above }).Surface;
  const Map map(half.Points.size(), 0.05);
  const Result result = Again(half, options, first, &map);
  EXPECT_EQ(result.Report.Proof.Status, ProofStatus::Proved);
  EXPECT_EQ(Evaluate(half, result.Surface, 0.05), ProofStatus::Proved);
  EXPECT_LT(result.Surface.Triangles.size(), half.Triangles.size());
}

TEST(ReferenceInput, GivesTheSameBytesForAnyNumberOfThreads)
{
  const Surface first = BumpySphere(3, 20.0, 0.02, 3);
  Options options = InMode(Mode::Balanced, Error(Settings));
  const Map above = Brush(first, true);
  const Surface half = Decimate(first, options, {}, { false, false, &above }).Surface;
  const Surface expected = Again(half, options, first).Surface;
  options.NumberOfThreads = 4;
  EXPECT_TRUE(SameBytes(Again(half, options, first).Surface, expected));
}

TEST(ReferenceInput, StopsOnAbort)
{
  const Surface first = BumpySphere(3, 20.0, 0.02, 3);
  const Result aborted = Decimate(first, InMode(Mode::Fast, Error(Settings)),
    [](double fraction) { return fraction < 0.01; }, { false, false, nullptr, &first });
  EXPECT_EQ(aborted.Report.Stop, StopReason::Aborted);
  EXPECT_EQ(aborted.Surface.Triangles.size(), first.Triangles.size());
}
