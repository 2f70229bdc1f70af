// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Which regions a run has, when the whole is run instead, and what is kept between runs.
#include "Proof/Certificate/Certificate.h"
#include "RegionRuns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

TEST(Region, GivesTheSameBytesForAnyNumberOfThreads)
{
  const Surface input = Ball();
  const Map map = Both(Brush(input, Pole, 7.0, 0.2), Brush(input, OtherPole, 5.0, 0.1));
  ExpectTheSameBytesForAnyNumberOfThreads(input, Fast(0.2), &map);
}

TEST(Region, IsOneOfSeveralUnlessTheyAreNear)
{
  const Surface input = Ball();
  const Map pole = Brush(input, Pole, 4.0, 0.05);
  EXPECT_EQ(
    Stroke(input, Fast(0.05), Both(pole, Brush(input, OtherPole, 4.0, 0.05))).Report.Regions.Count,
    2);
  const Map near = Brush(input, Vector3(9.5, 0.0, 17.6), 4.0, 0.05);
  EXPECT_EQ(Stroke(input, Fast(0.05), Both(pole, near)).Report.Regions.Count, 2);
  EXPECT_EQ(Stroke(input, Fast(0.4), Both(pole, near)).Report.Regions.Count, 1);
}

TEST(Region, OfNothingLeavesTheInput)
{
  const Surface input = Ball();
  const Result result = Stroke(input, Fast(0.2), Map(input.Points.size(), 0.0));
  EXPECT_EQ(result.Report.Regions.Status, RegionStatus::Used);
  EXPECT_EQ(result.Report.Regions.Count, 0);
  EXPECT_TRUE(SameBytes(result.Surface, input));
  EXPECT_EQ(result.Report.Proof.Status, ProofStatus::Proved);
  EXPECT_EQ(result.Report.Proof.Upper(), 0.0);
}

TEST(Region, SaysWhyTheWholeIsRun)
{
  const Surface input = Ball(4);
  const Map map = Brush(input, Pole, 5.0, 0.1);
  const auto status = [&](const Options& options, const Map& tolerances)
  { return Stroke(input, options, tolerances).Report.Regions.Status; };
  EXPECT_EQ(status(Fast(0.1), map), RegionStatus::Used);
  EXPECT_EQ(status(InMode(Mode::Fast, Unmeasured()), map), RegionStatus::Used);
  EXPECT_EQ(status(Fast(0.1), Map(input.Points.size(), 0.1)), RegionStatus::NotRequested);
  EXPECT_EQ(status(Fast(0.1), Brush(input, Pole, 30.0, 0.1)), RegionStatus::TooLarge);
  EXPECT_EQ(status(InMode(Mode::Fast, Triangles(5000)), map), RegionStatus::OtherOptions);
  EXPECT_EQ(status(InMode(Mode::Fast, Reduction(0.1)), map), RegionStatus::OtherOptions);
  Options smoothed = Fast(0.1);
  smoothed.Smoothing = 0.05;
  EXPECT_EQ(status(smoothed, map), RegionStatus::OtherOptions);
  Map unlimited = map;
  std::replace(unlimited.begin(), unlimited.end(), 0.1, -1.0);
  EXPECT_EQ(status(InMode(Mode::Fast, Unmeasured()), unlimited), RegionStatus::OtherOptions);
  EXPECT_EQ(status(Fast(0.1), unlimited), RegionStatus::Used);
}

TEST(Region, ThatIsAbortedStaysAsItWas)
{
  const Surface input = Ball();
  const Map map = Brush(input, Pole, 7.0, 0.2);
  RunInputs inputs = { false, true, &map };
  double told = 0.0;
  const Result result = Decimate(
    input, Fast(0.2),
    [&](double fraction)
    {
      EXPECT_GE(fraction, told);
      told = fraction;
      return fraction < 0.3;
    },
    inputs);
  EXPECT_EQ(result.Report.Stop, StopReason::Aborted);
  EXPECT_FALSE(result.Report.Proof.WasMade);
  EXPECT_TRUE(SameBytes(result.Surface, input));
}

