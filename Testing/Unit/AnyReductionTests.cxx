// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Properties that every result keeps, for all shapes, modes and reductions.
#include "BruteForce.h"
#include "Mesh/Cleaning.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <tuple>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
constexpr double Rounding = 1e-12; // mm, on shapes of at most about 100 mm

using Coordinates = std::array<double, 3>;

Coordinates CoordinatesOf(const Vector3& p)
{
  return { p.x(), p.y(), p.z() };
}

void ExpectSameTopology(const Surface& before, const Surface& after)
{
  const Topology expected = CountTopology(before);
  const Topology found = CountTopology(after);
  EXPECT_EQ(WhatIsWrong(after), "");
  EXPECT_EQ(found.Components, expected.Components);
  EXPECT_EQ(found.EulerNumber, expected.EulerNumber);
  EXPECT_EQ(found.NonManifoldEdges, expected.NonManifoldEdges);
  EXPECT_EQ(found.NonManifoldPoints, expected.NonManifoldPoints);
  EXPECT_EQ(found.InconsistentEdges, expected.InconsistentEdges);
  EXPECT_EQ(RepeatedTriangles(after), RepeatedTriangles(before));
  if (expected.NonManifoldPoints + expected.InconsistentEdges == 0)
  {
    const std::vector<std::int64_t> loops = BoundaryLoopLengths(after);
    EXPECT_EQ(loops.size(), BoundaryLoopLengths(before).size());
    EXPECT_TRUE(
      std::all_of(loops.begin(), loops.end(), [](std::int64_t edges) { return edges >= 3; }));
  }
}

/// Counts of closed manifold fragments. Fragments are not identified, because their order may
/// change.
struct ClosedFragments
{
  std::int64_t Outwards = 0; // positive volume
  std::int64_t Inwards = 0;  // negative volume
  std::int64_t Least = 0;    // fewer than four triangles

  explicit ClosedFragments(const Surface& surface)
  {
    for (const Surface& fragment : SplitComponents(surface))
    {
      const Topology kind = CountTopology(fragment);
      if (kind.BoundaryEdges + kind.NonManifoldPoints + kind.InconsistentEdges == 0)
      {
        const double volume = SignedVolume(fragment);
        this->Outwards += volume > 0.0 ? 1 : 0;
        this->Inwards += volume < 0.0 ? 1 : 0;
        this->Least += fragment.Triangles.size() < 4 ? 1 : 0;
      }
    }
  }
};

void ExpectFragmentsKept(const Surface& before, const Surface& after)
{
  const ClosedFragments expected(before);
  const ClosedFragments found(after);
  EXPECT_EQ(SplitComponents(after).size(), SplitComponents(before).size());
  EXPECT_EQ(found.Outwards, expected.Outwards);
  EXPECT_EQ(found.Inwards, expected.Inwards);
  EXPECT_EQ(found.Least, expected.Least);
}

/// Non-manifold points and triangles are in the result bit for bit.
void ExpectConstrainedPartsKept(const Surface& input, const Surface& after)
{
  const CleanSurface clean = Clean(input, true);
  const HalfEdgeMesh mesh(clean.Surface);
  std::multiset<Coordinates> positions;
  std::multiset<std::array<Coordinates, 3>> triangles;
  for (const Vector3& p : after.Points)
  {
    positions.insert(CoordinatesOf(p));
  }
  const auto positionsOf = [](const Triangle& t, const auto& coordinatesOf)
  {
    return std::array<Coordinates, 3>{ coordinatesOf(t[0]), coordinatesOf(t[1]),
      coordinatesOf(t[2]) };
  };
  for (const Triangle& t : after.Triangles)
  {
    triangles.insert(positionsOf(t, [&](Index p) { return CoordinatesOf(after.Points[p]); }));
  }
  const auto inputPosition = [&](Index v)
  { return CoordinatesOf(input.Points[clean.InputPoint[v]]); };
  for (Index v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    if (mesh.Constraint(v) == VertexConstraint::NonManifold)
    {
      EXPECT_EQ(positions.count(inputPosition(v)), 1U) << "point " << clean.InputPoint[v];
    }
  }
  for (const Triangle& t : clean.Surface.Triangles)
  {
    if (std::all_of(t.begin(), t.end(),
          [&](Index v) { return mesh.Constraint(v) == VertexConstraint::NonManifold; }))
    {
      EXPECT_GE(triangles.count(positionsOf(t, inputPosition)), 1U)
        << "a triangle of constrained points";
    }
  }
}

