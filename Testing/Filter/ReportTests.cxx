// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BruteForce.h"
#include "FilterRun.h"
#include "Options/OptionTable.h"
#include "Run/Report/ProofSentence.h"
#include "Run/Report/ReportFigures.h"
#include "Shapes.h"
#include "VtkSurfaces.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkMassProperties.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// A closed piece, one with a boundary and one with edges of three triangles.
Surface Mixture()
{
  Surface mixture =
    Together(BumpySphere(3, 10.0, 0.05, 1), Moved(HoledPlate(9), { 50.0, 0.0, 0.0 }));
  return Together(mixture, Moved(ThreeLeavedBook(4), { 0.0, 50.0, 0.0 }));
}

void ExpectCounts(FilterRun& run, const std::string& side, vtkPolyData* polyData)
{
  const VtkCounts counts = CountWithVtk(polyData);
  EXPECT_EQ(run.Value(side + ".triangles"), polyData->GetNumberOfPolys());
  EXPECT_EQ(run.Value(side + ".points"), polyData->GetNumberOfPoints());
  EXPECT_EQ(run.Value(side + ".components"), counts.Components);
  EXPECT_EQ(run.Value(side + ".boundary_edges"), counts.BoundaryEdges);
  EXPECT_EQ(run.Value(side + ".non_manifold_edges"), counts.NonManifoldEdges);
  EXPECT_EQ(run.Value(side + ".euler_number"), CountTopology(SurfaceOf(polyData)).EulerNumber);
  EXPECT_NEAR(run.Value(side + ".area"), TotalArea(SurfaceOf(polyData)), 1e-6);
}

void ExpectAreaAndVolume(FilterRun& run, const std::string& side, vtkPolyData* polyData)
{
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(polyData);
  EXPECT_NEAR(run.Value(side + ".area"), mass->GetSurfaceArea(), 1e-6 * mass->GetSurfaceArea());
  EXPECT_NEAR(run.Value(side + ".volume"), mass->GetVolume(), 1e-4 * mass->GetVolume());
}

std::string NameOf(FilterRun& run, int entry)
{
  return run->GetReportEntryName(entry);
}
}

TEST(Report, CountsBothSurfacesLikeVtk)
{
  const vtkSmartPointer<vtkPolyData> input = PolyData(Mixture());
  FilterRun run(input);
  vtkPolyData* output = run.Output();
  ExpectCounts(run, "input", input);
  ExpectCounts(run, "output", output);
  EXPECT_LT(output->GetNumberOfPolys(), input->GetNumberOfPolys());
}

TEST(Report, MeasuresAreaAndVolumeOfAClosedSphereLikeVtk)
{
  const vtkSmartPointer<vtkPolyData> input = Sphere(4);
  FilterRun run(input);
  vtkPolyData* output = run.Output();
  ExpectAreaAndVolume(run, "input", input);
  ExpectAreaAndVolume(run, "output", output);
}

TEST(Report, GivesTheVolumeOfASurfaceTurnedInsideOutItsSign)
{
  FilterRun run(PolyData(TurnedInsideOut(Icosphere(3, 10.0))));
  EXPECT_LT(run.Value("input.volume"), 0.0);
  EXPECT_LT(run.Value("output.volume"), 0.0);
}

TEST(Report, IsOneTextInTheFieldDataBesideTheKeyFigures)
{
  FilterRun run(Bumps(3));
  run->MeasureDistancesOn();
  run->SetMaximumError(0.5);
  vtkFieldData* fieldData = run.Output()->GetFieldData();
  auto* report = vtkStringArray::SafeDownCast(fieldData->GetAbstractArray("BoneDecimateReport"));
  ASSERT_NE(report, nullptr);
  ASSERT_EQ(report->GetNumberOfValues(), 1);
  const std::string json = report->GetValue(0);
  EXPECT_NE(json.find("\"proof\": {\"if_unchanged\": {\"status\": \"proved\""), std::string::npos);
  EXPECT_EQ(run->GetReportAsJson().find("if_unchanged"), std::string::npos);
  EXPECT_EQ(fieldData->GetNumberOfArrays(), static_cast<int>(1 + KeyFigures().size()));
  for (const std::string& name : KeyFigures())
  {
    vtkAbstractArray* array = fieldData->GetAbstractArray(("bonedecimate." + name).c_str());
    ASSERT_NE(array, nullptr) << name;
    EXPECT_EQ(array->GetNumberOfTuples(), 1) << name;
    const char* unit = array->GetComponentName(0);
    const std::string plain = std::regex_replace(name, std::regex("if_unchanged\\."), "");
    EXPECT_EQ(unit ? unit : "", run->GetReportEntryUnit(plain)) << name;
    const std::string text = run->GetReportText(plain);
    EXPECT_EQ(array->GetVariantValue(0).ToString(),
      vtkVariant(vtkStringArray::SafeDownCast(array)
          ? vtkVariant((name == "proof.sentence" ? SentenceBoundToSurface(text) : text).c_str())
          : vtkDoubleArray::SafeDownCast(array)
          ? vtkVariant(run->GetReportValue(plain))
          : vtkVariant(static_cast<long long>(run->GetReportValue(plain))))
        .ToString())
      << name;
  }
}

