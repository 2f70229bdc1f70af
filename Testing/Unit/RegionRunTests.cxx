// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// A run over regions changes nothing else, and its report is that of the whole surface.
#include "Crossings.h"
#include "LabeledSurfaces.h"
#include "Mesh/Statistics.h"
#include "Proof/Certificate/Certificate.h"
#include "Random.h"
#include "RegionRuns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
using Corners = std::array<double, 9>;

std::map<Corners, int> CornersIn(const Surface& surface)
{
  std::map<Corners, int> all;
  for (const Triangle& t : surface.Triangles)
  {
    Corners corners;
    for (std::size_t i = 0; i < 9; ++i)
    {
      corners[i] = surface.Points[t[i / 3]][static_cast<Eigen::Index>(i % 3)];
    }
    ++all[corners];
  }
  return all;
}

/// Triangles at a point of tolerance 0 are in the result as often as in the input. Equal points
/// have the least tolerance.
void ExpectUnchanged(const Surface& input, const Map& map, const Surface& result)
{
  std::map<std::array<double, 3>, double> least;
  const auto at = [&](Index v)
  {
    const Vector3& p = input.Points[v];
    return std::array<double, 3>{ p[0], p[1], p[2] };
  };
  for (std::size_t i = 0; i < map.size(); ++i)
  {
    const auto added = least.emplace(at(static_cast<Index>(i)), map[i]);
    added.first->second = std::min(added.first->second, map[i]);
  }
  Surface unchanged = { input.Points, {} };
  for (const Triangle& t : input.Triangles)
  {
    if (std::any_of(t.begin(), t.end(), [&](Index v) { return least[at(v)] == 0.0; }))
    {
      unchanged.Triangles.push_back(t);
    }
  }
  std::map<Corners, int> found = CornersIn(result);
  for (const auto& triangle : CornersIn(unchanged))
  {
    EXPECT_GE(found[triangle.first], triangle.second);
  }
}

/// By the certificate of the whole surfaces, or undecided within its slack.
void ExpectProved(const Surface& input, const Map& map, const Surface& result)
{
  CertificateOptions options;
  options.ToleranceMap = map;
  options.TightBounds = false;
  options.NumberOfThreads = 1;
  const Certificate found = Certify(input, result, options);
  const double excess = std::max({ found.ReferenceToResult.Excess.Upper,
    found.ResultToReference.Excess.Upper, found.BoundaryOfReferenceToResult.Excess.Upper,
    found.BoundaryOfResultToReference.Excess.Upper });
  EXPECT_TRUE(found.Proof == ProofStatus::Proved || excess <= 2.0 * found.Slack) << excess;
}

/// Figures of the report against those of the surface itself.
void ExpectStatistics(const Result& result)
{
  const SurfaceStatistics expected = Describe(result.Surface);
  const SurfaceStatistics& found = result.Report.Output;
  EXPECT_EQ(found.Faces, expected.Faces);
  EXPECT_EQ(found.Points, expected.Points);
  EXPECT_EQ(found.Components, expected.Components);
  EXPECT_EQ(found.BoundaryEdges, expected.BoundaryEdges);
  EXPECT_EQ(found.NonManifoldEdges, expected.NonManifoldEdges);
  EXPECT_EQ(found.EulerNumber, expected.EulerNumber);
  EXPECT_NEAR(found.Area, expected.Area, 1e-9 * expected.Area);
}

