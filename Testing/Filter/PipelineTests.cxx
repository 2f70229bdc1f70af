// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BruteForce.h"
#include "FilterRun.h"
#include "Shapes.h"
#include "VtkSurfaces.h"

#include "vtkBoneDiagnostics.h"
#include "vtkBoneErrorSearch.h"
#include "vtkBoneSurfaceDistance.h"
#include "vtkFeatureEdges.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
vtkSmartPointer<vtkMultiBlockDataSet> TwoBones()
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetBlock(0, Bumps(3));
  blocks->SetBlock(2, PolyData(HeightField(16, 1.0, 3)));
  return blocks;
}

vtkMultiBlockDataSet* Blocks(FilterRun& run, int port)
{
  run->Update(port);
  return vtkMultiBlockDataSet::SafeDownCast(run->GetOutputDataObject(port));
}

/// Fails when VTK requests information, or data.
class Unreliable : public vtkPolyDataAlgorithm
{
public:
  static Unreliable* New();
  vtkTypeMacro(Unreliable, vtkPolyDataAlgorithm);

  void FailAt(const std::string& request)
  {
    this->Request = request;
    this->Modified();
  }

protected:
  Unreliable() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override
  {
    return this->Request == "information" ? 0 : 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    const bool fails = this->Request == "data";
    if (!fails)
    {
      vtkPolyData::GetData(outputs)->ShallowCopy(Bumps(3));
    }
    return fails ? 0 : 1;
  }

private:
  std::string Request;
};
vtkStandardNewMacro(Unreliable);

constexpr unsigned long InputFailed = vtkBoneAlgorithm::INPUT_FAILED;

struct WarningsOff
{
  WarningsOff() { vtkObject::GlobalWarningDisplayOff(); }
  ~WarningsOff() { vtkObject::SetGlobalWarningDisplay(this->Before); }

  const int Before = vtkObject::GetGlobalWarningDisplay();
};
}

TEST(Pipeline, HasNoProofAfterAnAlgorithmBeforeTheFilterFailed)
{
  vtkNew<Unreliable> source;
  vtkNew<vtkBoneDecimate> decimate;
  decimate->SetInputConnection(source->GetOutputPort());
  decimate->SetMaximumError(0.2);
  const WarningsOff off; // VTK reports the failure
  for (const char* request : { "information", "", "data", "" })
  {
    source->FailAt(request);
    decimate->Update();
    const bool hasFailed = *request != '\0';
    EXPECT_EQ(decimate->GetErrorCode(), hasFailed ? InputFailed : 0UL) << request;
    EXPECT_EQ(decimate->GetProofStatusAsString(), hasFailed ? "no_proof" : "proved");
    EXPECT_EQ(std::isnan(decimate->GetProvedError()), hasFailed);
    EXPECT_EQ(std::isnan(decimate->GetReportValue("proof.upper")), hasFailed);
  }
}

TEST(Pipeline, HasNoCertificateAfterAnAlgorithmBeforeTheFilterFailed)
{
  vtkNew<Unreliable> source;
  vtkNew<vtkBoneSurfaceDistance> distance;
  distance->SetInputConnection(0, source->GetOutputPort());
  distance->SetInputData(1, Bumps(3));
  distance->SetTolerance(0.2);
  const WarningsOff off;
  for (const char* request : { "information", "", "data", "" })
  {
    source->FailAt(request);
    distance->Update();
    const bool hasFailed = *request != '\0';
    EXPECT_EQ(distance->GetErrorCode(), hasFailed ? InputFailed : 0UL) << request;
    EXPECT_EQ(distance->GetStatus() == vtkBoneSurfaceDistance::PROVED, !hasFailed);
    EXPECT_EQ(std::isnan(distance->GetUpperBound()), hasFailed);
  }
}

TEST(Pipeline, HasNoReportOfTheInputInAnOutputThatFailed)
{
  FilterRun first(Bumps(3));
  first->SetMaximumError(0.2);
  FilterRun run(first.Output());
  run->SetLabelArrayName("Nothing");
  EXPECT_EQ(run.Output()->GetFieldData()->GetNumberOfArrays(), 0);
}

TEST(Pipeline, DoesNotRunAgainWithoutAChange)
{
  FilterRun run(Bumps(3));
  run.Output();
  run.Output();
  run.InputCopy();
  run->SetNormalTolerance(run->GetNormalTolerance());
  run.Output();
  EXPECT_EQ(run.Executions, 1);
}

TEST(Pipeline, RunsAgainAfterAChangeOfAProperty)
{
  FilterRun run(Bumps(3));
  run->SetTargetReduction(0.5);
  EXPECT_EQ(run.Triangles(), 640);
  run->SetTargetReduction(0.75);
  EXPECT_EQ(run.Triangles(), 320);
  EXPECT_EQ(run.Executions, 2);
}

TEST(Pipeline, RunsAgainAfterAChangeOfTheInput)
{
  const vtkSmartPointer<vtkPolyData> input = Bumps(3);
  FilterRun run(input);
  const std::vector<Vector3> before = SurfaceOf(run.Output()).Points;
  input->GetPoints()->SetPoint(0, 0.0, 0.0, 30.0);
  input->GetPoints()->Modified();
  EXPECT_NE(SurfaceOf(run.Output()).Points, before);
  EXPECT_EQ(run.Executions, 2);
}