TEST(Report, ProvesNothingOfAChangedSurface)
{
  FilterRun run(Bumps(3));
  run->SetMaximumError(0.5);
  vtkPolyData* const proved = run.Output();
  EXPECT_TRUE(vtkBoneDecimate::HasReportOfItself(proved));
  vtkNew<vtkPolyData> changed;
  changed->DeepCopy(proved);
  EXPECT_TRUE(vtkBoneDecimate::HasReportOfItself(changed));
  double position[3];
  changed->GetPoint(0, position);
  changed->GetPoints()->SetPoint(0, std::nextafter(position[0], 1e3), position[1], position[2]);
  EXPECT_FALSE(vtkBoneDecimate::HasReportOfItself(changed)) << "one bit of one coordinate";
  changed->DeepCopy(proved);
  changed->ReverseCell(0);
  EXPECT_FALSE(vtkBoneDecimate::HasReportOfItself(changed)) << "a triangle turned over";
  changed->DeepCopy(proved);
  changed->GetPolys()->InsertNextCell({ 0, 1, 2 });
  EXPECT_FALSE(vtkBoneDecimate::HasReportOfItself(changed)) << "a triangle more";
  EXPECT_FALSE(vtkBoneDecimate::HasReportOfItself(Bumps(3))) << "no report";
}

TEST(Report, ProvesTheSameTrianglesInAnotherOrder)
{
  FilterRun run(Bumps(3));
  run->SetMaximumError(0.5);
  vtkPolyData* const proved = run.Output();
  Surface surface = SurfaceOf(proved);
  std::reverse(surface.Triangles.begin(), surface.Triangles.end());
  for (Triangle& triangle : surface.Triangles)
  {
    std::rotate(triangle.begin(), triangle.begin() + 1, triangle.end());
  }
  const vtkSmartPointer<vtkPolyData> other = PolyData(surface);
  other->SetFieldData(proved->GetFieldData());
  EXPECT_TRUE(vtkBoneDecimate::HasReportOfItself(other));
}

TEST(Report, OfAnEarlierRunIsReplaced)
{
  FilterRun first(Bumps(3));
  first->SetMaximumError(0.5);
  FilterRun second(first.Output());
  vtkFieldData* fieldData = second.Output()->GetFieldData();
  auto* report = vtkStringArray::SafeDownCast(fieldData->GetAbstractArray("BoneDecimateReport"));
  ASSERT_NE(report, nullptr);
  EXPECT_NE(second->GetReportText("output.checksum"), first->GetReportText("output.checksum"));
  EXPECT_NE(std::string(report->GetValue(0)).find(second->GetReportText("output.checksum")),
    std::string::npos);
  EXPECT_EQ(fieldData->GetAbstractArray("bonedecimate.proof.if_unchanged.upper"), nullptr);
}

TEST(Report, GettersHaveItsMainFigures)
{
  FilterRun run(Bumps(3));
  run->MeasureDistancesOn();
  EXPECT_TRUE(std::isnan(run->GetProvedError()));
  EXPECT_TRUE(std::isnan(run->GetMeasuredError()));
  EXPECT_EQ(run->GetProofStatus(), vtkBoneDecimate::NO_PROOF);
  EXPECT_EQ(run->GetProofStatusAsString(), "no_proof");
  EXPECT_EQ(run->GetNumberOfInputTriangles() + run->GetNumberOfOutputTriangles(), 0);
  run->SetMaximumError(0.5);
  const vtkIdType triangles = run.Output()->GetNumberOfPolys();
  EXPECT_EQ(run->GetProvedError(), run.Value("proof.upper"));
  EXPECT_LE(run->GetMeasuredError(), run->GetProvedError());
  EXPECT_EQ(run->GetProofStatus(), vtkBoneDecimate::PROVED);
  EXPECT_EQ(run->GetProofStatusAsString(), "proved");
  EXPECT_EQ(run->GetNumberOfInputTriangles(), 1280);
  EXPECT_EQ(run->GetNumberOfOutputTriangles(), triangles);
  double sum = 0.0;
  for (std::size_t i = 1; i < NumberOfRejections; ++i)
  {
    const std::string reason = RejectionWord(static_cast<Rejection>(i));
    EXPECT_EQ(run->GetNumberOfRejectedEdits(reason), run.Value("rejections." + reason)) << reason;
    sum += run.Value("rejections." + reason);
  }
  EXPECT_EQ(run->GetNumberOfRejectedEdits(), sum);
  EXPECT_EQ(run->GetNumberOfRejectedEdits("no such reason"), 0);
}