void ExpectSameInput(const Report& found, const Report& expected)
{
  EXPECT_EQ(found.Input.Faces, expected.Input.Faces);
  EXPECT_EQ(found.Input.Points, expected.Input.Points);
  EXPECT_EQ(found.Input.Components, expected.Input.Components);
  EXPECT_EQ(found.Input.BoundaryEdges, expected.Input.BoundaryEdges);
  EXPECT_EQ(found.Input.NonManifoldEdges, expected.Input.NonManifoldEdges);
  EXPECT_EQ(found.Input.EulerNumber, expected.Input.EulerNumber);
  EXPECT_NEAR(found.Input.Area, expected.Input.Area, 1e-9 * expected.Input.Area);
  EXPECT_NEAR(found.Input.Volume, expected.Input.Volume, 1e-9 * expected.Input.Area);
  EXPECT_EQ(found.InputChecksum, expected.InputChecksum);
  EXPECT_EQ(found.Size.Diagonal, expected.Size.Diagonal);
  EXPECT_EQ(found.Size.ErrorBound, expected.Size.ErrorBound);
  EXPECT_EQ(found.Cleaning.ConstrainedPoints, expected.Cleaning.ConstrainedPoints);
  EXPECT_EQ(found.Cleaning.NonManifoldPoints, expected.Cleaning.NonManifoldPoints);
  EXPECT_EQ(found.Cleaning.FirstNonManifoldPoint, expected.Cleaning.FirstNonManifoldPoint);
  EXPECT_EQ(found.Cleaning.MergedPoints, expected.Cleaning.MergedPoints);
  EXPECT_EQ(found.Cleaning.UnusedPoints, expected.Cleaning.UnusedPoints);
}

class EachRegion : public EachShape
{
};
}

TEST_P(EachRegion, ChangesNothingElseWhateverTheShape)
{
  const Surface& input = GetParam().Surface;
  if (!CanBeCertified(input))
  {
    GTEST_SKIP() << "what cleaning drops from it may be farther away than anything";
  }
  const double size = Decimate(input, Unmeasured()).Report.Size.Diagonal;
  Random random(9);
  for (const Mode mode : { Mode::Fast, Mode::Accurate })
  {
    const auto at = static_cast<std::size_t>(random.Below(static_cast<Index>(input.Points.size())));
    const Map map = Brush(input, input.Points[at], 0.15 * size, 0.004 * size);
    const Options options = InMode(mode, Error(0.003 * size));
    const Result result = Stroke(input, options, map);
    ASSERT_EQ(result.Report.Status, InputStatus::Good);
    EXPECT_NE(result.Report.Regions.Status, RegionStatus::NotProved) << WordOf(mode);
    ExpectUnchanged(input, map, result.Surface);
    ExpectProved(input, map, result.Surface);
    ExpectStatistics(result);
    ExpectSameInput(result.Report, StrokeOfWhole(input, options, map).Report);
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, EachRegion, testing::ValuesIn(AllShapes()), NameOf);

TEST(Region, IsSimplifiedAsMuchAsByTheWholeRun)
{
  const Surface input = Ball();
  const Map map = Brush(input, Pole, 9.0, 0.2);
  for (const Mode mode : { Mode::Fast, Mode::Balanced })
  {
    const Result result = Stroke(input, InMode(mode, Error(0.2)), map);
    const Result whole = StrokeOfWhole(input, InMode(mode, Error(0.2)), map);
    EXPECT_EQ(result.Report.Regions.Status, RegionStatus::Used);
    EXPECT_EQ(whole.Report.Regions.Status, RegionStatus::OtherOptions);
    EXPECT_LT(4 * result.Report.Regions.Triangles, result.Report.Input.Faces);
    const double removed =
      static_cast<double>(input.Triangles.size() - result.Surface.Triangles.size());
    const double expected =
      static_cast<double>(input.Triangles.size() - whole.Surface.Triangles.size());
    EXPECT_GT(removed, 500.0) << WordOf(mode);
    EXPECT_NEAR(removed, expected, 0.02 * expected) << WordOf(mode);
  }
}

TEST(Region, LeavesTheRestInTheOrderOfTheInput)
{
  const Surface input = Ball();
  const Map map = Brush(input, Pole, 5.0, 0.1);
  const Surface result = Stroke(input, Fast(0.1), map).Surface;
  std::size_t next = 0;
  for (const Triangle& t : input.Triangles)
  {
    if (map[t[0]] == 0.0 || map[t[1]] == 0.0 || map[t[2]] == 0.0)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        ASSERT_EQ(result.Points[result.Triangles[next][k]], input.Points[t[k]]);
      }
      ++next;
    }
  }
  EXPECT_LT(next, result.Triangles.size());
}

