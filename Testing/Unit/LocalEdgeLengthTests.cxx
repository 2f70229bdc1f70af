// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Edge lengths by an array and by curvature.
#include "LabeledSurfaces.h"
#include "Mesh/Curvature.h"
#include "Proof/Certificate/Certificate.h"
#include "Random.h"
#include "Run/Input/EdgeLengths.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
Options Lengths(double error, double length, double chordal = 0.0)
{
  Options options = InMode(Mode::Fast, Error(error));
  options.EdgeLength = length;
  options.ChordalError = chordal;
  return options;
}

Result RunWithLengths(
  const Surface& surface, const Options& options, const std::vector<double>& lengths)
{
  RunInputs inputs;
  inputs.EdgeLengths = &lengths;
  return Decimate(surface, options, {}, inputs);
}

/// mm, of the edges whose middle is chosen.
template <typename IsChosen>
double MeanEdge(const Surface& surface, const IsChosen& isChosen)
{
  double sum = 0.0;
  double count = 0.0;
  for (const auto& [edge, triangles] : EdgesOf(surface))
  {
    const Vector3& a = surface.Points[edge.first];
    const Vector3& b = surface.Points[edge.second];
    const bool counts = isChosen(Vector3(0.5 * (a + b)));
    sum += counts ? (b - a).norm() : 0.0;
    count += counts ? 1.0 : 0.0;
  }
  return sum / count;
}

std::vector<double> CurvaturesOf(const Surface& surface, double radius)
{
  const CleanSurface clean = Clean(surface, true);
  return MaxCurvatures(HalfEdgeMesh(clean.Surface), PointGraph(clean.Surface), radius, 2);
}

double MedianOf(std::vector<double> numbers)
{
  std::sort(numbers.begin(), numbers.end());
  return numbers[numbers.size() / 2];
}
}

TEST(ChordalLength, IsThatOfATriangleSoFarBelowASphere)
{
  for (const double radius : { 2.0, 10.0, 500.0 })
  {
    for (const double error : { 0.01, 0.3, 2.0 })
    {
      const double side = ChordalLength(1.0 / radius, error);
      const double below = radius - std::sqrt(radius * radius - side * side / 3.0);
      EXPECT_NEAR(below, error, 1e-7 * radius);
    }
  }
  EXPECT_NEAR(ChordalLength(1.0, 5.0), std::sqrt(3.0), 1e-12); // of a great circle
  EXPECT_EQ(ChordalLength(0.0, 0.1), Infinity);
}

TEST(MaxCurvatures, AreThoseOfSpheresCylindersAndPlanes)
{
  EXPECT_NEAR(MedianOf(CurvaturesOf(Icosphere(4, 10.0), 2.0)), 0.1, 0.005);
  EXPECT_NEAR(MedianOf(CurvaturesOf(Icosphere(4, 3.0), 0.6)), 1.0 / 3.0, 0.02);
  EXPECT_NEAR(MedianOf(CurvaturesOf(TurnedInsideOut(Icosphere(4, 10.0)), 2.0)), 0.1, 0.005);
  EXPECT_LT(MedianOf(CurvaturesOf(FlatPlate(20), 2.0)), 1e-9);
  const Surface tube = OpenCylinder(48, 30);
  const double radius = std::hypot(tube.Points[0].x(), tube.Points[0].y());
  EXPECT_NEAR(MedianOf(CurvaturesOf(tube, 0.5 * radius)) * radius, 1.0, 0.05);
}

TEST(MaxCurvatures, AverageNoise)
{
  // Noise of a hundredth of the radius has a curvature of its own, with both signs.
  const Surface noisy = BumpySphere(4, 10.0, 0.01, 5);
  const double fine = MedianOf(CurvaturesOf(noisy, 0.0));
  const double coarse = MedianOf(CurvaturesOf(noisy, 3.0));
  EXPECT_GT(fine, 0.2);
  EXPECT_NEAR(coarse, 0.1, 0.05);
}

