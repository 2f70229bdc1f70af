// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Runs that smooth first: the certificate confirms the error relative to the input, and everything
// a run knows applies.
#include "LabeledSurfaces.h"
#include "LevelRuns.h"
#include "Proof/Certificate/Certificate.h"
#include "Run/Input/SmoothingPlan.h"
#include "SmoothingRuns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
const BinarySurface& TestTorus()
{
  static const BinarySurface torus = MarchedShape(Oblique(TorusShape(6.0, 2.5)), 9.5, Cubic);
  return torus;
}

Options Automatic(Options options)
{
  options.AutomaticSmoothing = true;
  return options;
}

/// mm, what an independent call of the certificate finds.
double ProvedDistanceTo(const Surface& input, const Surface& result)
{
  CertificateOptions options;
  options.NumberOfThreads = 1;
  const Certificate found = Certify(input, result, options);
  return std::max({ found.ReferenceToResult.Distance.Upper, found.ResultToReference.Distance.Upper,
    found.BoundaryOfReferenceToResult.Distance.Upper,
    found.BoundaryOfResultToReference.Distance.Upper });
}
}

TEST(SmoothingRun, KeepsTheLargestErrorRelativeToTheInput)
{
  const Surface& input = TestTorus().Surface;
  for (const Mode mode : ProvingModes())
  {
    for (const auto& [smoothing, error] :
      { std::pair(0.1, 0.25), std::pair(0.25, 0.25), std::pair(1.0, 0.4), std::pair(0.25, 0.5) })
    {
      const Result result = Decimate(input, InMode(mode, Smoothed(smoothing, Error(error))));
      ASSERT_EQ(result.Report.Status, InputStatus::Good);
      EXPECT_EQ(result.Report.Proof.Status, ProofStatus::Proved);
      EXPECT_LE(ProvedDistanceTo(input, result.Surface), error);
      EXPECT_LE(result.Report.Smoothing.MaxDisplacement, std::min(smoothing, error));
      EXPECT_GT(result.Report.Smoothing.MaxDisplacement, 0.5 * std::min(0.25, smoothing));
      EXPECT_LT(result.Surface.Triangles.size(), input.Triangles.size() / 2);
      EXPECT_TRUE(CountTopology(result.Surface).NonManifoldEdges == 0);
    }
  }
}

TEST(SmoothingRun, GivesSmootherResultsOfTheSameError)
{
  const Surface& input = TestTorus().Surface;
  const Result rough = Decimate(input, Error(0.25));
  const Result smooth = Decimate(input, Smoothed(0.1, Error(0.25)));
  const auto squares = [](const Surface& surface)
  {
    double sum = 0.0;
    for (const Vector3& p : surface.Points)
    {
      const Vector3 q = p;
      sum += q.squaredNorm();
    }
    return sum / static_cast<double>(surface.Points.size());
  };
  EXPECT_GT(squares(smooth.Surface), 0.0);
  EXPECT_EQ(rough.Report.Smoothing.From, SmoothingFigures::Source::NotRequested);
  EXPECT_EQ(smooth.Report.Smoothing.From, SmoothingFigures::Source::Binary);
  EXPECT_LT(smooth.Report.Smoothing.AngleAfter, 0.8 * smooth.Report.Smoothing.AngleBefore);
}

TEST(SmoothingRun, AloneGivesTheSmoothedSurfaceProved)
{
  const BinarySurface& torus = TestTorus();
  for (const Mode mode : AllModes())
  {
    const Result result = Decimate(torus.Surface, InMode(mode, Smoothed(0.25, Reduction(0.0))));
    ASSERT_EQ(result.Report.Status, InputStatus::Good);
    EXPECT_EQ(result.Surface.Triangles.size(), torus.Surface.Triangles.size());
    EXPECT_EQ(result.Report.Edits.Collapses, 0);
    EXPECT_EQ(result.Report.Proof.WasMade, FindMode(mode).ProvesError());
    if (result.Report.Proof.WasMade)
    {
      EXPECT_EQ(result.Report.Proof.Status, ProofStatus::Proved);
      EXPECT_EQ(result.Report.Proof.Tolerance, 0.25);
      EXPECT_LE(result.Report.Proof.Upper(), 0.25);
    }
    EXPECT_EQ(CountChangedVoxels(torus, result.Surface), 0);
    EXPECT_GT(result.Report.Smoothing.MaxDisplacement, 0.2);
    EXPECT_NEAR(result.Report.Smoothing.AreaAfter, TotalArea(result.Surface), 1e-6);
  }
}