TEST(Report, HasEachEntryOnce)
{
  FilterRun run(Bumps(2));
  run->MeasureDistancesOn();
  run.Output();
  std::set<std::string> names;
  for (int i = 0; i < run->GetNumberOfReportEntries(); ++i)
  {
    EXPECT_TRUE(names.insert(NameOf(run, i)).second) << NameOf(run, i);
  }
  EXPECT_FALSE(names.empty());
}

TEST(Report, KnowsUnitsOfLengthsAreasVolumesAndTimes)
{
  FilterRun run(Bumps(2));
  run->MeasureDistancesOn();
  run.Output();
  EXPECT_EQ(run->GetReportEntryUnit("running_error"), "mm");
  EXPECT_EQ(run->GetReportEntryUnit("distance.output_to_input.mean"), "mm");
  EXPECT_EQ(run->GetReportEntryUnit("input.area"), "mm2");
  EXPECT_EQ(run->GetReportEntryUnit("output.volume"), "mm3");
  EXPECT_EQ(run->GetReportEntryUnit("seconds.total"), "s");
  EXPECT_EQ(run->GetReportEntryUnit("options.MaximumError"), "mm");
  EXPECT_EQ(run->GetReportEntryUnit("input.triangles"), "");
}

TEST(Report, ReturnsNothingForUnknownNamesAndNumbers)
{
  FilterRun run(Bumps(2));
  run.Output();
  EXPECT_TRUE(std::isnan(run->GetReportValue("no such entry")));
  EXPECT_EQ(run->GetReportText("no such entry"), "");
  EXPECT_EQ(run->GetReportEntryUnit("no such entry"), "");
  EXPECT_EQ(NameOf(run, -1), "");
  EXPECT_EQ(NameOf(run, run->GetNumberOfReportEntries()), "");
}

TEST(Report, KeepsTheOptionsOfTheRunThatItReportsOn)
{
  FilterRun run(Bumps(2));
  run->SetTargetReduction(0.25);
  run->SetNormalTolerance(0.5);
  run.Output();
  run->SetNormalTolerance(0.75);
  EXPECT_EQ(run->GetReportText("options.NormalTolerance"), "0.5");
  EXPECT_EQ(run->GetReportText("options.TargetReduction"), "0.25");
  std::set<std::string> names;
  for (int i = 0; i < run->GetNumberOfReportEntries(); ++i)
  {
    names.insert(run->GetReportEntryName(i));
  }
  for (const OptionInfo& info : OptionTable())
  {
    EXPECT_EQ(names.count("options." + info.Name), 1U) << info.Name;
  }
}

TEST(Report, NamesTheVersionAndTheReasonOfTheStop)
{
  FilterRun run(Bumps(2));
  run.Output();
  EXPECT_TRUE(
    std::regex_match(run->GetReportText("version"), std::regex("[0-9]+\\.[0-9]+\\.[0-9]+")));
  EXPECT_EQ(run->GetReportText("stop_reason"), "target_reached");
  EXPECT_EQ(run->GetReportText("stop_sentence"), run->GetStopReasonAsString());
}

TEST(Report, ChecksumTellsInputsApart)
{
  FilterRun one(Bumps(2));
  FilterRun same(Bumps(2));
  Surface nudged = SurfaceOf(Bumps(2));
  nudged.Points[7][1] = std::nextafter(nudged.Points[7][1], 1000.0);
  FilterRun other(PolyData(nudged));
  one.Output();
  same.Output();
  other.Output();
  EXPECT_EQ(one->GetReportText("input.checksum"), same->GetReportText("input.checksum"));
  EXPECT_NE(one->GetReportText("input.checksum"), other->GetReportText("input.checksum"));
}

TEST(Report, CountsCollapsesOfTwoTrianglesOnAClosedSurface)
{
  FilterRun run(Bumps(3));
  EXPECT_EQ(2 * run.Value("collapses"), 1280 - run.Triangles());
}

TEST(Report, CountsRejectionsByTheirReason)
{
  FilterRun run(PolyData(HoledPlate(9)));
  run->SetTargetNumberOfTriangles(1);
  EXPECT_GT(run.Value("rejections.link_condition") + run.Value("rejections.boundary"), 0);
  EXPECT_EQ(run.Value("rejections.non_manifold"), 0);
}

TEST(Report, SecondsAreThereAndTheStagesDoNotExceedTheWhole)
{
  FilterRun run(Bumps(3));
  run->MeasureDistancesOn();
  const double total = run.Value("seconds.total");
  EXPECT_GT(run.Value("seconds.decimate"), 0.0);
  EXPECT_GT(run.Value("seconds.measure"), 0.0);
  EXPECT_LE(run.Value("seconds.decimate") + run.Value("seconds.measure"), total);
  EXPECT_LE(run.Value("seconds.prepare") + run.Value("seconds.collapse"),
    run.Value("seconds.decimate") * (1 + 1e-9));
}

TEST(Report, IsReadableBeforeAnyRun)
{
  vtkNew<vtkBoneDecimate> filter;
  EXPECT_EQ(filter->GetReportText("stop_reason"), "not_run");
  EXPECT_EQ(filter->GetReportValue("input.triangles"), 0);
}
