// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VtkSurfaces.h"

#include "vtkBoneCap.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkMassProperties.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
constexpr int Sides = 24;

/// The wall of a prism along z, open at both ends. @param isInside Whether the bone is around it
/// and not in it.
void AddWall(Surface& surface, double radius, double bottom, double top, bool isInside)
{
  const auto first = static_cast<Index>(surface.Points.size());
  for (int i = 0; i < Sides; ++i)
  {
    const double angle = 2.0 * EIGEN_PI * i / Sides;
    for (const double z : { bottom, top })
    {
      surface.Points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
  }
  for (Index i = 0; i < Sides; ++i)
  {
    const Index a = first + 2 * i;
    const Index b = first + 2 * ((i + 1) % Sides);
    surface.Triangles.push_back({ a, isInside ? a + 1 : b, isInside ? b : a + 1 });
    surface.Triangles.push_back({ b, isInside ? a + 1 : b + 1, isInside ? b + 1 : a + 1 });
  }
}

double AreaOfPolygon(double radius)
{
  return 0.5 * Sides * radius * radius * std::sin(2.0 * EIGEN_PI / Sides);
}

/// Cortical bone between two walls.
Surface Shaft()
{
  Surface shaft;
  AddWall(shaft, 10.0, 0.0, 30.0, false);
  AddWall(shaft, 6.0, 0.0, 30.0, true);
  return shaft;
}

double VolumeOf(vtkPolyData* closed)
{
  vtkNew<vtkMassProperties> properties;
  properties->SetInputData(closed);
  return properties->GetVolume();
}
}

TEST(BoneCap, AShaftCutByTheScanBecomesARingWithItsCanal)
{
  const vtkSmartPointer<vtkPolyData> input = PolyData(Shaft());
  vtkNew<vtkBoneCap> filter;
  filter->SetInputData(input);
  filter->Update();
  const double ring = AreaOfPolygon(10.0) - AreaOfPolygon(6.0);
  EXPECT_EQ(filter->GetNumberOfCaps(), 2);
  EXPECT_EQ(filter->GetNumberOfClosedLoops(), 4);
  EXPECT_EQ(filter->GetNumberOfOpenLoops(), 0);
  EXPECT_NEAR(filter->GetCapArea(), 2.0 * ring, 1e-9);
  const VtkCounts counts = CountWithVtk(filter->GetOutput());
  EXPECT_EQ(counts.BoundaryEdges, 0);
  EXPECT_EQ(counts.NonManifoldEdges, 0);
  EXPECT_EQ(counts.Components, 1);
  EXPECT_NEAR(VolumeOf(filter->GetOutput()), 30.0 * ring, 1e-6);
}

TEST(BoneCap, KeepsPointsAndCellsAndMarksCaps)
{
  const vtkSmartPointer<vtkPolyData> input = PolyData(Shaft());
  vtkNew<vtkDoubleArray> labels;
  labels->SetName("Label");
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    labels->InsertNextValue(7.0);
  }
  input->GetCellData()->AddArray(labels);
  vtkNew<vtkBoneCap> filter;
  filter->SetInputData(input);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(output->GetPoints(), input->GetPoints());
  vtkDataArray* isCap = output->GetCellData()->GetArray("BoneCap");
  vtkDataArray* label = output->GetCellData()->GetArray("Label");
  ASSERT_EQ(isCap->GetNumberOfTuples(), output->GetNumberOfCells());
  ASSERT_EQ(label->GetNumberOfTuples(), output->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    EXPECT_EQ(isCap->GetTuple1(cell), cell < input->GetNumberOfCells() ? 0.0 : 1.0);
    EXPECT_EQ(label->GetTuple1(cell), 7.0);
  }
  EXPECT_EQ(
    input->GetNumberOfCells() + filter->GetNumberOfCapTriangles(), output->GetNumberOfCells());
}

TEST(BoneCap, LeavesHolesOpenThatAreNotAtTheEdgeOfTheScan)
{
  Surface sphere = SurfaceOf(Sphere(2));
  sphere.Triangles.pop_back();
  vtkNew<vtkBoneCap> filter;
  filter->SetInputData(PolyData(sphere));
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfCaps(), 0);
  EXPECT_EQ(filter->GetNumberOfOpenLoops(), 1);
  filter->SetLoops(vtkBoneCap::AllLoops);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfCapTriangles(), 1);
  EXPECT_EQ(CountWithVtk(filter->GetOutput()).BoundaryEdges, 0);
}

TEST(BoneCap, APlaneWithBoneOnBothSidesIsNoEdgeOfTheScan)
{
  Surface two;
  AddWall(two, 5.0, 0.0, 10.0, false);
  AddWall(two, 3.0, 12.0, 20.0, false);
  vtkNew<vtkBoneCap> filter;
  filter->SetInputData(PolyData(two));
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfCaps(), 2);
  EXPECT_EQ(filter->GetNumberOfOpenLoops(), 2);
  EXPECT_NEAR(filter->GetCapArea(), AreaOfPolygon(5.0) + AreaOfPolygon(3.0), 1e-9);
}

TEST(BoneCap, ALoopIsInAPlaneWithinTheTolerance)
{
  Surface shaft;
  AddWall(shaft, 10.0, 0.0, 30.0, false);
  shaft.Points[1][2] -= 0.1;
  vtkNew<vtkBoneCap> filter;
  filter->SetInputData(PolyData(shaft));
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfCaps(), 1);
  filter->SetPlaneTolerance(0.2);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfCaps(), 2);
  EXPECT_EQ(CountWithVtk(filter->GetOutput()).BoundaryEdges, 0);
}