TEST(SmoothingRun, OfThesisModeMeasuresTheDisplacement)
{
  const Result result =
    Decimate(TestTorus().Surface, InMode(Mode::Thesis, Smoothed(0.2, Reduction(0.0))));
  EXPECT_GT(result.Report.RunningError, 0.05);
  EXPECT_LE(result.Report.RunningError, 0.2);
}

TEST(SmoothingRun, KeepsConstrainedPointsBitForBit)
{
  const Surface& input = TestTorus().Surface;
  std::vector<double> tolerances;
  for (const Vector3& p : input.Points)
  {
    tolerances.push_back(p[0] < 0.0 ? 0.0 : -1.0);
  }
  for (const Mode mode : AllModes())
  {
    for (const Options& options : { Error(0.3), Reduction(0.0) })
    {
      const Result result =
        Decimate(input, InMode(mode, Smoothed(0.25, options)), {}, { false, false, &tolerances });
      ASSERT_EQ(result.Report.Status, InputStatus::Good);
      std::vector<std::array<double, 3>> points;
      for (const Vector3& p : result.Surface.Points)
      {
        points.push_back({ p[0], p[1], p[2] });
      }
      std::sort(points.begin(), points.end());
      for (const Triangle& c : input.Triangles)
      {
        if (std::any_of(c.begin(), c.end(), [&](Index v) { return tolerances[v] == 0.0; }))
        {
          for (const Index v : c)
          {
            const Vector3& p = input.Points[v];
            ASSERT_TRUE(std::binary_search(
              points.begin(), points.end(), std::array<double, 3>{ p[0], p[1], p[2] }));
          }
        }
      }
      EXPECT_GT(result.Report.Smoothing.MaxDisplacement, 0.05);
    }
  }
}

TEST(SmoothingRun, KeepsAMapOfTolerances)
{
  const Surface& input = TestTorus().Surface;
  std::vector<double> tolerances;
  for (const Vector3& p : input.Points)
  {
    tolerances.push_back(0.05 + 0.02 * std::abs(p[0]));
  }
  const Result result =
    Decimate(input, Smoothed(0.25, Unmeasured()), {}, { false, false, &tolerances });
  ASSERT_EQ(result.Report.Status, InputStatus::Good);
  EXPECT_EQ(result.Report.Proof.Status, ProofStatus::Proved);
  EXPECT_GT(result.Report.Smoothing.MaxDisplacement, 0.06);
  CertificateOptions options;
  options.ToleranceMap = tolerances;
  EXPECT_EQ(Certify(input, result.Surface, options).Proof, ProofStatus::Proved);
}

TEST(SmoothingRun, KeepsWallsBetweenLabelsJoined)
{
  const Surface input = HalvedBall(5);
  const Labels labels = PatchesAsLabels(input);
  const Topology before = CountTopology(input);
  RunInputs inputs;
  inputs.Labels = &labels;
  for (const Options& options : { Reduction(0.0), ErrorOfAnySize(0.5) })
  {
    const Result result = Decimate(input, Smoothed(0.3, options), {}, inputs);
    ASSERT_EQ(result.Report.Status, InputStatus::Good);
    EXPECT_GT(result.Report.Smoothing.MaxDisplacement, 0.1);
    EXPECT_EQ(CountTopology(result.Surface).BoundaryEdges, before.BoundaryEdges);
    EXPECT_EQ(result.Report.Proof.Status, ProofStatus::Proved);
  }
}

TEST(SmoothingRun, MovesNonManifoldPointsAsOne)
{
  for (const NamedSurface& shape : BrokenShapes())
  {
    const Result plain = Decimate(shape.Surface, Reduction(0.0));
    Options options = Smoothed(0.05, Reduction(0.0));
    options.AllowLargeError = true;
    const Result result = Decimate(shape.Surface, options);
    ASSERT_EQ(result.Report.Status, plain.Report.Status) << shape.Name;
    if (result.Report.Status == InputStatus::Good && plain.Report.Cleaning.DroppedTriangles == 0)
    {
      EXPECT_TRUE(CountTopology(result.Surface) == CountTopology(plain.Surface)) << shape.Name;
      EXPECT_EQ(result.Report.Proof.Status, ProofStatus::Proved) << shape.Name;
    }
  }
}

