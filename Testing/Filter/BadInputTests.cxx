// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BruteForce.h"
#include "FilterRun.h"
#include "Shapes.h"
#include "VtkSurfaces.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{

/// Bumps(2) with that coordinate at the points 5, 17 and 100 of its 162.
vtkSmartPointer<vtkPolyData> WithCoordinates(double value)
{
  Surface surface = SurfaceOf(Bumps(2));
  surface.Points[5][0] = value;
  surface.Points[17][1] = value;
  surface.Points[100][2] = value;
  return PolyData(surface);
}

/// A rejection is one error, says so in the report, and leaves nothing on either port.
void ExpectRejected(FilterRun& run, const std::vector<std::string>& words)
{
  vtkPolyData* output = run.Output();
  EXPECT_EQ(run.Errors.size(), 1U) << run.AllMessages();
  for (const std::string& word : words)
  {
    EXPECT_EQ(run.Said(word), 1) << word << " in " << run.AllMessages();
  }
  EXPECT_EQ(output->GetNumberOfPoints(), 0);
  EXPECT_EQ(output->GetNumberOfCells(), 0);
  EXPECT_EQ(run->GetOutput(1)->GetNumberOfPoints(), 0);
  EXPECT_EQ(run->GetStopReason(), vtkBoneDecimate::NOT_RUN);
  EXPECT_FALSE(run->GetReportText("input.problem").empty());
}

/// A grid of 9 points, none in a cell yet.
vtkSmartPointer<vtkPolyData> GridPoints()
{
  vtkSmartPointer<vtkPolyData> polyData = PolyData(Grid(2));
  polyData->SetPolys(nullptr);
  return polyData;
}

vtkSmartPointer<vtkCellArray> Cells(std::initializer_list<std::initializer_list<vtkIdType>> cells)
{
  auto array = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& cell : cells)
  {
    array->InsertNextCell(cell);
  }
  return array;
}
}