TEST(GradeLengths, LimitsTheChangeAlongEdgesAndOnlyShortens)
{
  const Surface surface = BumpySphere(3, 10.0, 0.02, 7);
  Random random(3);
  std::vector<double> given(surface.Points.size());
  std::generate(given.begin(), given.end(), [&] { return random.Between(0.5, 8.0); });
  std::vector<double> graded = given;
  GradeLengths(surface, PointGraph(surface), 0.3, graded);
  for (const auto& [edge, triangles] : EdgesOf(surface))
  {
    const double length = (surface.Points[edge.first] - surface.Points[edge.second]).norm();
    const double change = std::abs(graded[edge.first] - graded[edge.second]);
    EXPECT_LE(change, 0.3 * length * (1.0 + 1e-12));
  }
  bool hasSameLeast = false;
  const double least = *std::min_element(given.begin(), given.end());
  for (std::size_t p = 0; p < given.size(); ++p)
  {
    EXPECT_LE(graded[p], given[p]);
    hasSameLeast = hasSameLeast || graded[p] == least;
  }
  EXPECT_TRUE(hasSameLeast);
}

TEST(EdgeLengthArray, DecidesTheDensityAndTheProofRemains)
{
  const Surface sphere = BumpySphere(4, 20.0, 0.02, 11);
  for (const double direction : { 1.0, -1.0 })
  {
    std::vector<double> lengths;
    for (const Vector3& point : sphere.Points)
    {
      lengths.push_back(direction * point.x() < 0.0 ? 2.5 : 7.0);
    }
    const Result result = RunWithLengths(sphere, Lengths(1.2, 7.0), lengths);
    const double fine =
      MeanEdge(result.Surface, [&](const Vector3& p) { return direction * p.x() < -4.0; });
    const double coarse =
      MeanEdge(result.Surface, [&](const Vector3& p) { return direction * p.x() > 14.0; });
    EXPECT_NEAR(fine, 2.5, 0.4);
    EXPECT_NEAR(coarse, 6.4, 1.4);
    EXPECT_EQ(result.Report.Edges.Longer, 0);
    EXPECT_NEAR(result.Report.Edges.MinRequested, 2.5, 1e-9);
    EXPECT_EQ(result.Report.Proof.Status, ProofStatus::Proved);
    EXPECT_LE(Certify(sphere, result.Surface).Upper(), 1.2);
  }
}

TEST(EdgeLengthArray, IsCappedByEdgeLength)
{
  const Surface sphere = BumpySphere(3, 20.0, 0.02, 11);
  const std::vector<double> far(sphere.Points.size(), 1e6);
  const Result result = RunWithLengths(sphere, Lengths(1.2, 6.0), far);
  const Result plain = Decimate(sphere, Lengths(1.2, 6.0));
  EXPECT_EQ(result.Report.Edges.MinRequested, 6.0);
  EXPECT_NEAR(static_cast<double>(result.Surface.Triangles.size()),
    static_cast<double>(plain.Surface.Triangles.size()),
    0.02 * static_cast<double>(plain.Surface.Triangles.size()));
}

TEST(EdgeLengthArray, HasOneNumberAboveZeroForEachPoint)
{
  const Surface sphere = Icosphere(2, 10.0);
  const auto status = [&](const std::vector<double>& lengths)
  { return RunWithLengths(sphere, Lengths(0.5, 3.0), lengths).Report; };
  std::vector<double> lengths(sphere.Points.size(), 2.0);
  EXPECT_EQ(status(lengths).Status, InputStatus::Good);
  for (const double bad : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), Infinity })
  {
    lengths[5] = bad;
    lengths[9] = bad;
    const Report report = status(lengths);
    EXPECT_EQ(report.Status, InputStatus::BadEdgeLengths);
    EXPECT_EQ(report.Cleaning.BadEdgeLengths, 2);
    EXPECT_EQ(report.Cleaning.FirstBadEdgeLength, 5);
    EXPECT_NE(InputMessage(report).find("edge length"), std::string::npos);
  }
  lengths.assign(sphere.Points.size() - 1, 2.0);
  EXPECT_EQ(status(lengths).Status, InputStatus::BadEdgeLengths);
}

