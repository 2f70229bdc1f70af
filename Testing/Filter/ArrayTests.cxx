// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BruteForce.h"
#include "FilterRun.h"
#include "Shapes.h"
#include "VtkSurfaces.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
constexpr double Tolerance = 1e-5; // mm

void ExpectNear(const std::vector<double>& values, const std::vector<double>& expected)
{
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    ASSERT_NEAR(values[i], expected[i], Tolerance) << "point " << i;
  }
}

/// Name and unit, one value for each point.
void ExpectArray(vtkPolyData* polyData, const std::string& name, const std::string& unit)
{
  vtkDataArray* array = polyData->GetPointData()->GetArray(name.c_str());
  ASSERT_NE(array, nullptr) << name;
  EXPECT_EQ(array->GetNumberOfComponents(), 1) << name;
  EXPECT_EQ(array->GetNumberOfTuples(), polyData->GetNumberOfPoints()) << name;
  ASSERT_NE(array->GetComponentName(0), nullptr) << name;
  EXPECT_EQ(array->GetComponentName(0), unit) << name;
}
}

TEST(Arrays, HaveTheirNamesUnitsAndOneValueForEachPoint)
{
  FilterRun run(Bumps(3));
  run->MeasureDistancesOn();
  vtkPolyData* output = run.Output();
  ExpectArray(output, "Distance", "mm");
  ExpectArray(output, "RunningError", "mm");
  ExpectArray(output, "InputPointCount", "points");
  EXPECT_EQ(output->GetPointData()->GetNumberOfArrays(), 3);
  EXPECT_NE(
    vtkIntArray::SafeDownCast(output->GetPointData()->GetArray("InputPointCount")), nullptr);
}

TEST(Arrays, HaveTheRequestedNames)
{
  FilterRun run(Bumps(3));
  run->SetDistanceArrayName("d");
  run->SetRunningErrorArrayName("e");
  run->SetPointCountArrayName("n");
  run->SetInputDistanceArrayName("back");
  run->MeasureDistancesOn();
  run->MeasureInputDistancesOn();
  vtkPolyData* output = run.Output();
  ExpectArray(output, "d", "mm");
  ExpectArray(output, "e", "mm");
  ExpectArray(output, "n", "points");
  EXPECT_EQ(output->GetPointData()->GetNumberOfArrays(), 3);
  ExpectArray(run.InputCopy(), "back", "mm");
}

TEST(Arrays, OfOneNameAreAWarning)
{
  FilterRun run(Bumps(3));
  run->SetDistanceArrayName("d");
  run.Output();
  EXPECT_TRUE(run.SaidNothing());
  run->SetErrorBoundArrayName("d");
  run.Output();
  EXPECT_EQ(run.Said("two arrays that the run makes have the same name"), 1);
}

TEST(Arrays, ErrorBoundsComeWithTheProofUnderTheirNames)
{
  FilterRun run(Bumps(3));
  run->SetMaximumError(0.2);
  run->MeasureInputDistancesOn();
  ExpectArray(run.Output(), "ErrorBound", "mm");
  ExpectArray(run.InputCopy(), "ErrorBoundToResult", "mm");
  EXPECT_EQ(Largest(Values(run.Output(), "ErrorBound")), run.Value("proof.output_to_input.upper"));
  EXPECT_LE(run.Value("proof.upper"), 0.2);
  run->SetErrorBoundArrayName("b");
  run->SetInputErrorBoundArrayName("back");
  ExpectArray(run.Output(), "b", "mm");
  ExpectArray(run.InputCopy(), "back", "mm");
  run->ProveResultOff();
  EXPECT_FALSE(run.Output()->GetPointData()->HasArray("b"));
  EXPECT_FALSE(run.InputCopy()->GetPointData()->HasArray("back"));
}

TEST(Arrays, DistanceIsThatOfTheLocatorToTheInput)
{
  for (const vtkSmartPointer<vtkPolyData>& input : { Bumps(3), PolyData(HeightField(24, 1.0, 5)) })
  {
    FilterRun run(input);
    run->MeasureDistancesOn();
    ExpectNear(Values(run.Output(), "Distance"), LocatorDistances(run.Output(), input));
    EXPECT_GT(Largest(Values(run.Output(), "Distance")), 0.0);
  }
}

TEST(Arrays, DistanceIsThatOfTheRoundedPoints)
{
  const Surface input = Moved(Scaled(Icosphere(3, 1.0), 0.01), { 100, 0, 0 });
  FilterRun run(PolyData(input));
  run->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  run->MeasureDistancesOn();
  const std::vector<double> distances = Values(run.Output(), "Distance");
  const Surface output = SurfaceOf(run.Output());
  ASSERT_EQ(distances.size(), output.Points.size());
  for (std::size_t i = 0; i < distances.size(); ++i)
  {
    ASSERT_NEAR(distances[i], BruteNearest(input, output.Points[i]).Distance, 1e-9)
      << "point " << i;
  }
}

