// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BruteForce.h"
#include "FilterRun.h"
#include "Shapes.h"
#include "VtkSurfaces.h"
#include "vtkDoubleArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// Closed fragments, one of them bumpy and large.
Surface Fragments()
{
  return Together(BumpySphere(4, 10.0, 0.05, 2), Moved(ManyComponents(6), { 40.0, 0.0, 0.0 }));
}

class AbortAt : public testing::TestWithParam<double>
{
};

std::string PercentOf(const testing::TestParamInfo<double>& info)
{
  return std::to_string(static_cast<int>(info.param * 1000)) + "PerMille";
}
}

TEST_P(AbortAt, LeavesAValidSurfaceAndSaysSo)
{
  const Surface input = Fragments();
  FilterRun run(PolyData(input));
  run->MeasureDistancesOn();
  run.AbortAt(GetParam());
  vtkPolyData* output = run.Output();
  EXPECT_EQ(run->GetStopReason(), vtkBoneDecimate::ABORTED);
  EXPECT_EQ(run->GetReportText("stop_reason"), "aborted");
  EXPECT_EQ(WhatIsWrongWith(output), "");
  const Topology before = CountTopology(input);
  const Topology after = CountTopology(SurfaceOf(output));
  EXPECT_EQ(after.Components, before.Components);
  EXPECT_EQ(after.BoundaryEdges, 0);
  EXPECT_EQ(after.NonManifoldEdges, 0);
  EXPECT_EQ(after.EulerNumber, before.EulerNumber);
  EXPECT_GT(after.Faces, 0);
  EXPECT_TRUE(run.SaidNothing()) << run.AllMessages();
}

TEST_P(AbortAt, LeavesArraysAndReportThatFitTheSurface)
{
  const vtkSmartPointer<vtkPolyData> input = PolyData(Fragments());
  FilterRun run(input);
  run->MeasureDistancesOn();
  run.AbortAt(GetParam());
  vtkPolyData* output = run.Output();
  const std::vector<double> distances = Values(output, "Distance");
  EXPECT_EQ(distances.empty(), GetParam() < 0.7) << "distances are skipped after an abort";
  const std::vector<double> expected =
    distances.empty() ? distances : LocatorDistances(output, input);
  ASSERT_EQ(distances.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    ASSERT_NEAR(distances[i], expected[i], 1e-5) << "point " << i;
  }
  EXPECT_EQ(Sum(Values(output, "InputPointCount")), input->GetNumberOfPoints());
  EXPECT_EQ(run->GetReportValue("input.triangles"), input->GetNumberOfPolys());
  EXPECT_EQ(run->GetReportValue("output.triangles"), output->GetNumberOfPolys());
}

TEST_P(AbortAt, IsHeardAtOnce)
{
  FilterRun run(PolyData(Fragments()));
  run->MeasureDistancesOn();
  run.AbortAt(GetParam());
  run.Output();
  const double fraction = GetParam();
  EXPECT_LE(std::count_if(run.Progress.begin(), run.Progress.end(),
              [&](double progress) { return progress >= fraction; }),
    2)
    << "the one that aborts, and at most the executive's own at the end";
}

INSTANTIATE_TEST_SUITE_P(
  Fractions, AbortAt, testing::Values(0.001, 0.015, 0.1, 0.35, 0.6, 0.75, 0.9), PercentOf);

TEST(Abort, TheLaterTheFewerTriangles)
{
  vtkIdType before = SurfaceOf(PolyData(Fragments())).Triangles.size();
  for (const double fraction : { 0.1, 0.3, 0.5 })
  {
    FilterRun run(PolyData(Fragments()));
    run->SetModeToThesis();
    run->MeasureDistancesOn();
    run.AbortAt(fraction);
    EXPECT_LT(run.Triangles(), before);
    before = run.Triangles();
  }
}

TEST(Abort, WhileMeasuringLeavesNoDistancesThatWereNotMeasured)
{
  FilterRun run(PolyData(Fragments()));
  run->MeasureInputDistancesOn();
  run->MeasureDistancesOn();
  run.AbortAt(0.8);
  EXPECT_TRUE(Values(run.InputCopy(), "DistanceToResult").empty());
  EXPECT_TRUE(std::isnan(run->GetReportValue("distance.output_to_input.max")));
}

TEST(Abort, WhileMeasuringTheInputLeavesNoHalfMeasuredArray)
{
  const vtkSmartPointer<vtkPolyData> input = Bumps(5); // several chunks of points
  FilterRun run(input);
  run->SetNumberOfThreads(1);
  run->MeasureInputDistancesOn();
  run.AbortAt(0.96);
  const std::vector<double> distances = Values(run.InputCopy(), "DistanceToResult");
  if (!distances.empty())
  {
    const std::vector<double> expected = LocatorDistances(input, run.Output());
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      ASSERT_NEAR(distances[i], expected[i], 1e-5) << "point " << i;
    }
  }
}

TEST(Abort, LeavesAProofStatusOfItsOwn)
{
  FilterRun aborted(Bumps(4));
  aborted->SetMaximumError(0.2);
  aborted.AbortAt(0.3);
  aborted.Output();
  EXPECT_EQ(aborted->GetProofStatus(), vtkBoneDecimate::PROOF_ABORTED);
  EXPECT_EQ(aborted->GetProofStatusAsString(), "aborted");
  EXPECT_EQ(aborted->GetReportText("proof.status"), "aborted");
  EXPECT_TRUE(std::isnan(aborted->GetProvedError()));
  FilterRun unlimited(Bumps(3));
  unlimited.AbortAt(0.3);
  unlimited.Output();
  EXPECT_EQ(unlimited->GetProofStatus(), vtkBoneDecimate::NO_PROOF);
}

TEST(Abort, OfRegionsLeavesAProofStatusOfItsOwn)
{
  const vtkSmartPointer<vtkPolyData> input = Bumps(5);
  vtkNew<vtkDoubleArray> tolerances;
  tolerances->SetName("Tolerance");
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    tolerances->InsertNextValue(input->GetPoint(i)[0] > 8.0 ? 0.2 : 0.0);
  }
  input->GetPointData()->AddArray(tolerances);
  FilterRun run(input);
  run->SetToleranceArrayName("Tolerance");
  run.AbortAt(0.5);
  run.Output();
  EXPECT_EQ(run->GetReportText("stop_reason"), "aborted");
  EXPECT_EQ(run->GetProofStatus(), vtkBoneDecimate::PROOF_ABORTED);
}

TEST(Abort, TheNextRunIsWholeAgain)
{
  FilterRun aborted(Bumps(3));
  aborted.AbortAt(0.3);
  aborted.Output();
  aborted.AbortAt(2.0);
  aborted->SetAbortExecute(0);
  aborted->Modified();
  FilterRun fresh(Bumps(3));
  EXPECT_TRUE(SameBytes(SurfaceOf(aborted.Output()), SurfaceOf(fresh.Output())));
  EXPECT_EQ(aborted->GetStopReason(), vtkBoneDecimate::TARGET_REACHED);
}
