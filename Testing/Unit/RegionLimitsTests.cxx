// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Runs over regions at the limits of what they may leave out.
#include "RegionRuns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// A tolerance in a square of a grid.
Map Square(const Surface& grid, double from, double to, double tolerance)
{
  Map map;
  for (const Vector3& p : grid.Points)
  {
    const bool isInside = p[0] >= from && p[0] <= to && p[1] >= from && p[1] <= to;
    map.push_back(isInside ? tolerance : 0.0);
  }
  return map;
}
}

TEST(RegionLimits, RegionsWithNeighboringPointsAreOne)
{
  const Surface grid = Grid(80);
  const double error = 0.02; // much less than an edge
  const Map map = Both(Square(grid, 10.0, 20.0, error), Square(grid, 21.0, 31.0, error));
  const Report report = Stroke(grid, Fast(error), map).Report;
  EXPECT_EQ(report.Regions.Status, RegionStatus::Used);
  EXPECT_EQ(report.Regions.Count, 1);
  const Map apart = Both(Square(grid, 10.0, 20.0, error), Square(grid, 24.0, 34.0, error));
  EXPECT_EQ(Stroke(grid, Fast(error), apart).Report.Regions.Count, 2);
}

TEST(RegionLimits, WithoutARegionEverythingIsProvedToBeAsItWas)
{
  const Surface ball = Ball();
  const Map nothing(ball.Points.size(), 0.0);
  const Result result = Stroke(ball, Fast(0.2), nothing);
  EXPECT_EQ(result.Report.Regions.Status, RegionStatus::Used);
  EXPECT_TRUE(result.Report.Proof.WasMade);
  EXPECT_EQ(result.ErrorBound, std::vector<double>(ball.Points.size(), 0.0));
}

TEST(RegionLimits, BoundariesOfSeparateTrianglesAreNotMeasured)
{
  const Surface grid = HeightField(60, 0.1, 4);
  Options options = Fast(0.2);
  options.MergePoints = false;
  options.MeasureDistances = true;
  const Map map = Square(grid, 0.0, 12.0, 0.2);
  EXPECT_EQ(Stroke(grid, options, map).Report.Regions.Status, RegionStatus::Used);
  EXPECT_FALSE(Stroke(grid, options, map).Report.BoundariesMeasured);
  EXPECT_FALSE(StrokeOfWhole(grid, options, map).Report.BoundariesMeasured);
}

TEST(RegionLimits, NothingIsReportedThatWasNotRequested)
{
  const Surface ball = Ball();
  const Map map = Brush(ball, Pole, 4.0, 0.2);
  Options options = Fast(0.2);
  options.MeasureDistances = false;
  const Result result = Decimate(ball, options, {}, { false, false, &map });
  EXPECT_EQ(result.Report.Regions.Status, RegionStatus::Used);
  EXPECT_TRUE(std::isnan(result.Report.RunningError));
}

TEST(RegionLimits, AnAbortEndsTheRunAndLeavesNoBound)
{
  const Surface ball = Ball();
  const Map map = Both(Brush(ball, Pole, 4.0, 0.2), Brush(ball, OtherPole, 4.0, 0.2));
  for (const int stopAt : { 1, 3, 6, 10, 15 })
  {
    int calls = 0;
    const Monitor once = [&](double) { return ++calls != stopAt; };
    const Result result = Decimate(ball, Fast(0.2), once, { false, true, &map });
    if (calls >= stopAt)
    {
      EXPECT_EQ(result.Report.Stop, StopReason::Aborted) << stopAt;
      EXPECT_EQ(result.ErrorBound.empty(), !result.Report.Proof.WasMade) << stopAt;
    }
  }
}

TEST(RegionLimits, PointsOfNoTriangleAreNoRegion)
{
  Surface ball = Ball(3);
  Map map(ball.Points.size(), -1.0);
  const std::size_t used = ball.Points.size();
  ball.Points.resize(3 * used, Vector3(50.0, 0.0, 0.0));
  map.resize(3 * used, 0.0);
  const Report report = Stroke(ball, Fast(0.2), map).Report;
  EXPECT_NE(report.Regions.Status, RegionStatus::Used);
  EXPECT_EQ(report.Status, InputStatus::Good);
}

TEST(RegionLimits, WhatIsRejectedKeepsNoMemory)
{
  const Surface ball = Ball();
  Map map = Brush(ball, Pole, 4.0, 0.2);
  map.back() = std::numeric_limits<double>::quiet_NaN();
  RegionCache cache;
  EXPECT_NE(Stroke(ball, Fast(0.2), map, &cache).Report.Status, InputStatus::Good);
  EXPECT_EQ(cache.Bytes(), 0U);
}
