// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Run/Decimate.h"
#include "Run/Levels.h"
#include "Run/Report/ReportTable.h"
#include "Runs.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
constexpr double Side = 2.0; // mm, of the small cube

/// A sphere, a cube of 12 triangles beside it and one open triangle above both.
Surface BoneWithCrumbs()
{
  return Together(Icosphere(2, 10.0),
    Together(Moved(Scaled(Cube(1), Side), { 30.0, 0.0, 0.0 }),
      Moved(SingleTriangle(), { 0.0, 0.0, 40.0 })));
}

Options Pruning(double size, double area, double volume, int triangles)
{
  Options options = InMode(Mode::Fast, Reduction(0.5));
  options.PruneSize = size;
  options.PruneArea = area;
  options.PruneVolume = volume;
  options.PruneTriangles = triangles;
  return options;
}

std::size_t PrunedBy(const Options& options)
{
  return Decimate(BoneWithCrumbs(), options).Report.Pruned.Components.size();
}

std::string EntryText(const Report& report, const std::string& name)
{
  for (const ReportEntry& entry : ReportEntries(report))
  {
    if (entry.Name == name)
    {
      const auto* number = std::get_if<double>(&entry.Value);
      return number ? std::to_string(*number) : "there";
    }
  }
  return "missing";
}
}

TEST(Prune, RemovesNothingByDefault)
{
  for (const Mode mode : AllModes())
  {
    const Report report = Decimate(BoneWithCrumbs(), InMode(mode, Reduction(0.9))).Report;
    EXPECT_FALSE(report.Pruned.IsRequested);
    EXPECT_EQ(report.Output.Components, 3) << WordOf(mode);
    EXPECT_EQ(EntryText(report, "pruned.components"), "missing");
  }
}

TEST(Prune, EachLimitRemovesSmallerComponentsOnly)
{
  const double above = std::nextafter(Side, 3.0);
  EXPECT_EQ(PrunedBy(Pruning(Side, 0, 0, 0)), 1U); // the triangle alone: its sides are 1 mm
  EXPECT_EQ(PrunedBy(Pruning(above, 0, 0, 0)), 2U);
  EXPECT_EQ(PrunedBy(Pruning(0, 6 * Side * Side, 0, 0)), 1U);
  EXPECT_EQ(PrunedBy(Pruning(0, 6 * Side * Side + 1e-9, 0, 0)), 2U);
  EXPECT_EQ(PrunedBy(Pruning(0, 0, 0, 12)), 1U);
  EXPECT_EQ(PrunedBy(Pruning(0, 0, 0, 13)), 2U);
}

TEST(Prune, OnlyClosedComponentsHaveAVolumeWhateverTheirOrientation)
{
  EXPECT_EQ(PrunedBy(Pruning(0, 0, Side * Side * Side - 1e-9, 0)), 0U);
  EXPECT_EQ(PrunedBy(Pruning(0, 0, Side * Side * Side + 1e-9, 0)), 1U); // not the open triangle
  const Surface inside = TurnedInsideOut(BoneWithCrumbs());
  const Report report = Decimate(inside, Pruning(0, 0, 100.0, 0)).Report;
  EXPECT_EQ(report.Pruned.Components.size(), 1U);
}

TEST(Prune, ListsRemovedComponentsLargestFirst)
{
  const Report report = Decimate(BoneWithCrumbs(), Pruning(5.0, 0, 0, 0)).Report;
  const PruneFigures& pruned = report.Pruned;
  ASSERT_EQ(pruned.Components.size(), 2U);
  EXPECT_EQ(pruned.Triangles, 13);
  const PrunedComponent& cube = pruned.Components[0];
  EXPECT_EQ(cube.Triangles, 12);
  EXPECT_DOUBLE_EQ(cube.Size, Side);
  EXPECT_DOUBLE_EQ(cube.Area, 6 * Side * Side);
  EXPECT_NEAR(cube.Volume, Side * Side * Side, 1e-12);
  EXPECT_NEAR(
    (cube.Center - Vector3(30.0 + 0.5 * Side, 0.5 * Side, 0.5 * Side)).norm(), 0.0, 1e-12);
  EXPECT_TRUE(std::isnan(pruned.Components[1].Volume));
  EXPECT_EQ(EntryText(report, "pruned.list.0.size"), std::to_string(Side));
  EXPECT_EQ(EntryText(report, "pruned.list.1.area"), std::to_string(0.5));
  EXPECT_EQ(EntryText(report, "pruned.list.1.volume"), "missing");
  EXPECT_EQ(report.Input.Components, 1);
}

