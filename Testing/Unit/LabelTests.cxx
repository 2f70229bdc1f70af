// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Feature curves between labels are simplified along themselves, so neighbors stay matched; every
// triangle keeps its label.
#include "LabelMaps.h"
#include "LabeledSurfaces.h"
#include "Mesh/ManifoldPatches.h"
#include "Mesh/PatchBoundaries.h"
#include "NoisyBones.h"
#include "Run/Report/ReportTable.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

TEST(PatchBoundaries, AreTheEdgesBetweenPatches)
{
  const Surface ball = HalvedBall(6);
  CleanSurface clean = Clean(ball, true);
  SplitIntoManifoldPatches(clean);
  const HalfEdgeMesh mesh(clean.Surface, 1, clean.ManifoldPatches);
  const PatchBoundaries lines(mesh);
  EXPECT_EQ(lines.NumberOfEdges(), CountTopology(ball).NonManifoldEdges);
  Index rings = 0;
  for (Index index = 0; index < lines.NumberOfPositions(); ++index)
  {
    rings += lines.IsRemovable(index) ? 0 : 1;
    EXPECT_TRUE(
      !lines.IsRemovable(index) || IsInsidePatchBoundary(mesh, lines.OriginalVertex(index)));
  }
  EXPECT_EQ(rings, 2) << "one ring, which starts and ends at one original vertex";
}

TEST(PatchBoundaries, DeviationIsThatOfTheFarthestRemovedVertex)
{
  Surface book = ThreeLeavedBook(6); // its spine are points 0 to 6
  book.Points[2][0] += 0.25;
  CleanSurface clean = Clean(book, true);
  SplitIntoManifoldPatches(clean);
  const HalfEdgeMesh mesh(clean.Surface, 1, clean.ManifoldPatches);
  PatchBoundaries lines(mesh);
  const auto anything = [](Index) { return std::numeric_limits<double>::infinity(); };
  std::multiset<double> deviations;
  for (Index index = 0; index < lines.NumberOfPositions(); ++index)
  {
    if (lines.IsRemovable(index))
    {
      deviations.insert(std::round(1000.0 * lines.Deviation(mesh, index, anything)));
    }
  }
  EXPECT_EQ(deviations.size(), 5U);
  EXPECT_EQ(deviations.count(250.0), 1U);
  EXPECT_EQ(deviations.count(124.0), 2U) << "0.5 mm2 over a length of 2.0156 mm";
  EXPECT_EQ(deviations.count(0.0), 2U);
}

class LabelsInMode : public testing::TestWithParam<Mode>
{
};

TEST_P(LabelsInMode, FeatureCurvesAreCoarserAndMatched)
{
  const Surface input = Icosphere(4, 10.0);
  const Labels labels = ThreeParts(input);
  const Result result = RunWith(labels, input, InMode(GetParam(), Reduction(0.9)));
  const Topology after = CountTopology(result.Surface);
  EXPECT_EQ(result.Report.Stop, StopReason::TargetReached);
  EXPECT_EQ(after.EulerNumber, 2);
  EXPECT_EQ(after.BoundaryEdges + after.NonManifoldEdges + after.InconsistentEdges, 0);
  const std::vector<Segment> before = LinesOf(input, labels.OfTriangle);
  const std::vector<Segment> lines = LinesOf(result.Surface, LabelsAfter(labels, result));
  EXPECT_LT(lines.size(), before.size() / 2);
  EXPECT_GT(lines.size(), before.size() / 8);
  EXPECT_LT(MaxDistance(before, lines), 0.5);
  const std::set<Coordinates> positions = EndsOf(before);
  for (const Coordinates& position : EndsOf(lines))
  {
    EXPECT_EQ(positions.count(position), 1U) << "a line left itself";
  }
  EXPECT_EQ(
    result.Report.Output.Points + result.Report.Edits.Collapses, result.Report.Input.Points);
  ASSERT_EQ(result.Report.Labels.size(), 3U);
  EXPECT_LT(MaxLabelChange(result.Report.Labels), 0.03);
}

