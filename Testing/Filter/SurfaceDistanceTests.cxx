// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Run/Report/ReportFigures.h"
#include "Shapes.h"
#include "VtkSurfaces.h"

#include "vtkBoneSurfaceDistance.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

using namespace bonedecimate::testsupport;

namespace
{
/// The filter with two inputs; counts what it says.
class DistanceRun
{
public:
  DistanceRun(vtkPolyData* reference, vtkPolyData* result)
  {
    this->Filter->SetInputData(0, reference);
    this->Filter->SetInputData(1, result);
    for (const auto event :
      { vtkCommand::ErrorEvent, vtkCommand::WarningEvent, vtkCommand::ProgressEvent })
    {
      this->Filter->AddObserver(event, this, &DistanceRun::OnEvent);
    }
    this->Filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this, &DistanceRun::OnEvent);
  }

  vtkBoneSurfaceDistance* operator->() { return this->Filter; }

  int Errors = 0;
  int Warnings = 0;
  double AbortAt = 2.0;
  std::vector<double> Progress;
  std::vector<std::array<double, 2>> Bounds; // mm, in events

private:
  void OnEvent(vtkObject* caller, unsigned long event, void*)
  {
    this->Errors += event == vtkCommand::ErrorEvent && caller == this->Filter.Get() ? 1 : 0;
    this->Warnings += event == vtkCommand::WarningEvent ? 1 : 0;
    if (event == vtkCommand::ProgressEvent)
    {
      this->Progress.push_back(this->Filter->GetProgress());
      this->Bounds.push_back({ this->Filter->GetLowerBound(), this->Filter->GetUpperBound() });
      this->Filter->SetAbortExecute(this->Progress.back() >= this->AbortAt ? 1 : 0);
    }
  }

  vtkNew<vtkBoneSurfaceDistance> Filter;
};

vtkSmartPointer<vtkPolyData> Plate(double height)
{
  return PolyData(Moved(Grid(6), { 0.0, 0.0, height }));
}

void AddTolerance(vtkPolyData* surface, double tolerance)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("tolerance");
  array->SetNumberOfTuples(surface->GetNumberOfPoints());
  array->Fill(tolerance);
  surface->GetPointData()->AddArray(array);
}
}

TEST(SurfaceDistanceFilter, BoundsTheDistanceAndSaysWhere)
{
  DistanceRun run(Plate(0.0), Plate(0.25));
  run->Update();
  EXPECT_LE(run->GetLowerBound(), 0.25);
  EXPECT_GE(run->GetUpperBound(), 0.25);
  EXPECT_NEAR(run->GetUpperBound(), run->GetLowerBound(), 1e-6);
  EXPECT_EQ(run->GetStatus(), vtkBoneSurfaceDistance::NOT_REQUESTED);
  EXPECT_EQ(run->GetReportText("boundaries"), "both");
  EXPECT_NEAR(run->GetReportValue("boundary_reference_to_result.upper"), 0.25, 1e-6);
  EXPECT_EQ(run->GetReportEntryUnit("reference_to_result.upper"), "mm");
  EXPECT_GE(run->GetReportValue("reference_to_result.triangle"), 0.0);
  EXPECT_EQ(run.Errors + run.Warnings, 0);
}

TEST(SurfaceDistanceFilter, GivesEachPointItsSignedDistanceOnBothOutputs)
{
  DistanceRun run(Sphere(3), PolyData(Scaled(Icosphere(3, 10.0), 1.1)));
  run->Update();
  const std::vector<double> inside = Values(run->GetOutput(0), "SignedDistance");
  const std::vector<double> outside = Values(run->GetOutput(1), "SignedDistance");
  ASSERT_EQ(inside.size(), static_cast<std::size_t>(run->GetOutput(0)->GetNumberOfPoints()));
  for (const double distance : inside)
  {
    EXPECT_LT(distance, -0.9);
    EXPECT_GT(distance, -1.1);
  }
  for (const double distance : outside)
  {
    EXPECT_GT(distance, 0.9);
  }
  const std::vector<double> sides = Values(run->GetOutput(1), "Side");
  EXPECT_EQ(std::count(sides.begin(), sides.end(), 1.0), static_cast<long>(sides.size()));
  EXPECT_STREQ(
    run->GetOutput()->GetPointData()->GetArray("SignedDistance")->GetComponentName(0), "mm");
}