TEST(Arrays, RunningErrorIsNeverBelowTheDistanceAndItsMaximumIsReported)
{
  FilterRun run(Bumps(3));
  run->SetModeToThesis();
  const std::vector<double> running = Values(run.Output(), "RunningError");
  ASSERT_FALSE(running.empty());
  const std::vector<double> distance = Values(run.Output(), "Distance");
  for (std::size_t i = 0; i < running.size(); ++i)
  {
    EXPECT_GE(running[i] + 1e-12, distance[i]) << "point " << i;
  }
  EXPECT_LE(Largest(running), run.Value("running_error"));
}

TEST(Arrays, PointCountsAddUpToTheUsedPointsOfTheInput)
{
  for (const double reduction : { 0.0, 0.5, 0.95 })
  {
    FilterRun run(Bumps(3));
    run->SetTargetReduction(reduction);
    EXPECT_EQ(Sum(Values(run.Output(), "InputPointCount")), 642);
  }
}

TEST(Arrays, PointCountsIncludeMergedPointsButNoUnusedOnes)
{
  Surface surface = Unwelded(Icosphere(2, 10.0));
  surface.Points.emplace_back(50.0, 0.0, 0.0);
  FilterRun run(PolyData(surface));
  EXPECT_EQ(Sum(Values(run.Output(), "InputPointCount")), 960);
  EXPECT_EQ(run.Value("input.unused_points"), 1);
}

TEST(Arrays, InputDistanceIsThatOfTheLocatorToTheResult)
{
  const vtkSmartPointer<vtkPolyData> input = Bumps(3);
  FilterRun run(input);
  run->MeasureInputDistancesOn();
  const std::vector<double> distances = Values(run.InputCopy(), "DistanceToResult");
  ExpectNear(distances, LocatorDistances(input, run.Output()));
  EXPECT_GT(Largest(distances), 0.0);
}

TEST(Arrays, InputDistanceIsMeasuredWithoutTheReportsDistances)
{
  const vtkSmartPointer<vtkPolyData> input = Bumps(3);
  FilterRun run(input);
  run->MeasureDistancesOff();
  run->MeasureInputDistancesOn();
  ExpectNear(Values(run.InputCopy(), "DistanceToResult"), LocatorDistances(input, run.Output()));
}

TEST(Arrays, TheSecondPortIsTheInputWithItsOwnArrays)
{
  const vtkSmartPointer<vtkPolyData> input = Bumps(2);
  vtkNew<vtkFloatArray> density;
  density->SetName("Density");
  density->SetNumberOfTuples(input->GetNumberOfPoints());
  density->Fill(226);
  input->GetPointData()->AddArray(density);
  FilterRun run(input);
  run->MeasureInputDistancesOn();
  vtkPolyData* copy = run.InputCopy();
  EXPECT_EQ(copy->GetPoints(), input->GetPoints());
  EXPECT_EQ(copy->GetNumberOfCells(), input->GetNumberOfCells());
  EXPECT_EQ(copy->GetPointData()->GetArray("Density"), density);
  EXPECT_FALSE(input->GetPointData()->HasArray("DistanceToResult"))
    << "the input itself was changed";
}

TEST(Arrays, OfTheFieldDataPassThrough)
{
  const vtkSmartPointer<vtkPolyData> input = Bumps(2);
  vtkNew<vtkDoubleArray> scale;
  scale->SetName("Scale");
  scale->InsertNextValue(2.5);
  input->GetFieldData()->AddArray(scale);
  FilterRun run(input);
  EXPECT_EQ(run.Output()->GetFieldData()->GetArray("Scale"), scale);
  EXPECT_TRUE(run.SaidNothing()) << run.AllMessages();
}

// vtkMarchingCubes makes such arrays.
TEST(Arrays, WithoutANamePassWithoutOne)
{
  const vtkSmartPointer<vtkPolyData> surface = Bumps(3);
  const vtkNew<vtkDoubleArray> unnamed;
  unnamed->SetNumberOfTuples(surface->GetNumberOfPoints());
  unnamed->Fill(7.0);
  surface->GetPointData()->AddArray(unnamed);
  const vtkNew<vtkIntArray> ofCells;
  ofCells->SetNumberOfTuples(surface->GetNumberOfCells());
  ofCells->Fill(5);
  surface->GetCellData()->AddArray(ofCells);
  FilterRun run(surface);
  run->SetMaximumError(0.2);
  run->MeasureInputDistancesOn();
  vtkPolyData* output = run.Output();
  EXPECT_TRUE(run.SaidNothing()) << run.AllMessages();
  vtkDataArray* passed = output->GetPointData()->GetArray(0);
  EXPECT_EQ(passed->GetName(), nullptr);
  EXPECT_EQ(passed->GetNumberOfTuples(), output->GetNumberOfPoints());
  EXPECT_EQ(passed->GetComponent(0, 0), 7.0);
  EXPECT_EQ(output->GetCellData()->GetArray(0)->GetComponent(0, 0), 5.0);
}
