// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// What the input's arrays say reaches the output at the right position, against VTK's own locators.
#include "FilterRun.h"
#include "VtkSurfaces.h"

#include "vtkBitArray.h"
#include "vtkCellArray.h"
#include "vtkCellCenters.h"
#include "vtkCellData.h"
#include "vtkCellLocator.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPointLocator.h"
#include "vtkPolyDataNormals.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <set>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
double Plane(const double* p)
{
  return 2.0 * p[0] - p[1] + 3.0 * p[2] + 5.0;
}

/// One value for each point.
template <typename Array, typename Value>
vtkSmartPointer<Array> PointArray(
  vtkPolyData* polyData, const char* name, const std::function<Value(vtkIdType)>& value)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  for (vtkIdType i = 0; i < polyData->GetNumberOfPoints(); ++i)
  {
    array->InsertNextValue(value(i));
  }
  polyData->GetPointData()->AddArray(array);
  return array;
}

/// The values 0, 1, 2 ...: which point or cell a tuple comes from.
vtkSmartPointer<vtkIntArray> Numbers(const char* name, vtkIdType count)
{
  auto array = vtkSmartPointer<vtkIntArray>::New();
  array->SetName(name);
  for (vtkIdType i = 0; i < count; ++i)
  {
    array->InsertNextValue(static_cast<int>(i));
  }
  return array;
}

vtkNew<vtkCellLocator>& Build(vtkNew<vtkCellLocator>& locator, vtkPolyData* surface)
{
  locator->SetDataSet(surface);
  locator->BuildLocator();
  return locator;
}

/// Square of the distance to the nearest cell, and the cell.
double NearestCell(vtkCellLocator* locator, const double* point, vtkIdType& cell, double* closest)
{
  double distance2 = 0.0;
  int subId = 0;
  locator->FindClosestPoint(point, closest, cell, subId, distance2);
  return distance2;
}
}

TEST(Data, FloatingValuesAreThoseOfTheNearestPositionOnTheInput)
{
  const vtkSmartPointer<vtkPolyData> input = Bumps(4);
  PointArray<vtkDoubleArray, double>(
    input, "Plane", [&](vtkIdType i) { return Plane(input->GetPoint(i)); });
  FilterRun run(input);
  vtkPolyData* output = run.Output();
  vtkNew<vtkCellLocator> locator;
  Build(locator, input);
  const std::vector<double> values = Values(output, "Plane");
  ASSERT_EQ(values.size(), static_cast<std::size_t>(output->GetNumberOfPoints()));
  int moved = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double closest[3];
    vtkIdType cell = -1;
    moved += NearestCell(locator, output->GetPoint(i), cell, closest) > 0.0 ? 1 : 0;
    EXPECT_NEAR(values[i], Plane(closest), 1e-6) << "point " << i;
  }
  EXPECT_GT(moved, output->GetNumberOfPoints() / 2);
}

TEST(Data, LabelsIdsTextAndBitsAreThoseOfTheNearestInputPoint)
{
  const vtkSmartPointer<vtkPolyData> input = Bumps(3);
  const vtkIdType count = input->GetNumberOfPoints();
  input->GetPointData()->AddArray(Numbers("Label", count));
  PointArray<vtkStringArray, std::string>(
    input, "Text", [](vtkIdType i) { return "p" + std::to_string(i); });
  PointArray<vtkBitArray, int>(input, "Bit", [](vtkIdType i) { return static_cast<int>(i % 2); });
  input->GetPointData()->SetGlobalIds(
    PointArray<vtkIdTypeArray, vtkIdType>(input, "Global", [](vtkIdType i) { return 1000 + i; }));
  FilterRun run(input);
  vtkPointData* data = run.Output()->GetPointData();
  vtkNew<vtkPointLocator> locator;
  locator->SetDataSet(input);
  locator->BuildLocator();
  auto* texts = vtkStringArray::SafeDownCast(data->GetAbstractArray("Text"));
  auto* bits = vtkBitArray::SafeDownCast(data->GetAbstractArray("Bit"));
  ASSERT_NE(texts, nullptr);
  ASSERT_NE(bits, nullptr);
  ASSERT_NE(data->GetGlobalIds(), nullptr);
  for (vtkIdType i = 0; i < run.Output()->GetNumberOfPoints(); ++i)
  {
    const vtkIdType nearest = locator->FindClosestPoint(run.Output()->GetPoint(i));
    EXPECT_EQ(data->GetArray("Label")->GetComponent(i, 0), nearest);
    EXPECT_EQ(texts->GetValue(i), "p" + std::to_string(nearest));
    EXPECT_EQ(bits->GetValue(i), nearest % 2);
    EXPECT_EQ(data->GetGlobalIds()->GetComponent(i, 0), 1000 + nearest);
  }
}