TEST(BoneCap, PointsOnStraightEdgesOfACapAreItsCorners)
{
  Surface box; // open at z = 1, with a point in the middle of each upper edge
  box.Points = { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
    { 2, 0, 1 }, { 2, 1, 1 }, { 2, 2, 1 }, { 1, 2, 1 }, { 0, 2, 1 }, { 0, 1, 1 } };
  for (Index side = 0; side < 4; ++side)
  {
    const Index a = side;
    const Index b = (side + 1) % 4;
    const Index upper = 4 + 2 * side;
    const Index last = 4 + (2 * side + 2) % 8;
    box.Triangles.push_back({ a, upper + 1, upper });
    box.Triangles.push_back({ a, b, upper + 1 });
    box.Triangles.push_back({ b, last, upper + 1 });
  }
  box.Triangles.push_back({ 0, 2, 1 });
  box.Triangles.push_back({ 0, 3, 2 });
  vtkNew<vtkBoneCap> filter;
  filter->SetInputData(PolyData(box));
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfCaps(), 1);
  EXPECT_NEAR(filter->GetCapArea(), 4.0, 1e-12);
  EXPECT_EQ(CountWithVtk(filter->GetOutput()).BoundaryEdges, 0);
  EXPECT_NEAR(VolumeOf(filter->GetOutput()), 4.0, 1e-9);
}

TEST(BoneCap, NoEdgeOfACapIsAnEdgeOfTheSurface)
{
  // A square of two triangles, with either diagonal: that of its cap may be the same.
  std::set<vtkIdType> numbers;
  for (const bool isTurned : { false, true })
  {
    Surface square;
    square.Points = { { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
    square.Triangles.push_back(isTurned ? Triangle{ 0, 3, 1 } : Triangle{ 0, 2, 1 });
    square.Triangles.push_back(isTurned ? Triangle{ 1, 3, 2 } : Triangle{ 0, 3, 2 });
    vtkNew<vtkBoneCap> filter;
    filter->SetInputData(PolyData(square));
    filter->Update();
    const VtkCounts counts = CountWithVtk(filter->GetOutput());
    EXPECT_EQ(counts.NonManifoldEdges, 0);
    EXPECT_EQ(counts.BoundaryEdges, 0);
    EXPECT_NEAR(filter->GetCapArea(), 1.0, 1e-12);
    EXPECT_EQ(WhatIsWrongWith(filter->GetOutput()), "");
    numbers.insert(filter->GetNumberOfCapTriangles());
  }
  EXPECT_EQ(numbers, (std::set<vtkIdType>{ 2, 4 }));
}

TEST(BoneCap, AClosedSurfaceStaysAsItIs)
{
  const vtkSmartPointer<vtkPolyData> input = Sphere(2);
  vtkNew<vtkBoneCap> filter;
  filter->SetInputData(input);
  filter->SetLoops(vtkBoneCap::AllLoops);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), input->GetNumberOfCells());
  EXPECT_EQ(filter->GetNumberOfCaps() + filter->GetNumberOfOpenLoops(), 0);
}

TEST(BoneCap, RejectsValuesOutsideOfTheirRange)
{
  vtkNew<vtkBoneCap> filter;
  filter->SetInputData(Sphere(1));
  for (const double tolerance : { -1.0, std::nan("") })
  {
    vtkObject::GlobalWarningDisplayOff();
    filter->SetPlaneTolerance(tolerance);
    vtkObject::GlobalWarningDisplayOn();
    EXPECT_NE(filter->GetRejectedValue("PlaneTolerance"), "");
    EXPECT_EQ(filter->GetPlaneTolerance(), 0.01);
  }
  filter->SetPlaneTolerance(0.5);
  EXPECT_EQ(filter->GetRejectedValue("PlaneTolerance"), "");
}

TEST(BoneCap, HasNoFiguresAfterAnUpdateThatFailed)
{
  vtkNew<vtkBoneCap> filter;
  filter->SetInputData(PolyData(Shaft()));
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfCaps(), 2);
  vtkObject::GlobalWarningDisplayOff();
  filter->SetPlaneTolerance(-1.0);
  filter->Update();
  vtkObject::GlobalWarningDisplayOn();
  EXPECT_EQ(filter->GetNumberOfCaps(), 0);
  EXPECT_EQ(filter->GetNumberOfClosedLoops(), 0);
  EXPECT_EQ(filter->GetCapArea(), 0.0);
}

TEST(BoneCap, CopiesArraysWithoutANameOnce)
{
  const vtkSmartPointer<vtkPolyData> input = PolyData(Shaft());
  vtkNew<vtkDoubleArray> nameless;
  nameless->SetNumberOfValues(input->GetNumberOfCells());
  nameless->Fill(3.0);
  input->GetCellData()->AddArray(nameless);
  vtkNew<vtkBoneCap> filter;
  filter->SetInputData(input);
  filter->Update();
  vtkCellData* data = filter->GetOutput()->GetCellData();
  ASSERT_EQ(data->GetNumberOfArrays(), 2);
  EXPECT_EQ(data->GetArray(0)->GetNumberOfTuples(), filter->GetOutput()->GetNumberOfCells());
  EXPECT_EQ(input->GetCellData()->GetArray(0)->GetNumberOfTuples(), input->GetNumberOfCells());
}
