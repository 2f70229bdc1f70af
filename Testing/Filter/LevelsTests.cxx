// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// vtkBoneDecimateLevels: one run, many levels.
#include "BruteForce.h"
#include "Shapes.h"
#include "VtkSurfaces.h"

#include "vtkBoneDecimate.h"
#include "vtkBoneDecimateLevels.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// The filter with a surface, unmeasured; counts its errors and the words of progress, of which
/// only runs have some.
class LevelsRun
{
public:
  explicit LevelsRun(vtkPolyData* surface)
  {
    this->Filter->SetInputData(surface);
    this->Filter->MeasureDistancesOff();
    this->Filter->SetTargetNumberOfTriangles(100);
    this->Filter->AddObserver(vtkCommand::ErrorEvent, this, &LevelsRun::OnError);
    this->Filter->AddObserver(vtkCommand::ProgressEvent, this, &LevelsRun::OnProgress);
    this->Filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this, &LevelsRun::OnNothing);
  }
  vtkBoneDecimateLevels* operator->() { return this->Filter; }
  Surface Level(int triangles)
  {
    this->Filter->SetNumberOfTriangles(triangles);
    this->Filter->Update();
    return SurfaceOf(this->Filter->GetOutput());
  }
  bool RanSince()
  {
    const bool ran = this->Words > 10;
    this->Words = 0;
    return ran;
  }

  int Errors = 0;

private:
  void OnError(vtkObject*, unsigned long, void*) { ++this->Errors; }
  void OnProgress(vtkObject*, unsigned long, void*) { ++this->Words; }
  void OnNothing(vtkObject*, unsigned long, void*) {}

  int Words = 0;
  vtkNew<vtkBoneDecimateLevels> Filter;
};
}

TEST(LevelsFilter, RunsOnceForAllLevels)
{
  LevelsRun levels(Bumps(4));
  EXPECT_EQ(levels.Level(2000).Triangles.size(), 2000U);
  EXPECT_TRUE(levels.RanSince());
  for (const int triangles : { 3000, 500, 1000, 4000 })
  {
    EXPECT_EQ(levels.Level(triangles).Triangles.size(), static_cast<std::size_t>(triangles));
  }
  EXPECT_FALSE(levels.RanSince());
  levels->SetMode(vtkBoneDecimate::FAST);
  levels.Level(500);
  EXPECT_TRUE(levels.RanSince());
}

TEST(LevelsFilter, RunsAgainForAnotherInput)
{
  const vtkSmartPointer<vtkPolyData> input = Bumps(3);
  LevelsRun levels(input);
  const Surface before = levels.Level(200);
  levels.RanSince();
  input->DeepCopy(Bumps(4));
  levels.Level(200);
  EXPECT_TRUE(levels.RanSince());
  levels->SetInputData(Bumps(3));
  EXPECT_TRUE(SameBytes(levels.Level(200), before));
  EXPECT_TRUE(levels.RanSince());
}

TEST(LevelsFilter, TheCoarsestLevelIsTheResultOfTheDecimation)
{
  for (const int mode : { vtkBoneDecimate::THESIS, vtkBoneDecimate::BALANCED })
  {
    LevelsRun levels(Bumps(4));
    levels->SetMode(mode);
    vtkNew<vtkBoneDecimate> direct;
    direct->SetInputData(Bumps(4));
    direct->SetMode(mode);
    direct->MeasureDistancesOff();
    direct->SetTargetNumberOfTriangles(100);
    direct->Update();
    EXPECT_TRUE(SameBytes(levels.Level(0), SurfaceOf(direct->GetOutput())));
  }
}

TEST(LevelsFilter, PrecisionIsThatOfTheInput)
{
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    LevelsRun levels(PolyData(BumpySphere(3, 10.0, 0.05, 1), type));
    levels.Level(300);
    EXPECT_EQ(levels->GetOutput()->GetPoints()->GetDataType(), type);
  }
}

TEST(LevelsFilter, LevelsByErrorAndTheirMarks)
{
  LevelsRun levels(Bumps(3));
  levels->MeasureDistancesOn();
  levels->Update();
  const int marks = levels->GetNumberOfMarks();
  ASSERT_GT(marks, 4);
  EXPECT_EQ(levels->GetMarkTriangles(marks - 1), 100);
  EXPECT_EQ(levels->GetMarkTriangles(marks), 0);
  EXPECT_TRUE(std::isnan(levels->GetMarkLargestDistance(marks)));
  EXPECT_LE(levels->GetMarkMeanDistance(2), levels->GetMarkLargestDistance(2));
  levels->SetLevelError(levels->GetMarkLargestDistance(marks - 1) * 1.0001);
  EXPECT_EQ(levels.Level(0).Triangles.size(), 100U);
  levels->SetLevelError(1e-9);
  EXPECT_EQ(levels.Level(0).Triangles.size(), 1280U) << "the input itself";
  levels->SetLevelError(1000.0);
  EXPECT_EQ(levels.Level(640).Triangles.size(), 640U) << "the finer of both";
}

