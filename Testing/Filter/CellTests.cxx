// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BruteForce.h"
#include "FilterRun.h"
#include "Shapes.h"
#include "VtkSurfaces.h"

#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSphereSource.h"
#include "vtkStripper.h"
#include "vtkVersion.h"

#include <gtest/gtest.h>

#include <functional>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// The points as they are, the triangles in strips where that goes.
vtkSmartPointer<vtkPolyData> Strips(vtkPolyData* triangles)
{
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(triangles);
  stripper->Update();
  return stripper->GetOutput();
}

/// An L of six corners in the plane z = 0, area 3 mm2: its triangulation must not leave it.
vtkSmartPointer<vtkPolyData> ConcavePolygon()
{
  auto polyData = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  for (const auto& [x, y] : { std::pair(0, 0), std::pair(2, 0), std::pair(2, 1), std::pair(1, 1),
         std::pair(1, 2), std::pair(0, 2) })
  {
    points->InsertNextPoint(x, y, 0.0);
  }
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 1, 2, 3, 4, 5 });
  polyData->SetPoints(points);
  polyData->SetPolys(polygons);
  return polyData;
}

/// A sphere, and beside it a vertex and a line of three points that no triangle uses.
vtkSmartPointer<vtkPolyData> SphereWithVertexAndLine()
{
  vtkSmartPointer<vtkPolyData> polyData = Bumps(3);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(polyData->GetPoints());
  const vtkIdType first = points->GetNumberOfPoints();
  for (const double x : { 20.5, 30.25, 31.25, 32.25 })
  {
    points->InsertNextPoint(x, 0.1, -0.3);
  }
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ first });
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ first + 3, first + 2, first + 1 });
  polyData->SetPoints(points);
  polyData->SetVerts(vertices);
  polyData->SetLines(lines);
  return polyData;
}

std::vector<Vector3> PointsOfCell(vtkPolyData* polyData, vtkCellArray* cells, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  cells->GetCellAtId(cell, ids);
  std::vector<Vector3> points;
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    points.emplace_back();
    polyData->GetPoint(ids->GetId(i), points.back().data());
  }
  return points;
}
}

TEST(Cells, ResultDoesNotDependOnHowTheyAreStored)
{
  FilterRun ofPlain(Bumps(3));
  const Surface expected = SurfaceOf(ofPlain.Output());
  std::vector<std::function<void(vtkCellArray*)>> conversions{ [](vtkCellArray* cells)
    { EXPECT_TRUE(cells->ConvertTo32BitStorage()); } };
#if VTK_MAJOR_VERSION > 9 || VTK_MINOR_VERSION >= 6
  conversions.emplace_back(
    [](vtkCellArray* cells) { EXPECT_TRUE(cells->ConvertToFixedSize32BitStorage()); });
  conversions.emplace_back(
    [](vtkCellArray* cells) { EXPECT_TRUE(cells->ConvertToFixedSize64BitStorage()); });
#endif
  for (const auto& convert : conversions)
  {
    const auto input = Bumps(3);
    convert(input->GetPolys());
    FilterRun run(input);
    const Surface result = SurfaceOf(run.Output());
    EXPECT_TRUE(result.Points == expected.Points);
    EXPECT_EQ(result.Triangles, expected.Triangles);
  }
}

TEST(Cells, StripsAreTakenAsTheirTriangles)
{
  const vtkSmartPointer<vtkPolyData> input = Bumps(3);
  const vtkSmartPointer<vtkPolyData> strips = Strips(input);
  ASSERT_GT(strips->GetNumberOfStrips(), 0);
  FilterRun run(strips);
  run->SetTargetReduction(0.5);
  EXPECT_EQ(run.Triangles(), 640);
  EXPECT_EQ(run.Value("input.triangles"), 1280);
  EXPECT_NEAR(run.Value("input.volume"), SignedVolume(SurfaceOf(input)), 1e-6);
  EXPECT_EQ(run.Value("output.boundary_edges"), 0);
  EXPECT_EQ(run.Output()->GetNumberOfStrips(), 0);
  EXPECT_TRUE(run.SaidNothing()) << run.AllMessages();
}