TEST(Data, NormalsHaveTheirLengthAndDirection)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(Bumps(4));
  normals->SplittingOff();
  FilterRun run(nullptr);
  run->SetInputConnection(normals->GetOutputPort());
  vtkPolyData* output = run.Output();
  vtkDataArray* array = output->GetPointData()->GetNormals();
  ASSERT_NE(array, nullptr);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const Vector3 normal(array->GetTuple(i));
    EXPECT_NEAR(normal.norm(), 1.0, 1e-6) << "point " << i;
    EXPECT_GT(normal.dot(Vector3(output->GetPoint(i)).normalized()), 0.5) << "point " << i;
  }
}

TEST(Data, NamesComponentsInformationAndAttributesAreKept)
{
  const vtkSmartPointer<vtkPolyData> input = Bumps(2);
  vtkNew<vtkFloatArray> stress;
  stress->SetName("Stress");
  stress->SetNumberOfComponents(9);
  stress->SetNumberOfTuples(input->GetNumberOfPoints());
  stress->FillComponent(4, 2.5);
  stress->SetComponentName(4, "YY");
  stress->GetInformation()->Set(vtkAbstractArray::GUI_HIDE(), 1);
  input->GetPointData()->SetTensors(stress);
  input->GetPointData()->SetScalars(Numbers("Density", input->GetNumberOfPoints()));
  FilterRun run(input);
  vtkPointData* data = run.Output()->GetPointData();
  ASSERT_NE(data->GetTensors(), nullptr);
  EXPECT_STREQ(data->GetTensors()->GetName(), "Stress");
  EXPECT_STREQ(data->GetTensors()->GetComponentName(4), "YY");
  EXPECT_TRUE(data->GetTensors()->GetInformation()->Has(vtkAbstractArray::GUI_HIDE()));
  EXPECT_EQ(data->GetTensors()->GetDataType(), VTK_FLOAT);
  EXPECT_NEAR(data->GetTensors()->GetComponent(7, 4), 2.5, 1e-6);
  ASSERT_NE(data->GetScalars(), nullptr);
  EXPECT_STREQ(data->GetScalars()->GetName(), "Density");
}

TEST(Data, PointsThatStayKeepTheirValueEvenIfItIsNoNumber)
{
  const vtkSmartPointer<vtkPolyData> input = Bumps(2);
  PointArray<vtkDoubleArray, double>(
    input, "Hole", [](vtkIdType) { return std::numeric_limits<double>::quiet_NaN(); });
  PointArray<vtkDoubleArray, double>(
    input, "Third", [](vtkIdType i) { return static_cast<double>(i) / 3.0; });
  FilterRun run(input);
  run->SetTargetReduction(0.0);
  vtkPolyData* output = run.Output();
  vtkNew<vtkPointLocator> locator;
  locator->SetDataSet(input);
  locator->BuildLocator();
  int same = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const vtkIdType nearest = locator->FindClosestPoint(output->GetPoint(i));
    const bool stayed = Vector3(input->GetPoint(nearest)) == Vector3(output->GetPoint(i));
    EXPECT_TRUE(!stayed || Values(output, "Third")[i] == static_cast<double>(nearest) / 3.0);
    EXPECT_TRUE(std::isnan(Values(output, "Hole")[i]));
    same += stayed ? 1 : 0;
  }
  EXPECT_GT(same, 0);
}

TEST(Data, CellArraysAreThoseOfTheCellNearestToTheCentroid)
{
  const vtkSmartPointer<vtkPolyData> input = Bumps(3);
  input->GetCellData()->AddArray(Numbers("Cell", input->GetNumberOfCells()));
  FilterRun run(input);
  vtkPolyData* output = run.Output();
  vtkNew<vtkCellLocator> locator;
  Build(locator, input);
  vtkNew<vtkCellCenters> centers;
  centers->SetInputData(output);
  centers->Update();
  vtkDataArray* cells = output->GetCellData()->GetArray("Cell");
  ASSERT_NE(cells, nullptr);
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    const Vector3 center(centers->GetOutput()->GetPoint(i));
    double closest[3];
    vtkIdType nearest = -1;
    const double distance2 = NearestCell(locator, center.data(), nearest, closest);
    const auto cell = static_cast<vtkIdType>(cells->GetComponent(i, 0));
    double corner[3];
    double parameter[3];
    double weights[3];
    double ours2 = 0.0;
    int subId = 0;
    input->GetCell(cell)->EvaluatePosition(center.data(), corner, subId, parameter, ours2, weights);
    EXPECT_NEAR(std::sqrt(ours2), std::sqrt(distance2), 1e-9) << "triangle " << i;
  }
}

