// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Strokes of a brush on vtkBoneDecimate: what is kept between updates changes no output.
#include "BruteForce.h"
#include "FilterRun.h"
#include "VtkSurfaces.h"

#include "vtkBoneTolerance.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphere.h"

#include <gtest/gtest.h>

using namespace bonedecimate::testsupport;

namespace
{
/// A sphere of radius 10 with bumps, of which a ball may be simplified.
class Brush
{
public:
  explicit Brush(vtkPolyData* surface)
  {
    this->Filter->SetInputData(surface);
    this->Filter->SetChoiceToImplicitFunction();
    this->Filter->SetImplicitFunction(this->Ball);
    this->Filter->InvertedOn();
    this->Filter->SetOutsideTolerance(0.1);
    this->MoveTo(10.0);
  }
  void MoveTo(double z)
  {
    this->Ball->SetCenter(0.0, 0.0, z);
    this->Ball->SetRadius(3.0);
    this->Filter->Update();
  }
  vtkPolyData* Output() { return this->Filter->GetOutput(); }
  vtkAlgorithmOutput* Port() { return this->Filter->GetOutputPort(); }

private:
  vtkNew<vtkBoneTolerance> Filter;
  vtkNew<vtkSphere> Ball;
};

void SetOptions(vtkBoneDecimate* filter)
{
  filter->SetModeToFast();
  filter->SetMaximumError(0.1);
  filter->SetToleranceArrayName("Tolerance");
  filter->MeasureDistancesOff();
}

/// The output of a filter that has kept nothing.
void ExpectAsFresh(FilterRun& run, Brush& brush)
{
  FilterRun fresh(brush.Output());
  SetOptions(fresh.Get());
  EXPECT_TRUE(SameBytes(SurfaceOf(run.Output()), SurfaceOf(fresh.Output())));
  for (const char* name : { "ErrorBound", "InputPointCount", "Tolerance" })
  {
    EXPECT_EQ(Values(run.Output(), name), Values(fresh.Output(), name)) << name;
  }
}
}

TEST(Strokes, AfterTheFirstOnesRunOnlyWhatIsNew)
{
  Brush brush(Bumps(5));
  FilterRun run(brush.Output());
  run->SetInputConnection(brush.Port());
  SetOptions(run.Get());
  EXPECT_EQ(run->GetPreparedMemory(), 0);
  EXPECT_EQ(run.Value("regions.count"), 1.0);
  EXPECT_EQ(run.Value("regions.kept"), 0.0);
  EXPECT_LT(run.Value("regions.triangles"), 0.3 * run.Value("input.triangles"));
  EXPECT_LT(run.Value("output.triangles"), run.Value("input.triangles"));
  EXPECT_GT(run->GetPreparedMemory(), 0);
  ExpectAsFresh(run, brush);
  brush.MoveTo(-10.0);
  EXPECT_EQ(run.Value("regions.kept"), 0.0);
  ExpectAsFresh(run, brush);
  brush.MoveTo(10.0); // undone
  EXPECT_EQ(run.Value("regions.kept"), 1.0);
  ExpectAsFresh(run, brush);
  EXPECT_TRUE(run.SaidNothing()) << run.AllMessages();
}

TEST(Strokes, NoticeAnInputThatWasModifiedSilently)
{
  const vtkSmartPointer<vtkPolyData> surface = Bumps(5);
  Brush brush(surface);
  FilterRun run(brush.Output());
  run->SetInputConnection(brush.Port());
  SetOptions(run.Get());
  run.Output();
  double position[3];
  surface->GetPoint(0, position);
  surface->GetPoints()->SetPoint(0, 1.01 * position[0], 1.01 * position[1], 1.01 * position[2]);
  brush.MoveTo(9.9); // without vtkPoints::Modified()
  EXPECT_EQ(run.Value("regions.kept"), 0.0);
  ExpectAsFresh(run, brush);
}

TEST(Strokes, KeepNothingOnRequest)
{
  Brush brush(Bumps(5));
  FilterRun run(brush.Output());
  SetOptions(run.Get());
  EXPECT_TRUE(run->GetKeepPrepared());
  run.Output();
  const vtkMTimeType before = run->GetMTime();
  run->ReleasePrepared();
  EXPECT_EQ(run->GetPreparedMemory(), 0);
  EXPECT_TRUE(run->GetKeepPrepared());
  run->KeepPreparedOff();
  EXPECT_EQ(run->GetMTime(), before); // nothing has to be computed again
  run->Modified();
  ExpectAsFresh(run, brush);
  EXPECT_EQ(run->GetPreparedMemory(), 0);
  run->KeepPreparedOn();
  run->Modified();
  EXPECT_EQ(run.Value("regions.kept"), 0.0);
  EXPECT_GT(run->GetPreparedMemory(), 0);
}
