// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Crossings.h"
#include "Mesh/Statistics.h"
#include "Proof/Certificate/Certificate.h"
#include "Run/Decimate.h"
#include "SlabRuns.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bonedecimate::testsupport
{
namespace
{
constexpr std::array<Index, 3> Block = { 22, 20, 41 };
constexpr double Error = 0.4; // mm

/// A torus around a line that is not along the slabs, with bumps, a wall and small balls, one of
/// them cut by the plane at 20.
double Torus(const Vector3& p)
{
  const Vector3 q = p - Vector3(10.6, 8.7, 19.8);
  const double around = std::hypot(1.7 * q.x(), q.z()) - 11.2;
  return 2.9 + 0.3 * std::sin(1.9 * p.x()) * std::cos(1.7 * p.z()) - std::hypot(around, q.y());
}
double Walls(const Vector3& p)
{
  return 0.9 - std::abs(p.y() - 15.6 - 0.6 * std::sin(0.4 * p.x())) -
    std::max(0.0, std::hypot(p.x() - 10.0, p.z() - 19.0) - 8.0);
}
double Ball(const Vector3& p)
{
  return 2.3 - (p - Vector3(3.1, 2.9, 19.7)).norm();
}
double Everything(const Vector3& p)
{
  return std::max({ Torus(p), Walls(p), Ball(p) });
}

Options SlabOptions(Mode mode, int threads = 2)
{
  Options options;
  options.Mode = mode;
  options.MaximumError = Error;
  options.NumberOfThreads = threads;
  return options;
}

double ProvedError(const Surface& original, const Surface& result)
{
  CertificateOptions question;
  question.Tolerance = Error;
  question.TightBounds = false;
  const Certificate found = Certify(original, result, question);
  return found.Proof == ProofStatus::Proved
    ? std::max({ found.Upper(), found.BoundaryOfReferenceToResult.Distance.Upper,
        found.BoundaryOfResultToReference.Distance.Upper })
    : 1e9;
}

std::vector<double> Tops(int count)
{
  std::vector<double> tops;
  for (int i = 1; i <= count; ++i)
  {
    tops.push_back(std::round(40.0 * i / count) + (i == count ? 2.0 : 0.0));
  }
  return tops;
}

/// In one order, so that surfaces with other numbers can be compared.
std::vector<std::array<double, 9>> SortedTriangles(const Surface& surface)
{
  std::vector<std::array<double, 9>> sorted;
  for (const Triangle& c : surface.Triangles)
  {
    std::array<std::array<double, 3>, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Vector3& p = surface.Points[c[i]];
      corners[i] = { p[0], p[1], p[2] };
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    std::array<double, 9> row;
    for (std::size_t i = 0; i < 9; ++i)
    {
      row[i] = corners[i / 3][i % 3];
    }
    sorted.push_back(row);
  }
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}
}

class SlabRunTest : public testing::TestWithParam<std::tuple<Mode, int>>
{
};

TEST_P(SlabRunTest, KeepsTheErrorAndTheTopologyOfTheWhole)
{
  const auto [mode, count] = GetParam();
  const Surface whole = SurfaceOfFunction(Block, Everything);
  const Options options = SlabOptions(mode);
  const SlabOutcome outcome = RunInSlabs(CutAtLayers(whole, {}, Tops(count)), options);
  ASSERT_EQ(outcome.Status, SlabStatus::Good);
  const Report& report = outcome.Result.Report;
  const SurfaceStatistics before = Describe(whole);
  EXPECT_EQ(report.Input.Faces, before.Faces);
  EXPECT_EQ(report.Input.Components, before.Components);
  EXPECT_NEAR(report.Input.Volume, before.Volume, 1e-6 * before.Volume);
  EXPECT_EQ(report.Output.Components, before.Components);
  EXPECT_EQ(report.Output.EulerNumber, before.EulerNumber);
  EXPECT_EQ(report.Output.BoundaryEdges, 0);
  EXPECT_EQ(report.Output.NonManifoldEdges, before.NonManifoldEdges);
  EXPECT_LE(ProvedError(whole, outcome.Result.Surface), Error);
  EXPECT_EQ(report.Proof.Status, ProofStatus::Proved);
  EXPECT_LE(report.Proof.Upper(), Error);
  EXPECT_EQ(CountCrossings(outcome.Result.Surface), 0);
  EXPECT_EQ(outcome.Figures.UnprovedSlabs, 0);
  const Result together = Decimate(whole, options);
  EXPECT_LE(report.Output.Faces, 1.05 * together.Report.Output.Faces + 8);
}

INSTANTIATE_TEST_SUITE_P(ModesAndSlabs, SlabRunTest,
  testing::Values(std::tuple(Mode::Fast, 4), std::tuple(Mode::Balanced, 2)));

TEST(SlabRun, IsTheSameForAnyNumberOfThreadsAndOrder)
{
  const Surface whole = SurfaceOfFunction(Block, Everything);
  std::vector<Slab> slabs = CutAtLayers(whole, {}, Tops(2));
  const SlabOutcome one = RunInSlabs(slabs, SlabOptions(Mode::Fast, 1));
  const SlabOutcome three = RunInSlabs(slabs, SlabOptions(Mode::Fast, 3));
  EXPECT_EQ(one.Result.Surface.Points, three.Result.Surface.Points);
  EXPECT_EQ(one.Result.Surface.Triangles, three.Result.Surface.Triangles);
  for (Slab& slab : slabs)
  {
    std::reverse(slab.Surface.Triangles.begin(), slab.Surface.Triangles.end());
  }
  const SlabOutcome reversed = RunInSlabs(slabs, SlabOptions(Mode::Fast, 1));
  EXPECT_EQ(SortedTriangles(one.Result.Surface), SortedTriangles(reversed.Result.Surface));
}

TEST(SlabRun, KeepsBoundariesThatCrossPlanes)
{
  const Surface whole = SurfaceOfFunction(
    Block,
    [](const Vector3& p)
    { return 6.0 + std::sin(0.3 * p.z()) - std::hypot(p.x() - 10.3, 0.7 * (p.y() - 14.0)); },
    false);
  ASSERT_GT(Describe(whole).BoundaryEdges, 100);
  const SlabOutcome outcome =
    RunInSlabs(CutAtLayers(whole, {}, { 13.0, 27.0, 40.0 }), SlabOptions(Mode::Fast));
  ASSERT_EQ(outcome.Status, SlabStatus::Good);
  EXPECT_LE(ProvedError(whole, outcome.Result.Surface), Error);
  EXPECT_EQ(Describe(outcome.Result.Surface).EulerNumber, Describe(whole).EulerNumber);
  const ErrorProof& proof = outcome.Result.Report.Proof;
  EXPECT_EQ(proof.Status, ProofStatus::Proved);
  EXPECT_EQ(proof.Boundaries, BoundaryPresence::Both);
  EXPECT_GT(proof.BoundaryInputToOutput.Upper, 0.0);
  EXPECT_LE(proof.Upper(), Error);
}

TEST(SlabRun, KeepsLabelsAndTheirVoxels)
{
  const LabelMap map = MakeLabelMap(Block,
    [](const std::array<Index, 3>& v)
    {
      const Vector3 p(v[0], v[1], v[2]);
      return Torus(p) < 0.0 ? 0 : std::abs(p.x() - 10.0) < 0.3 * std::abs(p.z() - 3.0) ? 3 : 5;
    });
  const LabelSurfaces whole = Extracted(map);
  SlabInputs inputs;
  inputs.LabelMap = whole.Source;
  inputs.LabelMap.OfTriangle.clear();
  inputs.LabelMap.OfPoint.clear();
  Options options = SlabOptions(Mode::Fast);
  options.KeepVoxels = KeepVoxels::On;
  const SlabOutcome outcome =
    RunInSlabs(CutAtLayers(whole.Surface, whole.Source.OfTriangle, Tops(2)), options, inputs);
  ASSERT_EQ(outcome.Status, SlabStatus::Good);
  const Result& result = outcome.Result;
  ASSERT_EQ(result.BoundaryLabels.size(), result.Surface.Triangles.size());
  EXPECT_LE(ProvedError(whole.Surface, result.Surface), Error);
  const Index background = whole.Source.Background();
  EXPECT_EQ(VoxelizeLabels(result.Surface, result.BoundaryLabels, map.Grid, background, 0),
    VoxelizeLabels(whole.Surface, whole.Source.OfTriangle, map.Grid, background, 0));
  RunInputs together;
  together.LabelMap = &whole.Source;
  EXPECT_LE(result.Surface.Triangles.size(),
    1.05 * Decimate(whole.Surface, options, {}, together).Surface.Triangles.size() + 8);
}

TEST(SlabRun, TakesEmptyAndThinSlabs)
{
  const Surface whole = SurfaceOfFunction(Block, Ball);
  std::vector<double> tops = { 2.0, 5.0, 18.0, 19.0, 20.0, 21.0, 22.0, 41.0, 43.0 };
  const SlabOutcome outcome = RunInSlabs(CutAtLayers(whole, {}, tops), SlabOptions(Mode::Fast));
  ASSERT_EQ(outcome.Status, SlabStatus::Good);
  EXPECT_LE(ProvedError(whole, outcome.Result.Surface), Error);
  EXPECT_EQ(Describe(outcome.Result.Surface).BoundaryEdges, 0);
  EXPECT_EQ(Describe(outcome.Result.Surface).EulerNumber, 2);
}

/// Wherever the surface ends below the last planes: with the strip of the next run in reach or not,
/// with the original or not.
TEST(SlabRun, TakesSurfacesThatEndBelowEmptySlabs)
{
  const Surface whole = SurfaceOfFunction(Block, Ball);
  for (double top = 22.5; top < 42.0; top += 0.5)
  {
    const SlabOutcome outcome =
      RunInSlabs(CutAtLayers(whole, {}, { 20.0, top, 42.0, 43.0 }), SlabOptions(Mode::Fast));
    ASSERT_EQ(outcome.Status, SlabStatus::Good) << top;
    EXPECT_LE(ProvedError(whole, outcome.Result.Surface), Error) << top;
    EXPECT_EQ(Describe(outcome.Result.Surface).EulerNumber, 2) << top;
  }
}

TEST(SlabRun, RejectsWhatItCannotDo)
{
  Options options = SlabOptions(Mode::Fast);
  EXPECT_EQ(SlabRun(options, {}).Status(), SlabStatus::Good);
  options.Smoothing = 0.1;
  EXPECT_EQ(SlabRun(options, {}).Status(), SlabStatus::BadOptions);
  EXPECT_NE(SlabRun(options, {}).Message(), "");
  options = SlabOptions(Mode::Thesis);
  EXPECT_EQ(SlabRun(options, {}).Status(), SlabStatus::BadOptions);
  options = SlabOptions(Mode::Fast);
  options.TargetNumberOfTriangles = 100;
  EXPECT_EQ(SlabRun(options, {}).Status(), SlabStatus::BadOptions);

  const std::vector<Slab> slabs = CutAtLayers(SurfaceOfFunction(Block, Ball), {}, { 20.0, 43.0 });
  SlabRun run(SlabOptions(Mode::Fast), { Vector3::UnitZ(), -2.0 });
  EXPECT_EQ(run.Add(slabs[0]), SlabStatus::Good);
  Slab low = slabs[1];
  low.Top = 20.5;
  EXPECT_EQ(run.Add(low), SlabStatus::BadSlab);
  EXPECT_NE(run.Message(), "");
  EXPECT_TRUE(run.Finish().Surface.Triangles.empty());
}
}