TEST(BadInput, NothingAtAllGivesNothingAndNoMessage)
{
  FilterRun run(vtkSmartPointer<vtkPolyData>::New());
  EXPECT_EQ(run.Output()->GetNumberOfPoints(), 0);
  EXPECT_EQ(run.Output()->GetNumberOfCells(), 0);
  EXPECT_EQ(run.InputCopy()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(run.SaidNothing()) << run.AllMessages();
  EXPECT_EQ(run.Progress.back(), 1.0);
}

TEST(BadInput, PointsWithoutCellsAreAWarning)
{
  FilterRun run(GridPoints());
  EXPECT_EQ(run.Output()->GetNumberOfPolys(), 0);
  EXPECT_TRUE(run.Errors.empty()) << run.AllMessages();
  EXPECT_EQ(run.Said("9 points, 0 triangles"), 1) << run.AllMessages();
}

TEST(BadInput, NotANumberIsRejectedWithCountAndFirstPoint)
{
  FilterRun run(WithCoordinates(std::nan("")));
  ExpectRejected(run, { "3 points", "point 5" });
}

TEST(BadInput, InfinityIsRejectedWithCountAndFirstPoint)
{
  FilterRun plus(WithCoordinates(Infinity));
  ExpectRejected(plus, { "3 points", "point 5" });
  FilterRun minus(WithCoordinates(-Infinity));
  ExpectRejected(minus, { "3 points", "point 5" });
}

TEST(BadInput, HugeCoordinatesAreRejectedWithCountAndFirstPoint)
{
  FilterRun run(WithCoordinates(1e200));
  ExpectRejected(run, { "1e30", "3 points", "point 5" });
}

TEST(BadInput, LargeCoordinatesBelowThatAreNot)
{
  FilterRun run(PolyData(Scaled(Icosphere(3, 1.0), 1e29)));
  EXPECT_EQ(run.Triangles(), 128);
  EXPECT_EQ(WhatIsWrongWith(run.Output()), "");
  EXPECT_EQ(run.Said("not the size of a bone"), 1);
  EXPECT_EQ(run.Errors.size() + run.Warnings.size(), 1U) << run.AllMessages();
}

TEST(BadInput, TinyCoordinatesAreNot)
{
  FilterRun run(PolyData(Scaled(Icosphere(3, 1.0), 1e-30)));
  EXPECT_EQ(run.Triangles(), 128);
  EXPECT_EQ(WhatIsWrongWith(run.Output()), "");
}

TEST(BadInput, ATriangleOfAPointThatIsNotThereIsRejected)
{
  Surface surface = SurfaceOf(Bumps(2));
  surface.Triangles[7][1] = 162;
  surface.Triangles[30][0] = -4;
  FilterRun run(PolyData(surface));
  ExpectRejected(run, { "2 triangles", "triangle 7 " });
}

TEST(BadInput, AHugeIdIsRejectedNotWrappedAround)
{
  vtkSmartPointer<vtkPolyData> polyData = GridPoints();
  polyData->SetPolys(Cells({ { 0, 1, 3 }, { 0, 1, (vtkIdType(1) << 32) + 3 } }));
  FilterRun run(polyData);
  ExpectRejected(run, { "1 triangle has", "triangle 1 " });
}

TEST(BadInput, APolygonOfAPointThatIsNotThereIsRejectedWithItsNumber)
{
  vtkSmartPointer<vtkPolyData> polyData = GridPoints();
  polyData->SetPolys(Cells({ { 0, 1, 4, 3 }, { 1, 2, 5, 4 }, { 3, 4, 7, 99 }, { 4, 5, 8, -1 } }));
  FilterRun run(polyData);
  ExpectRejected(run, { "2 ", " 2 (there are 9 points)" });
}

TEST(BadInput, AStripOfAPointThatIsNotThereIsRejectedWithItsNumber)
{
  vtkSmartPointer<vtkPolyData> polyData = GridPoints();
  polyData->SetStrips(Cells({ { 0, 1, 3, 4 }, { 3, 4, 6, 9 } }));
  FilterRun run(polyData);
  ExpectRejected(run, { "1 ", " 1 (there are 9 points)" });
}

TEST(BadInput, CellsWithoutAnyPointsAreRejected)
{
  vtkNew<vtkPolyData> polyData;
  polyData->SetPolys(Cells({ { 0, 1, 2 } }));
  FilterRun run(polyData);
  ExpectRejected(run, { "1 triangle has", "triangle 0", "0 points" });
}

TEST(BadInput, ALineOfAPointThatIsNotThereIsLeftOutAloud)
{
  vtkSmartPointer<vtkPolyData> polyData = Bumps(2);
  polyData->SetLines(Cells({ { 0, 1 }, { 2, 3, 400 } }));
  polyData->SetVerts(Cells({ { 0 }, { -1 } }));
  FilterRun run(polyData);
  vtkPolyData* output = run.Output();
  EXPECT_EQ(output->GetNumberOfLines(), 1);
  EXPECT_EQ(output->GetNumberOfVerts(), 1);
  EXPECT_EQ(output->GetNumberOfPoints(), run.Value("output.points") + 2)
    << "points that no cell uses";
  EXPECT_FALSE(run.SaidNothing()) << "two cells were left out without a word";
}

TEST(BadInput, LinesWithoutAnyPointsDoNotCrash)
{
  vtkNew<vtkPolyData> polyData;
  polyData->SetLines(Cells({ { 0, 1 } }));
  FilterRun run(polyData);
  EXPECT_EQ(run.Output()->GetNumberOfLines(), 0);
  EXPECT_FALSE(run.SaidNothing()) << "a cell was left out without a word";
}

TEST(BadInput, PolygonsOfFewerThanThreePointsAreLeftOutWithCountAndFirst)
{
  vtkSmartPointer<vtkPolyData> polyData = PolyData(Grid(2));
  polyData->GetPolys()->InsertNextCell({ 0, 1 });
  polyData->GetPolys()->InsertNextCell({ 2 });
  FilterRun run(polyData);
  run->SetTargetReduction(0.0);
  EXPECT_EQ(run.Triangles(), 8);
  EXPECT_EQ(run.Said("2 polygons"), 1) << run.AllMessages();
  EXPECT_EQ(run.Said("cell 8"), 1) << run.AllMessages();
}

TEST(BadInput, EveryPolygonWithThreeCornersIsTriangulated)
{
  vtkSmartPointer<vtkPolyData> polyData = GridPoints();
  polyData->SetPolys(Cells({ { 0, 1, 3, 4 }, { 1, 2, 5, 4 }, { 3, 4, 5, 8, 7, 6 } }));
  FilterRun run(polyData);
  run->SetTargetReduction(0.0);
  EXPECT_EQ(run.Triangles(), 8) << "the first polygon crosses itself";
  EXPECT_TRUE(run.SaidNothing() || run.Said("polygon") == 0) << run.AllMessages();
}

TEST(BadInput, WhatIsLeftOutQualifiesTheProof)
{
  vtkSmartPointer<vtkPolyData> polyData = PolyData(Grid(2));
  polyData->GetPolys()->InsertNextCell({ 0, 1 });
  const vtkIdType far = polyData->GetPoints()->InsertNextPoint(0.0, 0.0, 7.0);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, far });
  polyData->SetLines(lines);
  FilterRun run(polyData);
  run->SetMaximumError(0.1);
  EXPECT_LE(run.Value("left_out.0.distance"), 0.1) << "an edge of the surface";
  EXPECT_EQ(run->GetReportText("left_out.0.kind"), "polygons");
  EXPECT_EQ(run->GetReportText("left_out.1.kind"), "lines");
  EXPECT_NEAR(run.Value("left_out.1.distance"), 7.0, 0.01);
  const std::string sentence = run->GetReportText("proof.sentence");
  EXPECT_EQ(sentence.find("polygon"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find(", but for 1 line (cell 0), up to 7.0"), std::string::npos) << sentence;
}