TEST(LevelsFilter, ALogStandsForARun)
{
  LevelsRun recorded(Bumps(4));
  const Surface expected = recorded.Level(800);
  LevelsRun replayed(Bumps(4));
  replayed->SetLog(recorded->GetLog());
  EXPECT_TRUE(SameBytes(replayed.Level(800), expected));
  EXPECT_FALSE(replayed.RanSince());
  EXPECT_EQ(replayed->GetNumberOfMarks(), recorded->GetNumberOfMarks());
  replayed->SetLog(nullptr);
  EXPECT_TRUE(SameBytes(replayed.Level(800), expected));
  EXPECT_TRUE(replayed.RanSince());
}

TEST(LevelsFilter, ALogThatIsDamagedOrOfAnotherSurfaceIsAnErrorWithoutOutput)
{
  LevelsRun recorded(Bumps(4));
  recorded.Level(800);
  LevelsRun other(Bumps(3));
  other->SetLog(recorded->GetLog());
  EXPECT_TRUE(other.Level(800).Triangles.empty());
  EXPECT_EQ(other.Errors, 1);
  vtkNew<vtkUnsignedCharArray> damaged;
  damaged->DeepCopy(recorded->GetLog());
  damaged->SetValue(100, static_cast<unsigned char>(damaged->GetValue(100) ^ 1U));
  LevelsRun same(Bumps(4));
  same->SetLog(damaged);
  EXPECT_TRUE(same.Level(800).Triangles.empty());
  damaged->SetNumberOfValues(0);
  same->SetLog(damaged);
  EXPECT_TRUE(same.Level(800).Triangles.empty());
  EXPECT_EQ(same.Errors, 2);
}

TEST(LevelsFilter, OnAnotherBoneOfTheSameTrianglesTheLevelHasTheSameTriangles)
{
  const Surface bone = BumpySphere(4, 10.0, 0.05, 1);
  LevelsRun levels(PolyData(bone));
  const Surface first = levels.Level(600);
  levels->SetInputData(1, PolyData(Scaled(bone, 2.0)));
  const Surface second = levels.Level(600);
  EXPECT_EQ(second.Triangles, first.Triangles);
  for (std::size_t i = 0; i < first.Points.size(); ++i)
  {
    EXPECT_LT((second.Points[i] - 2.0 * first.Points[i]).norm(), 1e-10);
  }
  levels->SetInputData(1, Bumps(3));
  levels->Update();
  EXPECT_EQ(levels.Errors, 1);
}

TEST(LevelsFilter, EmptyAndBrokenInputs)
{
  vtkNew<vtkPolyData> nothing;
  LevelsRun empty(nothing);
  EXPECT_TRUE(empty.Level(10).Triangles.empty());
  EXPECT_EQ(empty.Errors, 0);
  EXPECT_EQ(empty->GetLog()->GetNumberOfValues(), 0);
  Surface broken = BumpySphere(3, 10.0, 0.05, 1);
  broken.Points[7][2] = std::nan("");
  LevelsRun rejected(PolyData(broken));
  rejected.Level(10);
  EXPECT_EQ(rejected.Errors, 1);
}

TEST(LevelsFilter, PrintSelfNamesEveryProperty)
{
  LevelsRun levels(Bumps(3));
  std::ostringstream text;
  levels->Print(text);
  for (const char* name :
    { "Mode: Balanced", "TargetNumberOfTriangles: 100", "MaximumError: 0 mm",
      "MeasureDistances: off", "NumberOfThreads: 0", "NumberOfTriangles: 0", "LevelError: 0 mm" })
  {
    EXPECT_NE(text.str().find(name), std::string::npos) << name;
  }
}

TEST(LevelsFilter, TheReportIsOfTheRunAndGoneAfterAnUpdateThatFailed)
{
  LevelsRun levels(Bumps(3));
  levels.Level(200);
  const vtkIdType triangles = levels->GetNumberOfOutputTriangles();
  EXPECT_EQ(triangles, 100);
  levels.Level(400); // another level of the same run
  EXPECT_EQ(levels->GetNumberOfOutputTriangles(), triangles);
  levels->SetNumberOfTriangles(-1);
  levels->Update();
  EXPECT_EQ(levels->GetNumberOfOutputTriangles(), 0);
  EXPECT_EQ(levels->GetStopReason(), vtkBoneDecimate::NOT_RUN);
  levels.RanSince();
  levels.Level(200);
  EXPECT_FALSE(levels.RanSince());
  EXPECT_EQ(levels->GetNumberOfOutputTriangles(), triangles);
}

TEST(LevelsFilter, ListsWhatWasLeftOutOfTheReferenceIfThereIsOne)
{
  const auto withLine = [](bool hasLine)
  {
    vtkSmartPointer<vtkPolyData> surface = Bumps(3);
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell({ 0, 1 });
    surface->SetLines(hasLine ? lines.Get() : nullptr);
    return surface;
  };
  for (const bool ofReference : { false, true })
  {
    LevelsRun levels(withLine(!ofReference));
    levels->SetReferenceData(withLine(ofReference));
    levels->SetMaximumError(0.5);
    levels.Level(0);
    EXPECT_EQ(levels->GetReportText("left_out.0.kind"), ofReference ? "lines" : "");
  }
}