TEST(Data, VerticesAndLinesKeepTheirOwn)
{
  const vtkSmartPointer<vtkPolyData> input = Bumps(2);
  const vtkIdType first = input->GetNumberOfPoints();
  for (const double x : { 20.5, 30.25, 31.25 })
  {
    input->GetPoints()->InsertNextPoint(x, 0.0, 0.0);
  }
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ first });
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ first + 1, first + 2 });
  input->SetVerts(vertices);
  input->SetLines(lines);
  input->GetPointData()->AddArray(Numbers("Point", input->GetNumberOfPoints()));
  input->GetCellData()->AddArray(Numbers("Cell", input->GetNumberOfCells()));
  FilterRun run(input);
  const std::vector<double> points = Values(run.Output(), "Point");
  ASSERT_GE(points.size(), 3U);
  EXPECT_EQ(std::vector<double>(points.end() - 3, points.end()),
    (std::vector<double>{ first + 0.0, first + 1.0, first + 2.0 }));
  vtkDataArray* cells = run.Output()->GetCellData()->GetArray("Cell");
  ASSERT_EQ(cells->GetNumberOfTuples(), run.Output()->GetNumberOfCells());
  EXPECT_EQ(cells->GetComponent(0, 0), 0);
  EXPECT_EQ(cells->GetComponent(1, 0), 1);
  EXPECT_GE(cells->GetComponent(2, 0), 2);
}

TEST(Data, MapsLeadFromTheInputToTheOutputAndBack)
{
  const vtkSmartPointer<vtkPolyData> input = Bumps(3);
  FilterRun run(input);
  run->SetTargetReduction(0.3); // some points do not move
  run->MakeMapsOn();
  vtkPolyData* output = run.Output();
  const std::vector<double> there = Values(run.InputCopy(), "ResultPointIds");
  const std::vector<double> back = Values(output, "OriginalPointIds");
  const std::vector<double> counts = Values(output, "InputPointCount");
  ASSERT_EQ(there.size(), static_cast<std::size_t>(input->GetNumberOfPoints()));
  ASSERT_EQ(back.size(), static_cast<std::size_t>(output->GetNumberOfPoints()));
  std::vector<double> met(counts.size(), 0.0);
  for (const double id : there)
  {
    ++met.at(static_cast<std::size_t>(id));
  }
  EXPECT_EQ(met, counts);
  int same = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const auto original = static_cast<vtkIdType>(back[i]);
    if (Vector3(input->GetPoint(original)) == Vector3(output->GetPoint(i)))
    {
      EXPECT_EQ(there[original], i);
      ++same;
    }
  }
  EXPECT_GT(same, 0);
  EXPECT_EQ(output->GetCellData()->GetArray("OriginalCellIds")->GetNumberOfTuples(),
    output->GetNumberOfCells());
  EXPECT_FALSE(input->GetPointData()->HasArray("ResultPointIds")) << "the input was changed";
}

TEST(Data, PointsThatNoTriangleUsesStandForNone)
{
  const vtkSmartPointer<vtkPolyData> input = Bumps(2);
  input->GetPoints()->InsertNextPoint(50.0, 0.0, 0.0);
  FilterRun run(input);
  run->MakeMapsOn();
  EXPECT_EQ(Values(run.InputCopy(), "ResultPointIds").back(), -1.0);
}

TEST(Data, NothingIsPassedOrLookedUpIfSwitchedOff)
{
  const vtkSmartPointer<vtkPolyData> input = Bumps(2);
  input->GetPointData()->AddArray(Numbers("Label", input->GetNumberOfPoints()));
  FilterRun run(input);
  run->PassArraysOff();
  EXPECT_FALSE(run.Output()->GetPointData()->HasArray("Label"));
  EXPECT_FALSE(run.Output()->GetPointData()->HasArray("Distance"));
}

TEST(Data, TheResultOfARunCanBeDecimatedAgain)
{
  FilterRun first(Bumps(3));
  first->MeasureDistancesOn();
  FilterRun second(first.Output());
  second->MeasureDistancesOn();
  vtkPolyData* output = second.Output();
  EXPECT_EQ(output->GetPointData()->GetNumberOfArrays(), 3);
  EXPECT_EQ(Sum(Values(output, "InputPointCount")), first.Output()->GetNumberOfPoints());
}

TEST(Data, NormalsAreRecomputedOnRequest)
{
  const vtkSmartPointer<vtkPolyData> input = Bumps(3);
  vtkNew<vtkDoubleArray> wrong;
  wrong->SetName("Normals");
  wrong->SetNumberOfComponents(3);
  wrong->SetNumberOfTuples(input->GetNumberOfPoints());
  wrong->Fill(-1.0);
  input->GetPointData()->SetNormals(wrong);
  FilterRun run(input);
  run->RecomputeNormalsOn();
  vtkPolyData* output = run.Output();
  vtkDataArray* normals = output->GetPointData()->GetNormals();
  ASSERT_NE(normals, nullptr);
  ASSERT_EQ(normals->GetNumberOfTuples(), output->GetNumberOfPoints());
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    EXPECT_GT(Vector3(normals->GetTuple(i)).dot(Vector3(output->GetPoint(i))), 0.0);
  }
}