void ExpectPositionsAreNearest(const Surface& input, const Result& result)
{
  for (std::size_t i = 0; i < result.Surface.Points.size(); ++i)
  {
    const Vector3& p = result.Surface.Points[i];
    const Index triangle = result.Origins.NearestTriangle[i];
    ASSERT_GE(triangle, 0);
    ASSERT_LT(triangle, static_cast<Index>(input.Triangles.size()));
    Vector3 position = Vector3::Zero();
    double sum = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double weight = result.Origins.Barycentric[i][k];
      EXPECT_GE(weight, -1e-15);
      sum += weight;
      position += weight * input.Points[input.Triangles[triangle][k]];
    }
    EXPECT_NEAR(sum, 1.0, 1e-14);
    EXPECT_NEAR((position - p).norm(), result.Distance[i], Rounding) << "point " << i;
    EXPECT_NEAR(BruteNearest(input, p).Distance, result.Distance[i], Rounding) << "point " << i;
    const double toPoint = (input.Points[result.Origins.NearestPoint[i]] - p).norm();
    EXPECT_NEAR((input.Points[BruteNearestPoint(input, p)] - p).norm(), toPoint, Rounding);
    EXPECT_GE(result.RunningError[i], result.Distance[i] - Rounding) << "point " << i;
    EXPECT_LE(result.RunningError[i], result.Report.RunningError);
  }
}

void ExpectCentroidsAreNearest(const Surface& input, const Result& result)
{
  ASSERT_EQ(result.Origins.TriangleAtCentroid.size(), result.Surface.Triangles.size());
  for (std::size_t t = 0; t < result.Surface.Triangles.size(); ++t)
  {
    const Triangle& c = result.Surface.Triangles[t];
    const std::vector<Vector3>& points = result.Surface.Points;
    const Vector3 centroid = (points[c[0]] + points[c[1]] + points[c[2]]) / 3.0;
    const Surface found = { input.Points,
      { input.Triangles[result.Origins.TriangleAtCentroid[t]] } };
    EXPECT_NEAR(
      BruteNearest(found, centroid).Distance, BruteNearest(input, centroid).Distance, Rounding)
      << "triangle " << t;
  }
}

/// Each output point occurs as often as its count; unmoved points represent themselves.
void ExpectOutputPointsAreCounted(const Surface& input, const Result& result)
{
  ASSERT_EQ(result.Origins.OutputPoint.size(), input.Points.size());
  std::vector<Index> counts(result.PointCount.size(), 0);
  for (std::size_t p = 0; p < input.Points.size(); ++p)
  {
    const Index output = result.Origins.OutputPoint[p];
    counts.at(static_cast<std::size_t>(output == None ? 0 : output)) += output == None ? 0 : 1;
  }
  EXPECT_EQ(counts, result.PointCount);
  for (std::size_t i = 0; i < result.Surface.Points.size(); ++i)
  {
    const Index nearest = result.Origins.NearestPoint[i];
    if (result.Surface.Points[i] == input.Points[nearest])
    {
      EXPECT_EQ(result.Origins.OutputPoint[nearest], static_cast<Index>(i));
    }
  }
}

void ExpectMapsAreWhole(const Surface& input, const Result& result)
{
  const std::size_t count = result.Surface.Points.size();
  ASSERT_EQ(result.Origins.NearestTriangle.size(), count);
  ASSERT_EQ(result.Origins.Barycentric.size(), count);
  ASSERT_EQ(result.Origins.NearestPoint.size(), count);
  ASSERT_EQ(result.Distance.size(), count);
  ASSERT_EQ(result.RunningError.size(), count);
  ASSERT_EQ(result.PointCount.size(), count);
  const std::set<Index> used = [&]
  {
    std::set<Index> points;
    for (const Triangle& t : input.Triangles)
    {
      points.insert(t.begin(), t.end());
    }
    return points;
  }();
  EXPECT_EQ(std::accumulate(result.PointCount.begin(), result.PointCount.end(), std::size_t(0)),
    used.size());
  EXPECT_TRUE(std::all_of(
    result.PointCount.begin(), result.PointCount.end(), [](Index points) { return points >= 1; }));
}

void ExpectReportIsTrue(const Surface& before, const Result& result)
{
  const auto expectSide = [](const SurfaceStatistics& told, const Surface& surface)
  {
    const Topology found = CountTopology(surface);
    EXPECT_EQ(told.Faces, found.Faces);
    EXPECT_EQ(told.Points, found.Points);
    EXPECT_EQ(told.Components, found.Components);
    EXPECT_EQ(told.BoundaryEdges, found.BoundaryEdges);
    EXPECT_EQ(told.NonManifoldEdges, found.NonManifoldEdges);
    EXPECT_EQ(told.EulerNumber, found.EulerNumber);
    EXPECT_NEAR(told.Area, TotalArea(surface), 1e-9 * (1.0 + told.Area));
  };
  expectSide(result.Report.Input, before);
  expectSide(result.Report.Output, result.Surface);
  EXPECT_EQ(result.Report.Status, InputStatus::Good);
  EXPECT_EQ(
    result.Report.Output.Points + result.Report.Edits.Collapses, result.Report.Input.Points);
  EXPECT_FALSE(result.Report.DistancesMeasured);
}
}

/// Every shape in every mode.
class AnyReduction : public testing::TestWithParam<std::tuple<NamedSurface, Mode>>
{
public:
  const Surface& Shape() const { return std::get<0>(GetParam()).Surface; }

  Options Reduced(double fraction) const
  {
    Options options = Reduction(fraction);
    options.Mode = std::get<1>(GetParam());
    return options;
  }

  static std::string Name(const testing::TestParamInfo<ParamType>& info)
  {
    return std::get<0>(info.param).Name + WordOf(std::get<1>(info.param));
  }
};