TEST(SurfaceDistanceFilter, WithoutANameThereAreNoDistancesOfPoints)
{
  DistanceRun with(Sphere(3), PolyData(Scaled(Icosphere(3, 10.0), 1.1)));
  with->Update();
  DistanceRun without(Sphere(3), PolyData(Scaled(Icosphere(3, 10.0), 1.1)));
  without->SetSignedDistanceArrayName({});
  without->Update();
  EXPECT_EQ(without->GetOutput(0)->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(without->GetOutput(1)->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(without->GetLowerBound(), with->GetLowerBound());
  EXPECT_EQ(without->GetUpperBound(), with->GetUpperBound());
}

TEST(SurfaceDistanceFilter, ChecksATolerance)
{
  DistanceRun run(Plate(0.0), Plate(0.25));
  run->SetTolerance(0.3);
  run->Update();
  EXPECT_EQ(run->GetStatus(), vtkBoneSurfaceDistance::PROVED);
  run->SetTolerance(0.2);
  run->Update();
  EXPECT_EQ(run->GetStatus(), vtkBoneSurfaceDistance::VIOLATED);
  EXPECT_EQ(run->GetStatusAsString(), "violated");
}

TEST(SurfaceDistanceFilter, ChecksAToleranceOfEachPoint)
{
  const vtkSmartPointer<vtkPolyData> plate = Plate(0.0);
  AddTolerance(plate, 0.3);
  DistanceRun run(plate, Plate(0.25));
  run->SetToleranceArrayName("tolerance");
  run->Update();
  EXPECT_EQ(run->GetStatus(), vtkBoneSurfaceDistance::PROVED);
  EXPECT_LE(run->GetReportValue("reference_to_result.excess.upper"), 0.0);
  AddTolerance(plate, 0.2);
  plate->Modified();
  run->Update();
  EXPECT_EQ(run->GetStatus(), vtkBoneSurfaceDistance::VIOLATED);
  run->SetToleranceArrayName("nothing");
  run->Update();
  EXPECT_EQ(run.Errors, 1);
}

TEST(SurfaceDistanceFilter, PutsTheReportIntoTheFieldData)
{
  DistanceRun run(Plate(0.0), Plate(0.25));
  run->Update();
  for (const int port : { 0, 1 })
  {
    vtkFieldData* fieldData = run->GetOutput(port)->GetFieldData();
    vtkAbstractArray* report = fieldData->GetAbstractArray("BoneDecimateCertificate");
    ASSERT_NE(report, nullptr);
    EXPECT_EQ(report->GetVariantValue(0).ToString(), run->GetReportAsJson());
    for (const std::string& name : bonedecimate::CertificateKeyFigures())
    {
      EXPECT_NE(fieldData->GetAbstractArray(("bonedecimate.certificate." + name).c_str()), nullptr)
        << name;
    }
  }
}

TEST(SurfaceDistanceFilter, TellsItsProgressToTheEnd)
{
  DistanceRun run(Bumps(5), Sphere(4));
  run->SetNumberOfThreads(1);
  run->Update();
  ASSERT_FALSE(run.Progress.empty());
  EXPECT_TRUE(std::is_sorted(run.Progress.begin(), run.Progress.end()));
  EXPECT_EQ(run.Progress.back(), 1.0);
}

TEST(SurfaceDistanceFilter, AbortedHasTheBoundsProvedUntilThen)
{
  DistanceRun whole(Bumps(5), Sphere(4));
  whole->Update();
  EXPECT_FALSE(whole->GetWasStopped());
  EXPECT_EQ(whole->GetReportText("stopped"), "");
  for (const double abortAt : { 0.01, 0.3, 0.5, 0.9 })
  {
    DistanceRun run(Bumps(5), Sphere(4));
    run.AbortAt = abortAt;
    run->SetTolerance(50.0);
    run->Update();
    EXPECT_TRUE(run->GetWasStopped());
    EXPECT_EQ(run.Errors, 0);
    EXPECT_EQ(run->GetReportText("problem"), "");
    EXPECT_EQ(run->GetReportText("stopped"), "stopped: bounds proved so far");
    EXPECT_LE(run->GetLowerBound(), whole->GetUpperBound());
    EXPECT_GE(run->GetUpperBound(), whole->GetLowerBound());
    EXPECT_EQ(run->GetStatus(), vtkBoneSurfaceDistance::PROVED);
    const auto points = static_cast<std::size_t>(run->GetOutput()->GetNumberOfPoints());
    const std::size_t distances = Values(run->GetOutput(), "SignedDistance").size();
    EXPECT_TRUE(distances == 0 || distances == points) << distances; // all of them or none
  }
}

TEST(SurfaceDistanceFilter, KnowsBoundsInProgressEvents)
{
  DistanceRun run(Bumps(5), Sphere(4));
  run->SetFollowBounds(true);
  run->Update();
  const auto first = std::find_if(run.Bounds.begin(), run.Bounds.end(),
    [](const std::array<double, 2>& bounds) { return !std::isnan(bounds[0]); });
  run.Bounds.erase(run.Bounds.begin(), first);
  ASSERT_GT(run.Bounds.size(), 50u);
  for (std::size_t i = 0; i < run.Bounds.size(); ++i)
  {
    EXPECT_LE(run.Bounds[i][0], run->GetUpperBound());
    EXPECT_GE(run.Bounds[i][1], run->GetLowerBound());
    EXPECT_TRUE(i == 0 || run.Bounds[i][0] >= run.Bounds[i - 1][0]);
    EXPECT_TRUE(i == 0 || run.Bounds[i][1] <= run.Bounds[i - 1][1]);
  }
}

TEST(SurfaceDistanceFilter, DescribesBothSurfacesOnRequest)
{
  DistanceRun run(PolyData(Icosphere(2, 5.0)), PolyData(Envelope()));
  run->Update();
  EXPECT_TRUE(std::isnan(run->GetReportValue("reference.triangles")));
  run->MeasureSurfacesOn();
  run.Progress.clear();
  run->Update();
  EXPECT_EQ(run->GetReportValue("reference.triangles"), 320.0);
  EXPECT_EQ(run->GetReportValue("reference.components"), 1.0);
  EXPECT_EQ(run->GetReportValue("reference.intersecting_pairs"), 0.0);
  EXPECT_EQ(run->GetReportEntryUnit("reference.volume"), "mm3");
  EXPECT_GT(run->GetReportValue("result.area"), 0.0);
  EXPECT_TRUE(std::is_sorted(run.Progress.begin(), run.Progress.end()));
}

TEST(SurfaceDistanceFilter, AbortedWhileItDescribesSurfacesWasStopped)
{
  DistanceRun run(Bumps(5), Sphere(4));
  run->MeasureSurfacesOn();
  run.AbortAt = 0.9;
  run->Update();
  EXPECT_TRUE(run->GetWasStopped());
  EXPECT_TRUE(std::isnan(run->GetReportValue("result.triangles")));
  EXPECT_NEAR(run->GetUpperBound(), run->GetLowerBound(), 1e-5);
}

TEST(SurfaceDistanceFilter, RejectsWhatIsNoSurface)
{
  bonedecimate::Surface broken = Grid(3);
  broken.Points[3].x() = std::nan("");
  DistanceRun run(PolyData(broken), Plate(0.0));
  run->Update();
  EXPECT_EQ(run.Errors, 1);
  EXPECT_NE(run->GetReportText("problem").find("reference"), std::string::npos);
  vtkNew<vtkPolyData> nothing;
  DistanceRun empty(Plate(0.0), nothing);
  empty->Update();
  EXPECT_EQ(empty.Errors, 0);
  EXPECT_EQ(empty.Warnings, 1);
  EXPECT_TRUE(std::isnan(empty->GetUpperBound()));
}

TEST(SurfaceDistanceFilter, RejectsAPieceOfASurface)
{
  for (const int port : { 0, 1 })
  {
    DistanceRun run(Plate(0.0), Plate(0.25));
    run->SetTolerance(0.5);
    run->Update();
    EXPECT_EQ(run->GetStatus(), vtkBoneSurfaceDistance::PROVED);
    vtkNew<vtkInformationVector> requests;
    requests->SetNumberOfInformationObjects(2);
    vtkInformation* request = requests->GetInformationObject(port);
    request->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
    request->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 2);
    EXPECT_FALSE(run->Update(port, requests));
    EXPECT_EQ(run.Errors, 1) << port;
    EXPECT_EQ(run->GetStatus(), vtkBoneSurfaceDistance::NOT_REQUESTED);
    EXPECT_TRUE(std::isnan(run->GetUpperBound()));
  }
}

TEST(SurfaceDistanceFilter, PrintsEveryProperty)
{
  vtkNew<vtkBoneSurfaceDistance> filter;
  std::ostringstream text;
  filter->Print(text);
  for (const char* name :
    { "Tolerance: ", "FollowBounds: ", "ToleranceArrayName: ", "TightBounds: ", "RelativeGap: ",
      "MeasureBoundaries: ", "MeasureMeans: ", "MeasureSurfaces: ", "MeanPrecision: ",
      "NumberOfThreads: ", "SignedDistanceArrayName: ", "SideArrayName: ", "Status: " })
  {
    EXPECT_NE(text.str().find(name), std::string::npos) << name;
  }
}

TEST(SurfaceDistanceFilter, KeepsTheArraysOfItsInputs)
{
  const vtkSmartPointer<vtkPolyData> plate = Plate(0.0);
  AddTolerance(plate, 0.3);
  plate->GetPointData()->SetActiveScalars("tolerance");
  DistanceRun run(plate, Plate(0.25));
  run->Update();
  vtkPointData* data = run->GetOutput(0)->GetPointData();
  EXPECT_TRUE(data->HasArray("tolerance"));
  EXPECT_EQ(data->GetScalars(), data->GetArray("SignedDistance"));
}