TEST(SmoothingRun, KeepsTheErrorRelativeToAReference)
{
  const Surface& reference = TestTorus().Surface;
  const Surface input = Decimate(reference, Error(0.1)).Surface;
  RunInputs inputs;
  inputs.Reference = &reference;
  const Result result = Decimate(input, Smoothed(0.2, Error(0.3)), {}, inputs);
  ASSERT_EQ(result.Report.Status, InputStatus::Good);
  EXPECT_EQ(result.Report.Proof.Status, ProofStatus::Proved);
  EXPECT_LE(ProvedDistanceTo(reference, result.Surface), 0.3);
  EXPECT_GT(result.Report.Smoothing.MaxDisplacement, 0.05);
}

TEST(SmoothingRun, IsLevelZeroOfItsLog)
{
  const Surface& input = TestTorus().Surface;
  Options alone = Smoothed(0.2, Error(0.4));
  alone.TargetReduction = 0.0;
  alone.TargetReductionIsExplicit = true;
  const Surface smoothed = Decimate(input, alone).Surface;
  const Recorded recorded = Record(input, Smoothed(0.2, Error(0.4)));
  ASSERT_EQ(recorded.Run.Report.Status, InputStatus::Good);
  ASSERT_TRUE(recorded.Levels.IsOpen());
  EXPECT_TRUE(SameInAnyOrder(recorded.Levels.At(0).Surface, smoothed));
  EXPECT_TRUE(SameInAnyOrder(
    recorded.Levels.At(recorded.Levels.NumberOfCollapses()).Surface, recorded.Run.Surface));
}

TEST(SmoothingRun, EndsWithAValidSurfaceAfterAnAbort)
{
  const Surface& input = TestTorus().Surface;
  for (const int calls : { 1, 3, 8, 15, 25, 40, 80 })
  {
    int left = calls;
    const Result result =
      Decimate(input, Smoothed(0.2, Error(0.3)), [&](double) { return left-- > 0; });
    EXPECT_EQ(WhatIsWrong(result.Surface), "");
    EXPECT_EQ(result.Report.Stop, StopReason::Aborted);
  }
}

TEST(SmoothingRun, GivesTheSameBytesForAnyNumberOfThreads)
{
  for (const Mode mode : AllModes())
  {
    const Options options =
      FindMode(mode).ProvesError() ? Smoothed(0.1, Error(0.3)) : Smoothed(0.1, Reduction(0.5));
    ExpectTheSameBytesForAnyNumberOfThreads(TestTorus().Surface, InMode(mode, options));
  }
}

TEST(SmoothingRun, AloneLetsPointsAndTrianglesComeFromThemselves)
{
  const Surface& input = TestTorus().Surface;
  RunInputs inputs;
  inputs.WantsOrigins = true;
  const Result result = Decimate(input, Smoothed(0.25, Reduction(0.0)), {}, inputs);
  const SurfaceOrigins& origins = result.Origins;
  ASSERT_EQ(origins.NearestPoint.size(), input.Points.size());
  for (std::size_t p = 0; p < input.Points.size(); ++p)
  {
    const Index own = origins.NearestPoint[p];
    EXPECT_EQ(origins.OutputPoint[own], static_cast<Index>(p));
    const Triangle& corners = input.Triangles[origins.NearestTriangle[p]];
    const auto corner = std::find(corners.begin(), corners.end(), own) - corners.begin();
    ASSERT_LT(corner, 3);
    EXPECT_EQ(origins.Barycentric[p][corner], 1.0);
  }
  ASSERT_EQ(origins.TriangleAtCentroid.size(), input.Triangles.size());
  for (std::size_t t = 0; t < input.Triangles.size(); ++t)
  {
    Triangle from = result.Surface.Triangles[t];
    Triangle own = input.Triangles[origins.TriangleAtCentroid[t]];
    for (Index& corner : from)
    {
      corner = origins.NearestPoint[corner];
    }
    std::sort(from.begin(), from.end());
    std::sort(own.begin(), own.end());
    EXPECT_EQ(from, own);
  }
}

TEST(AutomaticSmoothing, TakesAThirdOfASmallErrorAndHalfAVoxelWithinOne)
{
  const Surface& input = TestTorus().Surface;
  for (const auto& [error, radius] :
    { std::pair(0.0, 0.25), std::pair(0.3, 0.1), std::pair(0.5, 0.25), std::pair(2.0, 0.25) })
  {
    Options options = Automatic(error > 0.0 ? ErrorOfAnySize(error) : Reduction(0.5));
    const Result result = Decimate(input, options);
    EXPECT_NEAR(result.Report.Smoothing.Bound, radius, 1e-9) << error;
    EXPECT_LE(result.Report.Smoothing.MaxDisplacement, radius + 1e-9);
    EXPECT_GT(result.Report.Smoothing.MaxDisplacement, radius > 0.2 ? 0.16 : 0.09) << error;
    EXPECT_EQ(result.Report.Smoothing.From, SmoothingFigures::Source::Binary);
    EXPECT_GE(result.Report.Smoothing.Strength, 1.0);
    EXPECT_LE(result.Report.Smoothing.Strength, 12.0);
  }
}