TEST(BadInput, APolygonWithoutAreaIsLeftOutAloud)
{
  vtkSmartPointer<vtkPolyData> polyData = GridPoints();
  polyData->SetPolys(Cells({ { 0, 1, 4, 3 }, { 0, 1, 2, 1 }, { 4, 4, 4, 4 } }));
  FilterRun run(polyData);
  run->SetTargetReduction(0.0);
  EXPECT_EQ(run.Triangles(), 2);
  EXPECT_EQ(WhatIsWrong(SurfaceOf(run.Output())), "");
  EXPECT_FALSE(run.SaidNothing()) << "two polygons were left out without a word";
}

TEST(BadInput, ASurfaceInsideOutIsAWarning)
{
  Surface surface = SurfaceOf(Bumps(2));
  for (Triangle& triangle : surface.Triangles)
  {
    std::swap(triangle[0], triangle[1]);
  }
  const vtkSmartPointer<vtkPolyData> polyData = PolyData(surface);
  FilterRun run(polyData);
  EXPECT_GT(run.Triangles(), 0);
  EXPECT_EQ(run.Said("1 closed part is inside out, and so is the result"), 1) << run.AllMessages();
}

TEST(BadInput, OnlyTrianglesWithoutAreaAreAWarning)
{
  vtkSmartPointer<vtkPolyData> polyData = GridPoints();
  polyData->SetPolys(Cells({ { 0, 0, 1 }, { 0, 1, 2 } }));
  FilterRun run(polyData);
  EXPECT_EQ(run.Triangles(), 0);
  EXPECT_TRUE(run.Errors.empty()) << run.AllMessages();
  EXPECT_EQ(run.Said("9 points, 2 triangles"), 1) << run.AllMessages();
}

TEST(BadInput, AfterARejectionAGoodInputIsTaken)
{
  FilterRun run(WithCoordinates(std::nan("")));
  run.Output();
  run->SetInputData(Bumps(2));
  EXPECT_EQ(run.Triangles(), 32);
  EXPECT_EQ(run.Errors.size(), 1U) << run.AllMessages();
  EXPECT_EQ(run->GetReportText("input.problem"), "");
}

TEST(BadInput, AfterAGoodInputARejectionLeavesNothingOfItsResult)
{
  FilterRun run(Bumps(2));
  run.Output();
  run->SetInputData(WithCoordinates(std::nan("")));
  ExpectRejected(run, { "3 points" });
  EXPECT_EQ(run->GetReportValue("output.triangles"), 0);
}