TEST(Region, ReportsProofAndDistancesOfTheWhole)
{
  const Surface input = Ball(4);
  const Map map = Brush(input, Pole, 7.0, 0.2);
  Options options = Fast(0.2);
  options.MeasureDistances = true;
  const Result result = Stroke(input, options, map);
  const Report& report = result.Report;
  EXPECT_EQ(report.Regions.Status, RegionStatus::Used);
  EXPECT_EQ(report.Proof.Status, ProofStatus::Proved);
  const Certificate certified = Certify(input, result.Surface);
  EXPECT_LE(certified.Lower(), report.Proof.Upper());
  EXPECT_GE(certified.Upper(), report.Proof.Lower());
  EXPECT_NEAR(certified.Upper(), report.Proof.Upper(), 0.001);
  EXPECT_EQ(report.Proof.Boundaries, BoundaryPresence::Neither);
  CertificateOptions means;
  means.WithMeans = true;
  const Certificate averaged = Certify(input, result.Surface, means);
  EXPECT_NEAR(report.InputToOutput.Mean, averaged.ReferenceToResult.Mean.Mean,
    0.1 * averaged.ReferenceToResult.Mean.Mean);
  EXPECT_NEAR(report.OutputToInput.RootMeanSquare, averaged.ResultToReference.Mean.RootMeanSquare,
    0.1 * averaged.ResultToReference.Mean.RootMeanSquare);
  EXPECT_EQ(report.OutputToInput.PointMaximum,
    *std::max_element(result.Distance.begin(), result.Distance.end()));
  const Result whole = StrokeOfWhole(input, options, map);
  EXPECT_EQ(report.Cleaning.ConstrainedPoints, whole.Report.Cleaning.ConstrainedPoints);
  EXPECT_EQ(report.Stop, whole.Report.Stop);
  EXPECT_EQ(report.Edits.Draft.Status, whole.Report.Edits.Draft.Status);
}

TEST(Region, KnowsWhereItsPointsAndTrianglesComeFrom)
{
  const Surface input = Unwelded(Ball());
  const Map map = Brush(input, Pole, 6.0, 0.2);
  const Result result = Stroke(input, Fast(0.2), map);
  EXPECT_EQ(result.Report.Regions.Status, RegionStatus::Used);
  const SurfaceOrigins& origins = result.Origins;
  std::vector<Index> counted(result.Surface.Points.size(), 0);
  for (const Index point : origins.OutputPoint)
  {
    ASSERT_NE(point, None);
    ++counted[static_cast<std::size_t>(point)];
  }
  EXPECT_EQ(counted, result.PointCount);
  for (std::size_t p = 0; p < result.Surface.Points.size(); ++p)
  {
    const Triangle& c = input.Triangles[origins.NearestTriangle[p]];
    Vector3 nearest = Vector3::Zero();
    for (std::size_t k = 0; k < 3; ++k)
    {
      nearest += origins.Barycentric[p][k] * input.Points[c[k]];
    }
    EXPECT_NEAR((nearest - result.Surface.Points[p]).norm(), result.Distance[p], 1e-9);
    EXPECT_LE(result.Distance[p], 0.2);
  }
  for (std::size_t t = 0; t < result.Surface.Triangles.size(); ++t)
  {
    const auto center = [](const Surface& of, const Triangle& c)
    { return Vector3((of.Points[c[0]] + of.Points[c[1]] + of.Points[c[2]]) / 3.0); };
    const Vector3 from = center(input, input.Triangles[origins.TriangleAtCentroid[t]]);
    EXPECT_LT((from - center(result.Surface, result.Surface.Triangles[t])).norm(), 1.0);
  }
}

TEST(Region, DoesNotPierceASurfaceNextToIt)
{
  const Surface lower = HeightField(24, 0.3, 5);
  const Surface input = Together(lower, Moved(lower, Vector3(0.0, 0.0, 0.1)));
  const auto first = static_cast<std::ptrdiff_t>(lower.Points.size());
  Map map = Brush(input, Vector3(12.0, 12.0, 0.0), 4.0, 0.6);
  std::fill(map.begin() + first, map.end(), 0.0); // the upper surface is not of the region
  Options options = Fast(0.6);
  const Result guarded = Stroke(input, options, map);
  EXPECT_EQ(guarded.Report.Regions.Status, RegionStatus::Used);
  EXPECT_LT(guarded.Surface.Triangles.size(), input.Triangles.size());
  EXPECT_EQ(CountCrossings(guarded.Surface), 0);
  options.IntersectionGuard = false;
  EXPECT_GT(CountCrossings(Stroke(input, options, map).Surface), 0);
}