TEST(AutomaticSmoothing, AloneUsesHalfAVoxel)
{
  const Result result = Decimate(TestTorus().Surface, Automatic(Reduction(0.0)));
  EXPECT_EQ(result.Report.Proof.Status, ProofStatus::Proved);
  EXPECT_NEAR(result.Report.Smoothing.Bound, 0.25, 1e-6);
  EXPECT_GT(result.Report.Smoothing.MaxDisplacement, 0.16);
}

TEST(AutomaticSmoothing, LeavesOtherSurfacesAloneAndSaysSo)
{
  Surface gray = TestTorus().Surface;
  for (std::size_t p = 0; p < gray.Points.size(); ++p)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const bool isAlong = TestTorus().Source.OfPoint[p][axis] % 2 != 0;
      gray.Points[p][axis] += isAlong ? 0.2 * std::sin(3.0 * static_cast<double>(p)) : 0.0;
    }
  }
  const Surface other = BumpySphere(3, 10.0, 0.05, 7);
  for (const auto& [surface, from] :
    { std::pair(static_cast<const Surface*>(&gray), SmoothingFigures::Source::GrayLevel),
      std::pair(&other, SmoothingFigures::Source::Unknown) })
  {
    const Result result = Decimate(*surface, Automatic(Error(0.2)));
    EXPECT_EQ(result.Report.Smoothing.From, from);
    EXPECT_EQ(result.Report.Smoothing.Bound, 0.0);
    EXPECT_TRUE(SameBytes(result.Surface, Decimate(*surface, Error(0.2)).Surface));
    const std::vector<std::string> warnings = InputWarnings(result.Report);
    EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(),
      [](const std::string& warning)
      { return warning.find("was not smoothed") != std::string::npos; }));
    const Result explicitly = Decimate(*surface, Smoothed(0.1, Error(0.2)));
    EXPECT_GT(explicitly.Report.Smoothing.MaxDisplacement, 0.02);
    EXPECT_EQ(explicitly.Report.Proof.Status, ProofStatus::Proved);
  }
}

TEST(AutomaticSmoothing, OfThickSlicesIsInVoxels)
{
  const BinarySurface ball = MarchedShape(Oblique(BallShape(9.0)), 11.0, { 0.5, 0.5, 3.0 });
  const Result free = Decimate(ball.Surface, Automatic(Reduction(0.0)));
  EXPECT_TRUE(free.Report.Smoothing.IsInVoxels);
  EXPECT_NEAR(free.Report.Smoothing.Bound, 1.5, 1e-6);
  EXPECT_EQ(CountChangedVoxels(ball, free.Surface), 0);
  EXPECT_EQ(free.Report.Proof.Status, ProofStatus::Proved);
  const Result bounded = Decimate(ball.Surface, Automatic(Error(0.9)));
  EXPECT_FALSE(bounded.Report.Smoothing.IsInVoxels);
  EXPECT_NEAR(bounded.Report.Smoothing.Bound, 0.25, 1e-6);
}

TEST(AutomaticSmoothing, UsesTheLabelMapOfTheInput)
{
  BinarySurface turned = TestTorus();
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.4, Vector3(1.0, 1.0, 2.0).normalized()).toRotationMatrix();
  turned.Source.Grid.Direction = turn;
  turned.Source.Grid.Origin = turn * turned.Source.Grid.Origin;
  for (Vector3& p : turned.Surface.Points)
  {
    p = turn * p;
  }
  // One point off the grid, so that no grid is found in the points.
  turned.Surface.Points[0] += Vector3(0.01, 0.0, 0.0);
  const Options options = Automatic(Reduction(0.0));
  EXPECT_EQ(
    Decimate(turned.Surface, options).Report.Smoothing.From, SmoothingFigures::Source::Unknown);
  turned.Surface.Points[0] -= Vector3(0.01, 0.0, 0.0);
  RunInputs inputs;
  inputs.LabelMap = &turned.Source;
  const Result result = Decimate(turned.Surface, options, {}, inputs);
  EXPECT_EQ(result.Report.Smoothing.From, SmoothingFigures::Source::LabelMap);
  EXPECT_NEAR(result.Report.Smoothing.Bound, 0.25, 1e-12);
  EXPECT_EQ(CountChangedVoxels(turned, result.Surface), 0);
}