TEST(Cells, QuadsAreTriangulated)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(2.0);
  cube->Update();
  vtkNew<vtkPolyData> quads;
  quads->SetPoints(cube->GetOutput()->GetPoints());
  quads->SetPolys(cube->GetOutput()->GetPolys());
  FilterRun run(quads);
  run->SetTargetReduction(0.0);
  EXPECT_EQ(run.Triangles(), 12);
  EXPECT_EQ(run.Value("input.points"), 8) << "VTK's cube has 24 points, merged here";
  EXPECT_NEAR(run.Value("output.volume"), 2.0, 1e-6);
  EXPECT_NEAR(run.Value("output.area"), 10.0, 1e-6);
  EXPECT_TRUE(run.SaidNothing()) << run.AllMessages();
}

TEST(Cells, AConcavePolygonIsTriangulatedWithinItself)
{
  FilterRun run(ConcavePolygon());
  run->SetTargetReduction(0.0);
  EXPECT_EQ(run.Triangles(), 4);
  EXPECT_NEAR(run.Value("output.area"), 3.0, 1e-6);
  EXPECT_EQ(run.Value("output.boundary_edges"), 6);
  EXPECT_TRUE(run.SaidNothing()) << run.AllMessages();
}

TEST(Cells, SecondPortKeepsPolygonsAndStripsAsTheyAre)
{
  const vtkSmartPointer<vtkPolyData> strips = Strips(Bumps(2));
  FilterRun run(strips);
  run->MeasureInputDistancesOn();
  EXPECT_EQ(run.InputCopy()->GetNumberOfStrips(), strips->GetNumberOfStrips());
  EXPECT_EQ(Values(run.InputCopy(), "DistanceToResult").size(), 162U);
}

TEST(Cells, PointsThatAreNotSharedAreMergedToTheSameResult)
{
  FilterRun welded(Bumps(3));
  FilterRun unwelded(PolyData(Unwelded(SurfaceOf(Bumps(3)))));
  EXPECT_EQ(unwelded.Triangles(), welded.Triangles());
  EXPECT_EQ(unwelded.Value("output.boundary_edges"), 0);
  EXPECT_EQ(unwelded.Value("output.components"), 1);
  EXPECT_TRUE(unwelded.SaidNothing()) << unwelded.AllMessages();
}

TEST(Cells, VerticesAndLinesPassThroughWithTheirPoints)
{
  const vtkSmartPointer<vtkPolyData> input = SphereWithVertexAndLine();
  FilterRun run(input);
  vtkPolyData* output = run.Output();
  ASSERT_EQ(output->GetNumberOfVerts(), 1);
  ASSERT_EQ(output->GetNumberOfLines(), 1);
  EXPECT_EQ(PointsOfCell(output, output->GetVerts(), 0), PointsOfCell(input, input->GetVerts(), 0));
  EXPECT_EQ(PointsOfCell(output, output->GetLines(), 0), PointsOfCell(input, input->GetLines(), 0));
  EXPECT_EQ(output->GetNumberOfPolys(), 128);
  EXPECT_TRUE(run.SaidNothing()) << run.AllMessages();
}

TEST(Cells, PointsOfVerticesAndLinesStandForThemselvesAtNoDistance)
{
  const vtkSmartPointer<vtkPolyData> input = SphereWithVertexAndLine();
  FilterRun run(input);
  run->MeasureDistancesOn();
  const std::vector<double> counts = Values(run.Output(), "InputPointCount");
  EXPECT_EQ(Sum(counts), input->GetNumberOfPoints());
  const std::vector<double> distances = Values(run.Output(), "Distance");
  ASSERT_EQ(distances.size(), counts.size());
  EXPECT_EQ(distances.back(), 0.0);
  EXPECT_EQ(counts.back(), 1.0);
}

TEST(Cells, ALineAlongTheSurfaceKeepsItsPositionWhileTheSurfaceMoves)
{
  vtkSmartPointer<vtkPolyData> input = Bumps(3);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 100, 200, 300 });
  input->SetLines(lines);
  FilterRun run(input);
  run->SetTargetNumberOfTriangles(40);
  vtkPolyData* output = run.Output();
  ASSERT_EQ(output->GetNumberOfLines(), 1);
  EXPECT_EQ(PointsOfCell(output, output->GetLines(), 0), PointsOfCell(input, input->GetLines(), 0));
}

TEST(Cells, OfVtksOwnSphereComeOutClosed)
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(40);
  source->SetPhiResolution(30);
  source->SetRadius(10.0);
  source->Update();
  FilterRun run(source->GetOutput());
  EXPECT_EQ(WhatIsWrongWith(run.Output()), "");
  EXPECT_EQ(run.Value("output.boundary_edges"), 0);
  EXPECT_EQ(run.Value("output.euler_number"), 2);
  EXPECT_TRUE(run.SaidNothing()) << run.AllMessages();
}