TEST(Region, MovesBoundariesWithinTheErrorOfTheirCurve)
{
  const Surface input = HeightField(60, 0.1, 5);
  const Map map = Brush(input, Vector3(30.0, 0.0, 0.0), 12.0, 0.3);
  const Result result = Stroke(input, Fast(0.3), map);
  EXPECT_EQ(result.Report.Regions.Status, RegionStatus::Used);
  EXPECT_EQ(result.Report.Proof.Boundaries, BoundaryPresence::Both);
  EXPECT_LT(result.Report.Output.BoundaryEdges, result.Report.Input.BoundaryEdges);
  ExpectStatistics(result);
  ExpectProved(input, map, result.Surface);
  const Certificate certified = Certify(input, result.Surface);
  EXPECT_LE(certified.BoundaryOfReferenceToResult.Distance.Lower,
    result.Report.Proof.BoundaryInputToOutput.Upper);
}

TEST(Region, MayEndWhereTheSurfaceIsNotManifold)
{
  for (const Surface& input : { ThreeLeavedBook(30), DuplicateTriangles(4, 40), HalvedBall(12) })
  {
    const SurfaceStatistics before = Describe(input);
    const Vector3 center = input.Points[input.Triangles[0][0]];
    const double size = Decimate(input, Unmeasured()).Report.Size.Diagonal;
    const Map map = Brush(input, center, 0.15 * size, 0.01 * size);
    const Result result = Stroke(input, Fast(0.01 * size), map);
    EXPECT_EQ(result.Report.Regions.Status, RegionStatus::Used);
    EXPECT_LT(result.Report.Output.Faces, before.Faces);
    EXPECT_GT(result.Report.Output.NonManifoldEdges, 0);
    ExpectStatistics(result);
    ExpectUnchanged(input, map, result.Surface);
    ExpectProved(input, map, result.Surface);
  }
}

TEST(Region, KeepsLabelsAndTheCurvesBetweenThem)
{
  const Surface input = Ball();
  Labels labels;
  labels.Names = { "left", "right" };
  for (const Triangle& t : input.Triangles)
  {
    labels.OfTriangle.push_back(
      input.Points[t[0]][0] + input.Points[t[1]][0] + input.Points[t[2]][0] > 0.0 ? 1 : 0);
  }
  const Map map = Brush(input, Pole, 7.0, 0.2);
  RegionCache cache;
  RunInputs inputs = { false, true, &map, nullptr, &labels };
  inputs.Regions = &cache;
  const Result result = Decimate(input, Fast(0.2), {}, inputs);
  EXPECT_EQ(result.Report.Regions.Status, RegionStatus::Used);
  const std::vector<Index> after = LabelsAfter(labels, result);
  const std::vector<Segment> before = LinesOf(input, labels.OfTriangle);
  const std::vector<Segment> curves = LinesOf(result.Surface, after);
  EXPECT_LT(curves.size(), before.size()); // simplified, too
  EXPECT_LE(MaxDistance(before, curves), 0.2);
  EXPECT_LE(MaxDistance(curves, before), 0.2);
  ExpectUnchanged(input, map, result.Surface);
  ExpectStatistics(result);
  Options whole = Fast(0.2);
  whole.DiagnoseInput = true;
  const Report expected = Decimate(input, whole, {}, inputs).Report;
  ExpectSameInput(result.Report, expected);
  std::vector<double> areas = { 0.0, 0.0 };
  for (std::size_t t = 0; t < after.size(); ++t)
  {
    areas[static_cast<std::size_t>(after[t])] +=
      TotalArea({ result.Surface.Points, { result.Surface.Triangles[t] } });
  }
  ASSERT_EQ(result.Report.Labels.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i)
  {
    EXPECT_NEAR(result.Report.Labels[i].Output, areas[i], 1e-9 * areas[i]);
    EXPECT_NEAR(result.Report.Labels[i].Input, expected.Labels[i].Input, 1e-9 * areas[i]);
  }
  labels.OfTriangle[3] = 1 - labels.OfTriangle[3];
  EXPECT_EQ(Decimate(input, Fast(0.2), {}, inputs).Report.Regions.Kept, 0);
}