TEST_P(LabelsInMode, KeepWallsBetweenThemSharedAndTheirAreas)
{
  const Surface input = HalvedBall(10);
  const Labels labels = PatchesAsLabels(input);
  ASSERT_EQ(labels.Names.size(), 3U);
  const Result result = RunWith(labels, input, InMode(GetParam(), Reduction(0.8)));
  const Topology before = CountTopology(input);
  const Topology after = CountTopology(result.Surface);
  EXPECT_EQ(result.Report.Stop, StopReason::TargetReached);
  EXPECT_EQ(after.BoundaryEdges, 0) << "a crack";
  EXPECT_EQ(after.EulerNumber, before.EulerNumber);
  EXPECT_LT(after.NonManifoldEdges, before.NonManifoldEdges);
  EXPECT_EQ(LinesOf(result.Surface, LabelsAfter(labels, result)).size(),
    static_cast<std::size_t>(after.NonManifoldEdges))
    << "a label beyond its line";
  EXPECT_LT(MaxLabelChange(result.Report.Labels), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Modes, LabelsInMode, testing::ValuesIn(AllModes()),
  [](const auto& mode) { return WordOf(mode.param); });

TEST(Labels, OpenNoGapsWhereBonesDecimatedOneByOneDo)
{
  const Surface input = HalvedBall(12);
  const Labels labels = PatchesAsLabels(input);
  std::array<double, 3> areas = {};
  for (std::size_t t = 0; t < input.Triangles.size(); ++t)
  {
    const Triangle& c = input.Triangles[t];
    areas.at(static_cast<std::size_t>(labels.OfTriangle[t])) +=
      AreaVector(input.Points[c[0]], input.Points[c[1]], input.Points[c[2]]).norm();
  }
  const auto wall =
    static_cast<Index>(std::min_element(areas.begin(), areas.end()) - areas.begin());
  std::array<Surface, 2> alone;
  std::array<Surface, 2> together;
  const Options options = InMode(Mode::Balanced, Reduction(0.9));
  const Result result = RunWith(labels, input, options);
  const Labels after = { LabelsAfter(labels, result), labels.Names };
  for (std::size_t bone = 0; bone < 2; ++bone)
  {
    const std::set<Index> wanted = { wall, (wall + 1 + static_cast<Index>(bone)) % 3 };
    alone.at(bone) = Decimate(PartOfSurface(input, labels, wanted), options).Surface;
    together.at(bone) = PartOfSurface(result.Surface, after, wanted);
    EXPECT_EQ(CountTopology(together.at(bone)).BoundaryEdges, 0);
    EXPECT_EQ(CountTopology(together.at(bone)).NonManifoldEdges, 0);
  }
  const auto shared = [](const std::array<Surface, 2>& bones)
  {
    const std::set<std::set<Coordinates>> first = PositionsOfTriangles(bones[0]);
    std::size_t count = 0;
    for (const std::set<Coordinates>& triangle : PositionsOfTriangles(bones[1]))
    {
      count += first.count(triangle);
    }
    return count;
  };
  const auto walls =
    static_cast<std::size_t>(std::count(after.OfTriangle.begin(), after.OfTriangle.end(), wall));
  EXPECT_GT(walls, 20U);
  EXPECT_EQ(shared(together), walls);
  EXPECT_LT(shared(alone), walls / 4) << "one by one they would match as well";
  EXPECT_LT(MaxLabelChange(result.Report.Labels), 0.01);
}

TEST(Labels, FeatureCurvesStayWithinTheProvedError)
{
  constexpr double error = 0.4; // mm
  const Surface ball = Icosphere(4, 10.0);
  const Surface halves = HalvedBall(6);
  for (const auto& [input, labels] : { std::pair<Surface, Labels>(ball, ThreeParts(ball)),
         std::pair<Surface, Labels>(halves, PatchesAsLabels(halves)) })
  {
    Options options = InMode(Mode::Fast, Error(error));
    options.MeasureDistances = true;
    const Result result = RunWith(labels, input, options);
    const std::vector<Segment> before = LinesOf(input, labels.OfTriangle);
    const std::vector<Segment> after = LinesOf(result.Surface, LabelsAfter(labels, result));
    EXPECT_EQ(ProofMessage(result.Report), "");
    EXPECT_TRUE(result.Report.Proof.WasMade);
    EXPECT_LE(result.Report.Proof.Upper(), error);
    EXPECT_LT(after.size(), 0.7 * before.size());
    EXPECT_LE(MaxDistance(before, after), error);
    EXPECT_LE(MaxDistance(after, before), error);
    EXPECT_EQ(CountTopology(result.Surface).BoundaryEdges, 0);
    EXPECT_EQ(CountTopology(result.Surface).EulerNumber, CountTopology(input).EulerNumber);
  }
}

TEST(Labels, GiveTheSameBytesForAnyNumberOfThreads)
{
  for (const auto& [levels, error] : { std::pair(5, 0.0), std::pair(4, 0.1) })
  {
    const Surface input = Icosphere(levels, 10.0);
    const Labels labels = ThreeParts(input);
    Options options = InMode(Mode::Fast, Reduction(0.8));
    options.MaximumError = error;
    const Surface expected = RunWith(labels, input, options).Surface;
    options.NumberOfThreads = 4;
    EXPECT_TRUE(SameBytes(RunWith(labels, input, options).Surface, expected));
  }
}

TEST(Labels, OfOneKindChangeNothing)
{
  const Surface input = Icosphere(3, 10.0);
  const Labels labels = { std::vector<Index>(input.Triangles.size(), 0), { "7" } };
  const Options options = InMode(Mode::Fast, Reduction(0.9));
  const Result result = RunWith(labels, input, options);
  EXPECT_TRUE(SameBytes(result.Surface, Decimate(input, options).Surface));
  EXPECT_EQ(result.Report.Labels.size(), 1U);
}

TEST(Labels, GoAsFarAsAnyOtherSurfaceAndNeverTearOrFlattenIt)
{
  const Surface input = Icosphere(3, 10.0);
  const Labels labels = ThreeParts(input);
  for (const Mode mode : AllModes())
  {
    const Result result = RunWith(labels, input, InMode(mode, Triangles(1)));
    const Topology after = CountTopology(result.Surface);
    EXPECT_LT(after.Faces, 60) << WordOf(mode);
    EXPECT_EQ(after.BoundaryEdges + after.NonManifoldEdges, 0) << WordOf(mode);
    EXPECT_EQ(after.EulerNumber, 2) << WordOf(mode);
    const Surface ball = HalvedBall(4);
    const Surface least = RunWith(PatchesAsLabels(ball), ball, InMode(mode, Triangles(1))).Surface;
    EXPECT_EQ(PositionsOfTriangles(least).size(), least.Triangles.size()) << "one upon the other";
    EXPECT_EQ(CountTopology(least).EulerNumber, CountTopology(ball).EulerNumber) << WordOf(mode);
  }
}

TEST(Labels, StayWhereFeatureCurvesAreConstrained)
{
  const Surface input = Icosphere(4, 10.0);
  const Labels labels = ThreeParts(input);
  std::vector<double> tolerances(input.Points.size(), -1.0);
  const std::set<Coordinates> positions = EndsOf(LinesOf(input, labels.OfTriangle));
  for (std::size_t p = 0; p < tolerances.size(); ++p)
  {
    const Vector3& v = input.Points[p];
    tolerances[p] = positions.count({ v[0], v[1], v[2] }) > 0 ? 0.0 : -1.0;
  }
  const Result result = Decimate(
    input, InMode(Mode::Fast, Reduction(0.7)), {}, { false, true, &tolerances, nullptr, &labels });
  EXPECT_EQ(EndsOf(LinesOf(result.Surface, LabelsAfter(labels, result))), positions);
}

TEST(Labels, AreReportedWithTheirAreas)
{
  const Surface input = Icosphere(3, 10.0);
  const Labels labels = ThreeParts(input);
  Result result = RunWith(labels, input, InMode(Mode::Fast, Reduction(0.5)));
  double before = 0.0;
  double after = 0.0;
  for (const LabelArea& area : result.Report.Labels)
  {
    before += area.Input;
    after += area.Output;
  }
  EXPECT_NEAR(before, TotalArea(input), 1e-9 * before);
  EXPECT_NEAR(after, TotalArea(result.Surface), 1e-9 * after);
  std::set<std::string> names;
  for (const ReportEntry& entry : ReportEntries(result.Report))
  {
    names.insert(entry.Name);
  }
  for (const char* name : { "labels.count", "labels.largest_change", "labels.of_top.input_area",
         "labels.of_left.output_area" })
  {
    EXPECT_EQ(names.count(name), 1U) << name;
  }
  const std::size_t warnings = InputWarnings(result.Report).size();
  result.Report.Labels[1].Output = 1.02 * result.Report.Labels[1].Input;
  ASSERT_EQ(InputWarnings(result.Report).size(), warnings + 1);
  EXPECT_NE(InputWarnings(result.Report).back().find("right: by 2 %"), std::string::npos);
}

namespace
{
/// Points where edges of three or more triangles end or meet: all others of these edges have two of
/// them.
std::int64_t EndsOfCurves(const Surface& surface)
{
  std::map<Index, int> edgesAt;
  for (const auto& [edge, triangles] : EdgesOf(surface))
  {
    if (triangles.size() > 2)
    {
      ++edgesAt[edge.first];
      ++edgesAt[edge.second];
    }
  }
  return std::count_if(
    edgesAt.begin(), edgesAt.end(), [](const auto& point) { return point.second != 2; });
}
}

TEST(LabelMapCurves, ThatAreCollapsedDoNotCountAsPointsThatStay)
{
  const LabelSurfaces surfaces = Extracted(EllipsoidLabels({ 25, 22, 20 }));
  RunInputs inputs;
  inputs.LabelMap = &surfaces.Source;
  const Result result = Decimate(surfaces.Surface, Reduction(0.8), {}, inputs);
  const Topology before = CountTopology(surfaces.Surface);
  EXPECT_LT(CountTopology(result.Surface).NonManifoldPoints, before.NonManifoldPoints / 2);
  const CleaningStatistics& found = result.Report.Cleaning;
  EXPECT_EQ(found.NonManifoldPoints, EndsOfCurves(surfaces.Surface));
  EXPECT_LT(found.NonManifoldPoints, before.NonManifoldPoints / 4);
  // A log does not record the collapse of curves: all of their points stay.
  EditLog log;
  inputs.Log = &log;
  const Result logged = Decimate(surfaces.Surface, Reduction(0.8), {}, inputs);
  EXPECT_EQ(logged.Report.Cleaning.NonManifoldPoints, before.NonManifoldPoints);
  EXPECT_EQ(CountTopology(logged.Surface).NonManifoldPoints, before.NonManifoldPoints);
}

TEST(LabelMapCurves, BetweenLabelsOfAManifoldSurfaceHaveNoPointThatStaysForTheTopology)
{
  const Surface input = Icosphere(3, 10.0);
  const Result result = RunWith(ThreeParts(input), input, Reduction(0.5));
  EXPECT_EQ(result.Report.Cleaning.NonManifoldPoints, 0);
  EXPECT_EQ(result.Report.Cleaning.FirstNonManifoldPoint, -1);
}

TEST(Labels, WarningsNameTheWallThatChangedMost)
{
  const auto warning = [](const std::string& name)
  {
    Report report;
    report.Labels = { { "8", 100.0, 100.5 }, { name, 100.0, 95.0 }, { "9", 100.0, 102.0 } };
    const std::vector<std::string> warnings = InputWarnings(report);
    return warnings.empty() ? std::string() : warnings.back();
  };
  EXPECT_EQ(
    warning("7"), "the areas of 2 labels changed by more than 1 %, most that of label 7: by 5 %");
  EXPECT_EQ(warning("2_0"),
    "the areas of 2 walls between labels changed by more than 1 %, most that of the wall between "
    "2 and 0: by 5 %");
}
