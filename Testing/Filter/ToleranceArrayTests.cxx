// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// vtkBoneDecimate keeps the tolerances of an array, and leaves bit for bit what has none.
#include "FilterRun.h"
#include "Options/Modes.h"
#include "VtkSurfaces.h"

#include "vtkBoneSurfaceDistance.h"
#include "vtkBoneTolerance.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphere.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>

using namespace bonedecimate::testsupport;

namespace
{
using Corners = std::array<double, 9>;

Corners CornersOf(vtkPolyData* surface, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  surface->GetCellPoints(cell, ids);
  Corners corners;
  for (vtkIdType i = 0; i < 3; ++i)
  {
    surface->GetPoint(ids->GetId(i), corners.data() + 3 * i);
  }
  return corners;
}

/// Triangles of the input at a point of tolerance 0 that the output has not.
int MissingConstrained(vtkPolyData* input, vtkPolyData* output)
{
  std::set<Corners> there;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    there.insert(CornersOf(output, cell));
  }
  const std::vector<double> tolerances = Values(input, "Tolerance");
  int missing = 0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    input->GetCellPoints(cell, ids);
    const bool isConstrained = std::any_of(ids->begin(), ids->end(),
      [&](vtkIdType v) { return tolerances[static_cast<std::size_t>(v)] == 0.0; });
    missing += isConstrained && there.count(CornersOf(input, cell)) == 0 ? 1 : 0;
  }
  return missing;
}

template <typename Array>
void AddPointArray(vtkPolyData* surface, const char* name, double above, double below)
{
  vtkNew<Array> array;
  array->SetName(name);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    array->InsertNextTuple1(surface->GetPoint(i)[2] > 0.0 ? above : below);
  }
  surface->GetPointData()->AddArray(array);
}
}

TEST(ToleranceArray, AsABrushLeavesAllOthersBitForBit)
{
  vtkNew<vtkBoneTolerance> brush;
  brush->SetInputData(Bumps(4));
  brush->SetChoiceToImplicitFunction();
  vtkNew<vtkSphere> ball;
  ball->SetCenter(0.0, 0.0, 10.0);
  ball->SetRadius(8.0);
  brush->SetImplicitFunction(ball);
  brush->InvertedOn();
  brush->Update();
  vtkPolyData* input = brush->GetOutput();
  for (const bonedecimate::ModeInfo& info : bonedecimate::ModeTable())
  {
    const int mode = static_cast<int>(info.Mode);
    FilterRun run(input);
    run->SetMode(mode);
    run->SetTargetReduction(0.15);
    run->SetToleranceArrayName("Tolerance");
    EXPECT_EQ(MissingConstrained(input, run.Output()), 0) << mode;
    EXPECT_LT(run.Triangles(), 0.9 * input->GetNumberOfPolys()) << mode;
    EXPECT_GT(run.Value("input.constrained_points"), 1000.0);
    EXPECT_TRUE(run.SaidNothing()) << run.AllMessages();
  }
}

TEST(ToleranceArray, IsChosenByInputArrayToProcessUnlessThereIsAName)
{
  const vtkSmartPointer<vtkPolyData> input = Bumps(3);
  AddPointArray<vtkDoubleArray>(input, "Narrow", 0.01, 0.01);
  AddPointArray<vtkDoubleArray>(input, "Wide", 1.0, 1.0);
  const auto triangles = [&](const char* name, const char* processed)
  {
    FilterRun run(input);
    run->SetToleranceArrayName(name);
    if (processed)
    {
      run->SetInputArrayToProcess(
        vtkBoneDecimate::TOLERANCE_ARRAY, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, processed);
    }
    const double found = run.Triangles();
    EXPECT_TRUE(run.SaidNothing()) << run.AllMessages();
    return found;
  };
  const double narrow = triangles("Narrow", nullptr);
  const double wide = triangles("Wide", nullptr);
  EXPECT_LT(wide, narrow);
  EXPECT_EQ(triangles("", "Narrow"), narrow);
  EXPECT_EQ(triangles("Wide", "Narrow"), wide);
}

TEST(ToleranceArray, ToProcessThatTheInputLacksIsAnError)
{
  const auto input = Bumps(3);
  vtkNew<vtkDoubleArray> near;
  near->SetName("Near");
  near->SetNumberOfTuples(input->GetNumberOfPoints());
  near->Fill(0.1);
  input->GetPointData()->AddArray(near);
  FilterRun run(input);
  run->SetInputArrayToProcess(
    vtkBoneDecimate::TOLERANCE_ARRAY, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Nothing");
  EXPECT_EQ(run.Output()->GetNumberOfPoints(), 0);
  EXPECT_EQ(
    run.Said("the input has no point array 'Nothing' of one component (there are: 'Near')"), 1)
    << run.AllMessages();
}

TEST(ToleranceArray, OfAnyTypeIsKept)
{
  vtkSmartPointer<vtkPolyData> input = Bumps(4);
  AddPointArray<vtkFloatArray>(input, "float", 0.25, 1.0);
  AddPointArray<vtkIntArray>(input, "int", 1.0, -1.0);
  AddPointArray<vtkDoubleArray>(input, "double", 0.02, 0.5);
  for (const char* name : { "float", "int", "double" })
  {
    FilterRun run(input);
    run->SetToleranceArrayName(name);
    run->SetMaximumError(0.6);
    vtkNew<vtkBoneSurfaceDistance> comparison;
    comparison->SetInputData(0, input);
    comparison->SetInputData(1, run.Output());
    comparison->SetToleranceArrayName(name);
    comparison->SetTolerance(0.6);
    comparison->MeasureMeansOff();
    comparison->Update();
    EXPECT_EQ(comparison->GetStatus(), vtkBoneSurfaceDistance::PROVED) << name;
    EXPECT_LT(run.Triangles(), 0.8 * input->GetNumberOfPolys()) << name;
  }
}

TEST(ToleranceArray, ThatIsNotThereOrNoNumberIsAnError)
{
  vtkSmartPointer<vtkPolyData> input = Sphere(2);
  AddPointArray<vtkDoubleArray>(input, "bad", 1.0, std::numeric_limits<double>::quiet_NaN());
  for (const char* name : { "nothing", "bad" })
  {
    FilterRun run(input);
    run->SetToleranceArrayName(name);
    EXPECT_EQ(run.Triangles(), 0);
    EXPECT_EQ(run.Errors.size(), 1U) << name;
    EXPECT_EQ(run.Said(name == std::string("bad") ? "NaN" : "nothing"), 1);
  }
}

TEST(ToleranceArray, IsNotMissedOnAnEmptyInput)
{
  vtkNew<vtkPolyData> empty;
  FilterRun run(empty);
  run->SetToleranceArrayName("Tolerance");
  EXPECT_EQ(run.Triangles(), 0);
  EXPECT_TRUE(run.Errors.empty());
}