TEST(Prune, GivesTheBytesOfARunWithoutTheSmallComponents)
{
  Surface alone = BoneWithCrumbs();
  alone.Triangles.resize(alone.Triangles.size() - 13);
  for (const Mode mode : AllModes())
  {
    const Options options = InMode(mode, Pruning(5.0, 0, 0, 0));
    EXPECT_TRUE(SameBytes(Decimate(BoneWithCrumbs(), options).Surface,
      Decimate(alone, InMode(mode, Reduction(0.5))).Surface))
      << WordOf(mode);
  }
}

TEST(Prune, ProvesTheRemainingComponents)
{
  Options options = Pruning(5.0, 0, 0, 0);
  options.MaximumError = 0.3;
  options.MeasureInputDistances = true;
  const Surface input = BoneWithCrumbs();
  const Result result = Decimate(input, options);
  EXPECT_STREQ(EntryText(result.Report, "proof.status").c_str(), "there");
  EXPECT_LE(result.Report.Proof.Upper(), options.MaximumError);
  EXPECT_GT(result.InputDistance.back(), 20.0); // the heat map shows what went
  EXPECT_TRUE(std::isnan(result.InputErrorBound.back()));
}

TEST(Prune, PointsOfRemovedComponentsMapToNone)
{
  const Surface input = BoneWithCrumbs();
  const Result result = Decimate(input, Pruning(5.0, 0, 0, 0), {}, { false, true });
  const std::vector<Index>& map = result.Origins.OutputPoint;
  ASSERT_EQ(map.size(), input.Points.size());
  EXPECT_TRUE(std::all_of(map.end() - 11, map.end(), [](Index point) { return point == None; }));
  EXPECT_TRUE(std::none_of(map.begin(), map.end() - 11, [](Index point) { return point == None; }));
  for (const Index triangle : result.Origins.NearestTriangle)
  {
    EXPECT_LT(triangle, static_cast<Index>(input.Triangles.size()) - 13);
  }
}

TEST(Prune, RemovingEverythingIsRejectedWithTheCount)
{
  const Result result = Decimate(BoneWithCrumbs(), Pruning(1000.0, 0, 0, 0));
  EXPECT_EQ(result.Report.Status, InputStatus::EverythingPruned);
  EXPECT_NE(InputMessage(result.Report).find("each of the 3 components"), std::string::npos);
  EXPECT_TRUE(result.Surface.Triangles.empty());
}

TEST(Prune, AcceptsNonManifoldInputAndGivesTheSameBytesForAnyNumberOfThreads)
{
  for (const NamedSurface& shape : AllShapes())
  {
    const Surface input = Together(shape.Surface, Moved(Envelope(), { 500.0, 0.0, 0.0 }));
    Options options = Pruning(0, 0, 0, 3);
    const Report report = Decimate(input, options).Report;
    EXPECT_GE(report.Pruned.Components.size(), 1U) << shape.Name;
  }
  ExpectTheSameBytesForAnyNumberOfThreads(BoneWithCrumbs(), Pruning(5.0, 0, 0, 0));
}

TEST(Prune, LevelsAreOfAllComponents)
{
  Levels levels;
  const Result run = RecordLevels(BoneWithCrumbs(), Pruning(5.0, 0, 0, 0), {}, {}, levels);
  EXPECT_EQ(run.Report.Output.Components, 3);
  EXPECT_GT(levels.NumberOfCollapses(), 0);
}

TEST(DiagnosticRun, OfTheInputIsInTheReportOnRequestAlone)
{
  const Surface input = Together(Grid(3), Moved(Cube(1), { 10.0, 0.0, 0.0 }));
  EXPECT_TRUE(Decimate(input, Reduction(0.5)).Report.Diagnostics.empty());
  Options options = Reduction(0.5);
  options.DiagnoseInput = true;
  const Report report = Decimate(input, options).Report;
  const std::vector<Diagnostic> expected = Diagnose(input);
  ASSERT_EQ(report.Diagnostics.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_EQ(report.Diagnostics[i].Kind, expected[i].Kind);
    EXPECT_EQ(report.Diagnostics[i].Count, expected[i].Count);
    EXPECT_EQ(report.Diagnostics[i].First, expected[i].First);
    EXPECT_EQ(EntryText(report, "diagnostics." + std::to_string(i) + ".kind"), "there");
  }
  EXPECT_EQ(EntryText(report, "diagnostics.0.first_triangles.0"), "there"); // the open boundary
}

TEST(DiagnosticRun, IsInTheReportOfARejectedInput)
{
  Surface input = Cube(1);
  input.Points[3][0] = std::nan("");
  Options options = Reduction(0.5);
  options.DiagnoseInput = true;
  const Report report = Decimate(input, options).Report;
  EXPECT_EQ(report.Status, InputStatus::NonFinitePoints);
  ASSERT_EQ(report.Diagnostics.size(), 1U);
  EXPECT_EQ(report.Diagnostics[0].Kind, DiagnosticKind::NonFinitePoints);
  EXPECT_EQ(report.Diagnostics[0].First, std::vector<Index>{ 3 });
}