TEST(RegionCache, ChangesNoByte)
{
  const Surface input = Ball();
  RegionCache cache;
  const Map pole = Brush(input, Pole, 6.0, 0.2);
  for (const Map& map : { pole, Both(pole, Brush(input, OtherPole, 6.0, 0.2)), pole })
  {
    const Result kept = Stroke(input, Fast(0.2), map, &cache);
    const Result fresh = Stroke(input, Fast(0.2), map);
    EXPECT_TRUE(SameBytes(kept.Surface, fresh.Surface));
    EXPECT_EQ(kept.ErrorBound, fresh.ErrorBound);
    EXPECT_EQ(kept.Origins.NearestPoint, fresh.Origins.NearestPoint);
    EXPECT_EQ(kept.Report.Edits.Collapses, fresh.Report.Edits.Collapses);
    EXPECT_EQ(kept.Report.Proof.Upper(), fresh.Report.Proof.Upper());
  }
}

TEST(RegionCache, RunsOnlyRegionsThatAreNewAndUndoesWithoutARun)
{
  const Surface input = Ball();
  RegionCache cache;
  const Map one = Brush(input, Pole, 6.0, 0.2);
  const Map two = Both(one, Brush(input, OtherPole, 6.0, 0.2));
  EXPECT_EQ(Stroke(input, Fast(0.2), one, &cache).Report.Regions.Kept, 0);
  EXPECT_EQ(Stroke(input, Fast(0.2), two, &cache).Report.Regions.Kept, 1);
  EXPECT_EQ(Stroke(input, Fast(0.2), two, &cache).Report.Regions.Kept, 2);
  const Result undone = Stroke(input, Fast(0.2), one, &cache);
  EXPECT_EQ(undone.Report.Regions.Kept, 1);
  EXPECT_EQ(undone.Report.Regions.Count, 1);
}

TEST(RegionCache, NoticesAnotherInputOptionOrTolerance)
{
  Surface input = Ball();
  RegionCache cache;
  const Map map = Brush(input, Pole, 6.0, 0.2);
  const auto kept = [&](const Options& options, const Map& tolerances)
  { return Stroke(input, options, tolerances, &cache).Report.Regions.Kept; };
  EXPECT_EQ(kept(Fast(0.2), map), 0);
  EXPECT_EQ(kept(Fast(0.2), map), 1);
  EXPECT_EQ(kept(Fast(0.1), map), 0);
  EXPECT_EQ(kept(InMode(Mode::Balanced, Error(0.2)), map), 0);
  Options unguarded = Fast(0.2);
  unguarded.IntersectionGuard = false;
  EXPECT_EQ(kept(unguarded, map), 0);
  EXPECT_EQ(kept(Fast(0.2), Brush(input, Pole, 6.0, 0.15)), 0);
  EXPECT_EQ(kept(Fast(0.2), map), 1);
  Options threads = Fast(0.2);
  threads.NumberOfThreads = 2;
  EXPECT_EQ(kept(threads, map), 1);

  const std::size_t far =
    static_cast<std::size_t>(std::min_element(input.Points.begin(), input.Points.end(),
                               [](const Vector3& a, const Vector3& b) { return a[2] < b[2]; }) -
      input.Points.begin());
  input.Points[far] *= 1.01; // in place
  const Result moved = Stroke(input, Fast(0.2), map, &cache);
  EXPECT_EQ(moved.Report.Regions.Kept, 0);
  EXPECT_TRUE(SameBytes(moved.Surface, Stroke(input, Fast(0.2), map).Surface));
  std::swap(input.Triangles[5][0], input.Triangles[5][1]);
  EXPECT_EQ(kept(Fast(0.2), map), 0);
}

TEST(RegionCache, ReleasesItsMemory)
{
  const Surface input = Ball(4);
  RegionCache cache;
  EXPECT_EQ(cache.Bytes(), 0U);
  Stroke(input, Fast(0.2), Map(input.Points.size(), 0.2), &cache);
  EXPECT_EQ(cache.Bytes(), 0U); // nothing is kept of other runs
  Stroke(input, Fast(0.2), Brush(input, Pole, 6.0, 0.2), &cache);
  const std::size_t one = cache.Bytes();
  EXPECT_GT(one, input.Triangles.size() * sizeof(Triangle));
  std::size_t most = one;
  for (int i = 0; i < 20; ++i)
  {
    const double angle = 0.3 * i;
    const Vector3 center(20.0 * std::sin(angle), 0.0, 20.0 * std::cos(angle));
    Stroke(input, Fast(0.2), Brush(input, center, 9.0, 0.2), &cache);
    most = std::max(most, cache.Bytes());
  }
  EXPECT_LT(most, one + 400 * input.Triangles.size());
  cache.Release();
  EXPECT_EQ(cache.Bytes(), 0U);
  EXPECT_EQ(Stroke(input, Fast(0.2), Brush(input, Pole, 6.0, 0.2), &cache).Report.Regions.Kept, 0);
}
