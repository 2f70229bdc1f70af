// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BruteForce.h"
#include "FilterRun.h"
#include "Shapes.h"
#include "VtkSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
struct Outcome
{
  bonedecimate::Surface Surface;
  std::vector<double> Distance;
  std::vector<double> RunningError;
  std::vector<double> PointCount;
  std::vector<double> InputDistance;
  std::vector<std::string> Report; ///< Without what may differ: times and the number of threads.
};

bool MayDiffer(const std::string& entry)
{
  return entry.rfind("seconds.", 0) == 0 || entry == "options.NumberOfThreads";
}

Outcome OutcomeOf(FilterRun& run)
{
  run->MeasureDistancesOn();
  run->MeasureInputDistancesOn();
  vtkPolyData* output = run.Output();
  Outcome outcome{ SurfaceOf(output), Values(output, "Distance"), Values(output, "RunningError"),
    Values(output, "InputPointCount"), Values(run.InputCopy(), "DistanceToResult"), {} };
  for (int i = 0; i < run->GetNumberOfReportEntries(); ++i)
  {
    const std::string name = run->GetReportEntryName(i);
    outcome.Report.push_back(name + " " + (MayDiffer(name) ? "" : run->GetReportText(name)));
  }
  return outcome;
}

void ExpectSame(const Outcome& a, const Outcome& b)
{
  EXPECT_TRUE(SameBytes(a.Surface, b.Surface));
  EXPECT_EQ(a.Distance, b.Distance);
  EXPECT_EQ(a.RunningError, b.RunningError);
  EXPECT_EQ(a.PointCount, b.PointCount);
  EXPECT_EQ(a.InputDistance, b.InputDistance);
  EXPECT_EQ(a.Report, b.Report);
}

Outcome WithThreads(int threads)
{
  FilterRun run(Bumps(5));
  run->SetNumberOfThreads(threads);
  return OutcomeOf(run);
}

/// A bone-like open surface of several pieces.
Surface Pieces()
{
  return Together(
    BumpySphere(3, 10.0, 0.05, 4), Moved(HeightField(18, 1.0, 6), { 30.0, 0.0, 0.0 }));
}

/// Coordinates as multiples of 2^-20, so that adding numbers like 4096 is exact.
Surface OnAGrid(Surface surface)
{
  for (Vector3& p : surface.Points)
  {
    p = (p * 1048576.0).array().round() / 1048576.0;
  }
  return surface;
}

Surface ResultOf(const Surface& input, double maximumError)
{
  FilterRun run(PolyData(input));
  run->SetMaximumError(maximumError);
  return SurfaceOf(run.Output());
}
}

TEST(Sameness, TwoRunsGiveTheSameBytes)
{
  FilterRun one(Bumps(4));
  FilterRun two(Bumps(4));
  ExpectSame(OutcomeOf(one), OutcomeOf(two));
}

TEST(Sameness, RunningAgainGivesTheSameBytes)
{
  FilterRun run(Bumps(4));
  const Outcome first = OutcomeOf(run);
  run->Modified();
  ExpectSame(first, OutcomeOf(run));
  EXPECT_EQ(run.Executions, 2);
}

TEST(Sameness, TheNumberOfThreadsChangesNoByte)
{
  const Outcome one = WithThreads(1);
  for (const int threads : { 0, 2, 4, 16 })
  {
    ExpectSame(one, WithThreads(threads));
  }
}

TEST(Sameness, APowerOfTwoTimesTheSizeGivesTheSameTrianglesAndExactlyScaledPoints)
{
  const Surface once = ResultOf(Pieces(), 0.0);
  for (const int power : { -20, -3, 1, 10 })
  {
    const double factor = std::ldexp(1.0, power);
    EXPECT_TRUE(SameBytes(ResultOf(Scaled(Pieces(), factor), 0.0), Scaled(once, factor)))
      << "2^" << power;
  }
}

TEST(Sameness, TheErrorGrowsWithTheSize)
{
  const Surface once = ResultOf(Pieces(), 0.1);
  for (const int power : { -10, 1, 10 })
  {
    const double factor = std::ldexp(1.0, power);
    EXPECT_TRUE(SameBytes(ResultOf(Scaled(Pieces(), factor), 0.1 * factor), Scaled(once, factor)))
      << "2^" << power;
  }
}

TEST(Sameness, MovingTheSurfaceExactlyGivesTheSameTrianglesAndMovedPoints)
{
  const Surface input = OnAGrid(Pieces());
  const Vector3 offset(4096.0, -65536.0, 1.5);
  for (const double maximumError : { 0.0, 0.1 })
  {
    const Surface here = ResultOf(input, maximumError);
    const Surface there = ResultOf(Moved(input, offset), maximumError);
    EXPECT_EQ(here.Triangles, there.Triangles);
    ASSERT_EQ(here.Points.size(), there.Points.size());
    for (std::size_t p = 0; p < here.Points.size(); ++p)
    {
      EXPECT_LT((here.Points[p] + offset - there.Points[p]).norm(), 1e-10) << "point " << p;
    }
  }
}

TEST(Sameness, FloatAndDoubleOfTheSameCoordinatesGiveTheSameTriangles)
{
  FilterRun single(PolyData(Pieces(), VTK_FLOAT));
  FilterRun both(PolyData(SurfaceOf(PolyData(Pieces(), VTK_FLOAT)), VTK_DOUBLE));
  EXPECT_EQ(SurfaceOf(single.Output()).Triangles, SurfaceOf(both.Output()).Triangles);
}
