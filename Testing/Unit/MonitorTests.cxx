// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Unusable inputs, progress and abort.
#include "BruteForce.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
void ExpectRejected(const Surface& input, InputStatus status)
{
  const Result result = Decimate(input, Options{});
  EXPECT_EQ(result.Report.Status, status);
  EXPECT_EQ(result.Report.Stop, StopReason::NotRun);
  EXPECT_TRUE(result.Surface.Points.empty());
  EXPECT_TRUE(result.Surface.Triangles.empty());
  EXPECT_TRUE(result.Distance.empty());
  EXPECT_TRUE(result.Origins.NearestTriangle.empty());
  EXPECT_FALSE(result.Report.DistancesMeasured);
  EXPECT_NE(InputMessage(result.Report), "");
}

/// Records all calls of the monitor.
std::vector<double> Heard(const Surface& input, const Options& options)
{
  std::vector<double> heard;
  Decimate(input, options,
    [&](double fraction)
    {
      heard.push_back(fraction);
      return true;
    });
  return heard;
}
}

TEST(DecimateRejections, UnusableInputsGiveAnEmptySurfaceAndAReason)
{
  Surface bad = Tetrahedron();
  ExpectRejected({}, InputStatus::Empty);
  ExpectRejected({ bad.Points, {} }, InputStatus::NoTriangles);
  ExpectRejected({ bad.Points, { { 0, 0, 1 } } }, InputStatus::NoTriangles);
  bad.Triangles[1][2] = 4;
  ExpectRejected(bad, InputStatus::IndexOutOfRange);
  bad = Tetrahedron();
  bad.Points[2].z() = std::numeric_limits<double>::quiet_NaN();
  ExpectRejected(bad, InputStatus::NonFinitePoints);
  bad.Points[2].z() = 1e31;
  ExpectRejected(bad, InputStatus::HugeCoordinates);
}

TEST(DecimateRejections, ExtremeButFiniteCoordinatesGiveFiniteResults)
{
  for (const double factor : { 1e29, 1e-100, 1e-140 })
  {
    const Result result = Decimate(Scaled(Icosphere(2, 1.0), factor), Reduction(0.5));
    EXPECT_EQ(WhatIsWrong(result.Surface), "") << factor;
    EXPECT_EQ(CountTopology(result.Surface).EulerNumber, 2) << factor;
    for (const double distance : result.Distance)
    {
      EXPECT_TRUE(std::isfinite(distance)) << factor;
    }
  }
}

TEST(DecimateRejections, DroppedAndConstrainedPartsAreCountedAndTheFirstIsNamed)
{
  Surface input = PinchedVertex(8, 3);
  input.Triangles.insert(input.Triangles.begin(), { 3, 3, 4 });
  const Result result = Decimate(input, Reduction(0.3));
  EXPECT_EQ(result.Report.Cleaning.DroppedTriangles, 1);
  EXPECT_EQ(result.Report.Cleaning.FirstDroppedTriangle, 0);
  EXPECT_EQ(result.Report.Cleaning.NonManifoldPoints, 1);
  EXPECT_EQ(result.Report.Cleaning.FirstNonManifoldPoint, 0);
  const Result book = Decimate(ThreeLeavedBook(5), Reduction(0.3));
  EXPECT_EQ(book.Report.Cleaning.NonManifoldPoints, 6);
  EXPECT_EQ(book.Report.Input.NonManifoldEdges, 5);
}

TEST(DecimateMonitor, ReceivesNondecreasingFractionsFromZeroToOne)
{
  for (const NamedSurface& shape : AllShapes())
  {
    for (const Mode mode : AllModes())
    {
      double last = 0.0;
      for (const double fraction : Heard(shape.Surface, InMode(mode, Reduction(0.7))))
      {
        EXPECT_GE(fraction, last) << shape.Name << WordOf(mode);
        EXPECT_LE(fraction, 1.0) << shape.Name << WordOf(mode);
        last = fraction;
      }
      EXPECT_EQ(last, 1.0) << shape.Name << WordOf(mode);
    }
  }
}