TEST(EdgeLengthArray, GivesTheSameBytesWhateverTheThreads)
{
  const Surface bone = BumpySphere(4, 20.0, 0.02, 11);
  std::vector<double> lengths;
  for (const Vector3& point : bone.Points)
  {
    lengths.push_back(3.0 + 0.1 * point.z());
  }
  Options options = Lengths(0.6, 5.0, 0.2);
  const Result one = RunWithLengths(bone, options, lengths);
  options.NumberOfThreads = 3;
  const Result three = RunWithLengths(bone, options, lengths);
  EXPECT_EQ(one.Surface.Triangles, three.Surface.Triangles);
  EXPECT_EQ(one.Surface.Points, three.Surface.Points);
}

TEST(EdgeLengthArray, RunsTheWholeSurfaceWhereOnlyRegionsMayChange)
{
  const Surface sphere = BumpySphere(3, 20.0, 0.02, 11);
  std::vector<double> tolerances;
  for (const Vector3& point : sphere.Points)
  {
    tolerances.push_back(point.z() > 14.0 ? 0.5 : 0.0);
  }
  const std::vector<double> lengths(sphere.Points.size(), 3.0);
  RunInputs inputs;
  inputs.Tolerances = &tolerances;
  EXPECT_EQ(
    Decimate(sphere, Lengths(0.5, 3.0), {}, inputs).Report.Regions.Status, RegionStatus::Used);
  inputs.EdgeLengths = &lengths;
  EXPECT_EQ(Decimate(sphere, Lengths(0.5, 3.0), {}, inputs).Report.Regions.Status,
    RegionStatus::OtherOptions);
}

TEST(ChordalError, MakesEdgesShorterWhereTheSurfaceIsCurved)
{
  const Surface both = Together(Icosphere(4, 4.0), Moved(Icosphere(5, 16.0), { 60.0, 0.0, 0.0 }));
  const Result result = Decimate(both, Lengths(1.0, 8.0, 0.2));
  const double small = MeanEdge(result.Surface, [](const Vector3& p) { return p.x() < 20.0; });
  const double large = MeanEdge(result.Surface, [](const Vector3& p) { return p.x() > 20.0; });
  EXPECT_NEAR(small, ChordalLength(1.0 / 4.0, 0.2), 0.3);
  EXPECT_NEAR(large, ChordalLength(1.0 / 16.0, 0.2), 0.6);
  EXPECT_EQ(result.Report.Proof.Status, ProofStatus::Proved);
  // The error of the triangles is about the one requested, far below the bound.
  const double distance = Certify(both, result.Surface).Upper();
  EXPECT_GT(distance, 0.1);
  EXPECT_LT(distance, 0.6);
}

TEST(ChordalError, ShortensToATenthAtMost)
{
  const Surface sphere = Icosphere(4, 4.0);
  const Result result = Decimate(sphere, Lengths(0.5, 10.0, 1e-4));
  EXPECT_NEAR(result.Report.Edges.MinRequested, 1.0, 1e-9);
}

TEST(ChordalError, GradesAcrossLabels)
{
  const Surface ball = HalvedBall(8);
  const Labels labels = PatchesAsLabels(ball);
  const Result result = RunWith(labels, ball, Lengths(0.8, 4.0, 0.2));
  ASSERT_EQ(result.Report.Status, InputStatus::Good);
  EXPECT_EQ(result.Report.Proof.Status, ProofStatus::Proved);
  EXPECT_LT(result.Report.Edges.MinRequested, 4.0);
}