TEST(Pipeline, RespondsToASourceBeforeItAndAFilterBehindIt)
{
  vtkNew<vtkSphereSource> source;
  FilterRun run(nullptr);
  run->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputConnection(run->GetOutputPort());
  edges->FeatureEdgesOff();
  edges->Update();
  EXPECT_EQ(edges->GetOutput()->GetNumberOfCells(), 0);
  source->SetThetaResolution(64);
  edges->Update();
  EXPECT_EQ(run.Executions, 2);
}

TEST(Pipeline, LeavesTheInputAsItWas)
{
  const vtkSmartPointer<vtkPolyData> input = Bumps(3);
  const Surface before = SurfaceOf(input);
  const vtkMTimeType time = input->GetMTime();
  FilterRun run(input);
  run->MeasureInputDistancesOn();
  run.Output();
  EXPECT_TRUE(SameBytes(SurfaceOf(input), before));
  EXPECT_EQ(input->GetMTime(), time);
  EXPECT_EQ(input->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(input->GetFieldData()->GetNumberOfArrays(), 0);
}

TEST(Pipeline, TakesItsOwnOutputAgain)
{
  FilterRun first(Bumps(4));
  FilterRun second(first.Output());
  EXPECT_EQ(second.Triangles(), 50); // a tenth of 512 is 51, and collapses remove two
  EXPECT_EQ(second.Output()->GetFieldData()->GetNumberOfArrays(),
    first.Output()->GetFieldData()->GetNumberOfArrays());
  EXPECT_TRUE(second.SaidNothing()) << second.AllMessages();
}

TEST(Composite, EachBlockIsDecimatedByItself)
{
  const vtkSmartPointer<vtkMultiBlockDataSet> input = TwoBones();
  FilterRun run(input);
  vtkMultiBlockDataSet* output = Blocks(run, 0);
  ASSERT_NE(output, nullptr);
  ASSERT_EQ(output->GetNumberOfBlocks(), 3U);
  EXPECT_EQ(output->GetBlock(1), nullptr);
  for (const unsigned int block : { 0U, 2U })
  {
    FilterRun alone(input->GetBlock(block));
    auto* together = vtkPolyData::SafeDownCast(output->GetBlock(block));
    ASSERT_NE(together, nullptr);
    EXPECT_TRUE(SameBytes(SurfaceOf(together), SurfaceOf(alone.Output()))) << "block " << block;
    EXPECT_EQ(Values(together, "Distance"), Values(alone.Output(), "Distance"));
  }
}

TEST(Composite, EachBlockHasItsOwnReport)
{
  FilterRun run(TwoBones());
  vtkMultiBlockDataSet* output = Blocks(run, 0);
  for (const unsigned int block : { 0U, 2U })
  {
    auto* polyData = vtkPolyData::SafeDownCast(output->GetBlock(block));
    vtkDataArray* faces = polyData->GetFieldData()->GetArray("bonedecimate.output.triangles");
    ASSERT_NE(faces, nullptr);
    EXPECT_EQ(faces->GetComponent(0, 0), polyData->GetNumberOfPolys());
  }
}

TEST(Composite, SecondPortHasTheDistancesOfEachBlock)
{
  FilterRun run(TwoBones());
  run->MeasureInputDistancesOn();
  vtkMultiBlockDataSet* copies = Blocks(run, 1);
  ASSERT_NE(copies, nullptr);
  for (const unsigned int block : { 0U, 2U })
  {
    auto* copy = vtkPolyData::SafeDownCast(copies->GetBlock(block));
    ASSERT_NE(copy, nullptr);
    auto* result = vtkPolyData::SafeDownCast(Blocks(run, 0)->GetBlock(block));
    const std::vector<double> distances = Values(copy, "DistanceToResult");
    const std::vector<double> expected = LocatorDistances(copy, result);
    ASSERT_EQ(distances.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      ASSERT_NEAR(distances[i], expected[i], 1e-5) << "block " << block << " point " << i;
    }
  }
}

TEST(Pipeline, DiagnosticsAreUsableOnlyOfASurfaceThatWasSeen)
{
  vtkNew<Unreliable> source;
  vtkNew<vtkBoneDiagnostics> diagnostics;
  diagnostics->SetInputConnection(source->GetOutputPort());
  EXPECT_FALSE(diagnostics->IsUsable());
  const WarningsOff off;
  for (const char* request : { "", "information", "", "data", "" })
  {
    source->FailAt(request);
    diagnostics->Update();
    EXPECT_EQ(diagnostics->IsUsable(), *request == '\0') << request;
  }
}

TEST(Pipeline, HasNoErrorOfASearchAfterAnAlgorithmBeforeItFailed)
{
  vtkNew<Unreliable> source;
  vtkNew<vtkBoneErrorSearch> search;
  search->SetInputConnection(source->GetOutputPort());
  search->SetTargetNumberOfTriangles(300);
  const WarningsOff off;
  for (const char* request : { "", "information", "", "data" })
  {
    source->FailAt(request);
    search->Update();
    const bool hasFailed = *request != '\0';
    EXPECT_EQ(std::isnan(search->GetSmallestError()), hasFailed) << request;
    EXPECT_EQ(search->GetErrorTriedInVain() > 0.0, !hasFailed) << request;
  }
}
