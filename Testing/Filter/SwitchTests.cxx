// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterRun.h"
#include "Shapes.h"
#include "VtkSurfaces.h"

#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// A flat plate of 320 large triangles with 98 points inside its two sides, and a fine bumpy sphere
/// far beside it.
Surface PlateAndSphere()
{
  const Surface plate = Scaled(FlatPlate(8), 4.0);
  return Together(plate, Moved(BumpySphere(3, 2.0, 0.1, 3), { 100.0, 0.0, 0.0 }));
}

/// Number of triangles left of the plate of PlateAndSphere().
int TrianglesOfPlate(double tolerance)
{
  FilterRun run(PolyData(PlateAndSphere()));
  run->SetModeToThesis();
  run->SetNormalTolerance(tolerance);
  run->SetTargetReduction(0.2);
  const Surface result = SurfaceOf(run.Output());
  int count = 0;
  for (const Triangle& corners : result.Triangles)
  {
    count += result.Points[static_cast<std::size_t>(corners[0])][0] < 50.0 ? 1 : 0;
  }
  return count;
}

#ifdef __linux__
std::ptrdiff_t NumberOfThreadsNow()
{
  const std::filesystem::directory_iterator tasks("/proc/self/task");
  return std::distance(begin(tasks), end(tasks));
}
#endif
}

TEST(NormalTolerance, ASmallerOneMakesFlatAreasDearer)
{
  const int atOne = TrianglesOfPlate(1.0);
  const int atHalf = TrianglesOfPlate(0.5);
  EXPECT_EQ(atOne, 320 - 2 * 98) << "at 1 a flat edge costs nothing";
  EXPECT_GT(atHalf, 300);
}

TEST(MergePoints, OnMakesOneSurfaceOfTrianglesWithPointsOfTheirOwn)
{
  FilterRun run(PolyData(Unwelded(Icosphere(2, 10.0))));
  run->SetTargetReduction(0.5);
  EXPECT_EQ(run.Triangles(), 160);
  EXPECT_EQ(run.Value("input.components"), 1);
  EXPECT_EQ(run.Value("input.merged_points"), 960 - 162);
}

TEST(MergePoints, OffKeepsEachOfThemAsAFragment)
{
  FilterRun run(PolyData(Unwelded(Icosphere(2, 10.0))));
  run->MergePointsOff();
  run->SetTargetReduction(0.5);
  EXPECT_EQ(run.Triangles(), 320);
  EXPECT_EQ(run.Value("output.components"), 320);
  EXPECT_EQ(run.Value("input.merged_points"), 0);
}

TEST(MeasureDistances, OnPutsTheDistancesIntoTheReport)
{
  FilterRun run(Bumps(2));
  run->MeasureDistancesOn();
  EXPECT_GT(run.Value("distance.output_to_input.max"), 0.0);
  EXPECT_GT(run.Value("distance.input_to_output.max"), 0.0);
}

TEST(MaximumError, IsNotProvedInThesisMode)
{
  FilterRun run(Bumps(3));
  run->SetModeToThesis();
  run->SetMaximumError(0.5);
  run.Output();
  EXPECT_EQ(run->GetProofStatusAsString(), "no_proof");
  EXPECT_EQ(run.Said("nothing is proved in Thesis mode: its largest error only limits the distance "
                     "of new vertices"),
    1)
    << run.AllMessages();
}

TEST(MeasureDistances, OffInThesisLeavesThemOutButNotTheArrays)
{
  FilterRun run(Bumps(2));
  run->SetModeToThesis();
  run->MeasureDistancesOff();
  EXPECT_TRUE(std::isnan(run.Value("distance.output_to_input.max")));
  EXPECT_TRUE(std::isnan(run.Value("distance.input_to_output.max")));
  EXPECT_FALSE(Values(run.Output(), "Distance").empty());
}

TEST(MeasureDistances, OffLooksNothingUp)
{
  FilterRun run(Bumps(3));
  run->MeasureDistancesOff();
  EXPECT_EQ(run.Output()->GetPointData()->GetArray("Distance"), nullptr);
  EXPECT_EQ(run.Output()->GetPointData()->GetArray("RunningError"), nullptr);
  EXPECT_NE(run.Output()->GetPointData()->GetArray("InputPointCount"), nullptr);
  EXPECT_TRUE(std::isnan(run.Value("running_error")));
}

TEST(MeasureDistances, DoesNotChangeTheSurface)
{
  FilterRun with(Bumps(3));
  FilterRun without(Bumps(3));
  with->MeasureDistancesOn();
  without->MeasureDistancesOff();
  const Surface expected = SurfaceOf(without.Output());
  EXPECT_EQ(SurfaceOf(with.Output()).Points, expected.Points);
  EXPECT_EQ(SurfaceOf(with.Output()).Triangles, expected.Triangles);
}

TEST(MeasureInputDistances, PutsTheArrayOnTheSecondPortOnlyWhenOn)
{
  FilterRun run(Bumps(2));
  EXPECT_TRUE(Values(run.InputCopy(), "DistanceToResult").empty());
  run->MeasureInputDistancesOn();
  EXPECT_EQ(Values(run.InputCopy(), "DistanceToResult").size(), 162U);
  EXPECT_FALSE(run.Output()->GetPointData()->HasArray("DistanceToResult"));
  run->MeasureInputDistancesOff();
  EXPECT_TRUE(Values(run.InputCopy(), "DistanceToResult").empty());
}

#ifdef __linux__
TEST(NumberOfThreads, OfOneStartsNoOther)
{
  const std::ptrdiff_t before = NumberOfThreadsNow();
  FilterRun run(Bumps(4));
  run->SetNumberOfThreads(1);
  run->MeasureDistancesOn();
  std::ptrdiff_t most = 0;
  run.OnEachProgress = [&](double) { most = std::max(most, NumberOfThreadsNow()); };
  run.Output();
  EXPECT_EQ(most, before);
}
#endif
