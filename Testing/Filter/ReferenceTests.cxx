// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The reference on input port 1, as a VTK user meets it; what it is worth is tested in the core.
#include "FilterRun.h"
#include "VtkSurfaces.h"

#include "vtkBoneSurfaceDistance.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

using namespace bonedecimate::testsupport;

namespace
{
constexpr double Settings = 0.3; // mm

vtkSmartPointer<vtkPolyData> Simplified(vtkPolyData* surface, vtkPolyData* reference)
{
  FilterRun run(surface);
  run->SetMaximumError(Settings);
  run->SetReferenceData(reference);
  vtkSmartPointer<vtkPolyData> output = vtkSmartPointer<vtkPolyData>::New();
  output->ShallowCopy(run.Output());
  EXPECT_TRUE(run.SaidNothing()) << run.AllMessages();
  return output;
}

double ProvedDistance(vtkPolyData* reference, vtkPolyData* result)
{
  vtkNew<vtkBoneSurfaceDistance> distance;
  distance->SetInputData(0, reference);
  distance->SetInputData(1, result);
  distance->Update();
  return distance->GetUpperBound();
}
}

TEST(Reference, OnPortOneIsWhatTheErrorIsBoundedAgainstRunAfterRun)
{
  const vtkSmartPointer<vtkPolyData> first = Bumps(4);
  vtkSmartPointer<vtkPolyData> surface = first;
  for (int run = 0; run < 3; ++run)
  {
    surface = Simplified(surface, first);
    EXPECT_LE(ProvedDistance(first, surface), Settings);
  }
  EXPECT_LT(surface->GetNumberOfPolys(), first->GetNumberOfPolys());
}

TEST(Reference, IsOptionalAndIsTakenAwayAgain)
{
  const vtkSmartPointer<vtkPolyData> first = Bumps(3);
  FilterRun run(first);
  run->SetMaximumError(Settings);
  run->SetReferenceData(first);
  run.Output();
  EXPECT_EQ(run.Value("reference.triangles"), static_cast<double>(first->GetNumberOfPolys()));
  run->SetReferenceConnection(nullptr);
  run.Output();
  EXPECT_EQ(run->GetReportText("reference.triangles"), "");
}

TEST(Reference, HasNoBoundsAtPointsOfTheInput)
{
  const vtkSmartPointer<vtkPolyData> first = Bumps(3);
  FilterRun run(first);
  run->SetMaximumError(Settings);
  run->SetMeasureInputDistances(true);
  run->SetReferenceData(first);
  EXPECT_TRUE(run.InputCopy()->GetPointData()->HasArray("DistanceToResult"));
  EXPECT_FALSE(run.InputCopy()->GetPointData()->HasArray("ErrorBoundToResult"));
  EXPECT_TRUE(run.Output()->GetPointData()->HasArray("ErrorBound"));
}

TEST(Reference, WithoutALargestErrorIsAnError)
{
  const vtkSmartPointer<vtkPolyData> first = Bumps(3);
  FilterRun run(first);
  run->SetReferenceData(first);
  EXPECT_EQ(run.Output()->GetNumberOfPoints(), 0);
  EXPECT_EQ(run.Said("a reference needs a largest error"), 1);
}