TEST(DecimateMonitor, IsCalledAtLeastEveryHundredth)
{
  const Surface input = Icosphere(5, 20.0);
  Options plain = Reduction(0.9);
  Options measured = plain;
  measured.MeasureDistances = true;
  Options everything = measured;
  everything.MeasureInputDistances = true;
  for (const Options& options : { measured, everything, plain, InMode(Mode::Fast, plain),
         InMode(Mode::Balanced, plain), InMode(Mode::Accurate, plain) })
  {
    double last = 0.0;
    for (const double fraction : Heard(input, options))
    {
      EXPECT_LE(fraction - last, 0.01 + 1e-9)
        << WordOf(options.Mode) << " after " << last << ", distances " << options.MeasureDistances
        << ", of the input " << options.MeasureInputDistances;
      last = fraction;
    }
  }
}

TEST(DecimateMonitor, AbortAtAnyTimeLeavesAValidSurface)
{
  const Surface input = BumpySphere(3, 20.0, 0.1, 5);
  Options options = Reduction(0.9);
  options.MeasureDistances = true;
  options.MeasureInputDistances = true;
  std::int64_t fewest = std::numeric_limits<std::int64_t>::max();
  for (const double stopAt : { 0.0, 0.015, 0.1, 0.3, 0.5, 0.69, 0.705, 0.8, 0.9, 0.96, 0.98 })
  {
    int callsAfter = 0;
    const Result result = Decimate(input, options,
      [&](double fraction)
      {
        callsAfter += fraction >= stopAt ? 1 : 0;
        return fraction < stopAt;
      });
    EXPECT_EQ(result.Report.Stop, StopReason::Aborted) << stopAt;
    EXPECT_EQ(callsAfter, 1) << stopAt << ": once is enough";
    EXPECT_EQ(WhatIsWrong(result.Surface), "") << stopAt;
    EXPECT_EQ(CountTopology(result.Surface).EulerNumber, 2) << stopAt;
    const bool abortedBeforeMeasuring = result.Distance.empty();
    EXPECT_EQ(abortedBeforeMeasuring, stopAt < 0.7) << stopAt;
    EXPECT_TRUE(abortedBeforeMeasuring || result.Distance.size() == result.Surface.Points.size())
      << stopAt;
    EXPECT_LE(CountTopology(result.Surface).Faces, fewest) << stopAt;
    EXPECT_FALSE(stopAt < 0.9 && result.Report.DistancesMeasured) << stopAt;
    fewest = CountTopology(result.Surface).Faces;
  }
  EXPECT_EQ(fewest, 128);
}

TEST(DecimateMonitor, AbortAtAnyTimeOfTheRelaxationLeavesAValidSurface)
{
  const Surface input = BumpySphere(4, 20.0, 0.1, 5);
  for (const Mode mode : { Mode::Balanced, Mode::Accurate })
  {
    for (double stopAt = 0.0; stopAt < 0.95; stopAt += 0.05)
    {
      int callsAfter = 0;
      const Result result = Decimate(input, InMode(mode, Reduction(0.9)),
        [&](double fraction)
        {
          callsAfter += fraction >= stopAt ? 1 : 0;
          return fraction < stopAt;
        });
      EXPECT_EQ(result.Report.Stop, StopReason::Aborted) << WordOf(mode) << stopAt;
      EXPECT_EQ(callsAfter, 1) << WordOf(mode) << stopAt << ": once is enough";
      EXPECT_EQ(WhatIsWrong(result.Surface), "") << WordOf(mode) << stopAt;
      EXPECT_EQ(CountTopology(result.Surface).EulerNumber, 2) << WordOf(mode) << stopAt;
    }
  }
}

TEST(DecimateMonitor, AMonitorThatNeverAbortsChangesNothing)
{
  const Surface input = BumpySphere(3, 20.0, 0.1, 5);
  const Result watched = Decimate(input, Reduction(0.9), [](double) { return true; });
  EXPECT_TRUE(SameBytes(watched.Surface, Decimate(input, Reduction(0.9)).Surface));
}
