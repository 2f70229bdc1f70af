// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterRun.h"
#include "Shapes.h"
#include "VtkSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <string>

using namespace bonedecimate::testsupport;

namespace
{
/// What holds for every run that is not aborted.
void ExpectSteady(const FilterRun& run)
{
  ASSERT_FALSE(run.Progress.empty());
  EXPECT_TRUE(std::is_sorted(run.Progress.begin(), run.Progress.end()));
  EXPECT_EQ(run.Progress.back(), 1.0);
  double before = 0.0;
  for (const double now : run.Progress)
  {
    EXPECT_LE(now - before, 0.01 + 1e-9) << "from " << before << " to " << now;
    before = now;
  }
}
}

TEST(Progress, OfALargeSurfaceGoesUpInStepsOfAtMostOnePercent)
{
  FilterRun run(Bumps(6));
  run->MeasureDistancesOn();
  run->SetNumberOfThreads(1);
  run->SetTargetNumberOfTriangles(8000);
  run->MeasureInputDistancesOn();
  run.Output();
  ExpectSteady(run);
}

TEST(Progress, OfASmallSurfaceGoesUpInStepsOfAtMostOnePercent)
{
  FilterRun run(Bumps(3));
  run->MeasureDistancesOn();
  run->SetNumberOfThreads(1);
  run->SetTargetNumberOfTriangles(100);
  run.Output();
  ExpectSteady(run);
}

TEST(Progress, WithoutMeasuringGoesUpInStepsOfAtMostOnePercent)
{
  FilterRun run(Bumps(4));
  run->SetTargetNumberOfTriangles(500);
  run.Output();
  ExpectSteady(run);
}

TEST(Progress, IsOneEventPerPercentWithAText)
{
  for (const double error : { 0.0, 0.2 })
  {
    FilterRun run(Bumps(5));
    run->MeasureDistancesOn();
    run->SetMaximumError(error);
    std::string text;
    run.OnEachProgress = [&](double fraction)
    { text = fraction > 0.0 ? run->GetProgressText() : ""; };
    run.Output();
    // A percent that takes long is told again, so that an observer can abort.
    const auto last = std::unique(run.Progress.begin(), run.Progress.end());
    const auto told = std::distance(run.Progress.begin(), last);
    EXPECT_LE(told, 103) << "with those of VTK at the start and at the end";
    EXPECT_GE(told, 100);
    EXPECT_EQ(text, "Simplifying the surface");
  }
}

TEST(Progress, NeverGoesBackWithSeveralThreads)
{
  FilterRun run(Bumps(5));
  run->MeasureDistancesOn();
  run->SetNumberOfThreads(4);
  run->MeasureInputDistancesOn();
  run.Output();
  EXPECT_TRUE(std::is_sorted(run.Progress.begin(), run.Progress.end()));
  EXPECT_EQ(run.Progress.back(), 1.0);
}

TEST(Progress, TowardsAnErrorNeverGoesBackAndEndsAtOne)
{
  FilterRun run(Bumps(4));
  run->MeasureDistancesOn();
  run->SetMaximumError(0.2);
  run.Output();
  EXPECT_TRUE(std::is_sorted(run.Progress.begin(), run.Progress.end()));
  EXPECT_EQ(run.Progress.back(), 1.0);
}

TEST(Progress, StaysBetweenZeroAndOneWhenNothingIsLeft)
{
  FilterRun run(PolyData(ManyComponents(12)));
  run->MeasureDistancesOn();
  run->SetTargetNumberOfTriangles(1);
  run.Output();
  EXPECT_TRUE(std::is_sorted(run.Progress.begin(), run.Progress.end()));
  EXPECT_GE(run.Progress.front(), 0.0);
  EXPECT_EQ(run.Progress.back(), 1.0);
}