TEST_P(AnyReduction, KeepsTopologyFragmentsAndConstrainedPartsAndReportsThem)
{
  const Surface& input = this->Shape();
  const Surface before = Clean(input, true).Surface;
  for (const double fraction : { 0.0, 0.3, 0.6, 0.9, 0.99, 1.0 })
  {
    SCOPED_TRACE("reduction " + std::to_string(fraction));
    const Result result = Decimate(input, Reduced(fraction), {}, { false, true });
    ExpectSameTopology(before, result.Surface);
    ExpectFragmentsKept(before, result.Surface);
    ExpectConstrainedPartsKept(input, result.Surface);
    ExpectMapsAreWhole(input, result);
    ExpectPositionsAreNearest(input, result);
    ExpectCentroidsAreNearest(input, result);
    ExpectOutputPointsAreCounted(input, result);
    ExpectReportIsTrue(before, result);
  }
}

TEST_P(AnyReduction, RemovesTheRequestedFractionOrReportsNothingLeft)
{
  const auto faces = static_cast<double>(this->Shape().Triangles.size());
  for (const double fraction : { 0.1, 0.5, 0.8, 0.95 })
  {
    const Result result = Decimate(this->Shape(), Reduced(fraction));
    const auto target = static_cast<std::int64_t>(std::floor(faces * (1.0 - fraction) + 0.5));
    const auto left = static_cast<std::int64_t>(result.Surface.Triangles.size());
    const StopReason stop = result.Report.Stop;
    if (stop == StopReason::NothingLeft || stop == StopReason::Handles)
    {
      EXPECT_GT(left, target) << fraction;
      continue;
    }
    EXPECT_LE(left, target) << fraction;
    EXPECT_GE(left, target - 1) << fraction << ": a collapse takes two triangles at most";
    EXPECT_EQ(stop, left == faces ? StopReason::AlreadySatisfied : StopReason::TargetReached);
  }
}

TEST_P(AnyReduction, ScalingByPowersOfTwoChangesNothingButTheScale)
{
  const Surface& input = this->Shape();
  for (const double factor : { 1024.0, 1.0 / 4096.0 })
  {
    const Result plain = Decimate(input, Reduced(0.7), {}, { false, true });
    const Result scaled = Decimate(Scaled(input, factor), Reduced(0.7), {}, { false, true });
    EXPECT_TRUE(SameBytes(Scaled(plain.Surface, factor), scaled.Surface)) << factor;
    EXPECT_EQ(factor * plain.Report.RunningError, scaled.Report.RunningError) << factor;
    EXPECT_EQ(plain.Origins.NearestTriangle, scaled.Origins.NearestTriangle) << factor;
  }
}

TEST_P(AnyReduction, TranslationByRepresentableAmountsKeepsTheTopology)
{
  Surface input = this->Shape();
  for (Vector3& p : input.Points)
  {
    p = (p * 1048576.0).array().round().matrix() / 1048576.0;
  }
  const Surface moved = Moved(input, { 4096.0, -2048.0, 512.5 });
  const Result plain = Decimate(input, Reduced(0.7), {}, { false, true });
  const Result far = Decimate(moved, Reduced(0.7), {}, { false, true });
  EXPECT_EQ(plain.Surface.Triangles, far.Surface.Triangles);
  // All others measure their errors where the points are written, rounded far from the origin.
  const double rounding = std::get<1>(GetParam()) == Mode::Thesis ? 0.0 : 1e-9;
  EXPECT_NEAR(plain.Report.RunningError, far.Report.RunningError, rounding);
}

TEST_P(AnyReduction, MillimetersOrMetersGiveTheSameNumberOfTriangles)
{
  const Surface& input = this->Shape();
  const std::size_t millimeters = Decimate(input, Reduced(0.8)).Surface.Triangles.size();
  const std::size_t meters = Decimate(Scaled(input, 0.001), Reduced(0.8)).Surface.Triangles.size();
  EXPECT_LE(std::max(millimeters, meters) - std::min(millimeters, meters), 1U);
}

INSTANTIATE_TEST_SUITE_P(Shapes, AnyReduction,
  testing::Combine(testing::ValuesIn(AllShapes()), testing::ValuesIn(AllModes())),
  AnyReduction::Name);

TEST(AnyUnit, MillimetersOrMetersGiveTheSameDistances)
{
  // Shapes without equal costs: rounding may decide between those.
  for (const Surface& input : { BumpySphere(3, 5.0, 0.1, 7), BumpySphere(4, 20.0, 0.02, 8) })
  {
    for (const Mode mode : AllModes())
    {
      Options options = InMode(mode, Reduction(0.8));
      options.MeasureDistances = true;
      const Report millimeters = Decimate(input, options).Report;
      const Report meters = Decimate(Scaled(input, 0.001), options).Report;
      EXPECT_EQ(millimeters.Output.Faces, meters.Output.Faces);
      const double error = millimeters.InputToOutput.RootMeanSquare;
      EXPECT_NEAR(1000.0 * meters.InputToOutput.RootMeanSquare, error, 0.01 * error);
    }
  }
}
