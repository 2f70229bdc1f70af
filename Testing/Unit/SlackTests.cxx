// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Edits by how much of the error bound is left: compared with brute force, with the mesh before,
// and with the certificate.
#include "Decimate/Stages/FanSearch.h"
#include "Decimate/Stages/SlackCandidates.h"
#include "Decimate/Stages/SlackRefinement.h"
#include "Mesh/Invariants.h"
#include "Random.h"
#include "Runs.h"
#include "SlackBench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

TEST(FanSearch, FindsTheNearestFaceOfFansThatAreNotConvex)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int fan = 0; fan < 300; ++fan)
  {
    const std::size_t count = 5 + random() % 5;
    std::vector<Vector3> corners;
    for (std::size_t i = 0; i < count; ++i)
    {
      const double angle = 2.0 * 3.14159265358979 * (static_cast<double>(i) + 0.6 * unit(random)) /
        static_cast<double>(count);
      const double radius = 0.3 + 2.0 * unit(random);
      corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    }
    std::vector<TriangleFrame> frames;
    for (std::size_t i = 0; i < count; ++i)
    {
      frames.emplace_back(Vector3::Zero(), corners[i], corners[(i + 1) % count]);
    }
    const Vector3 p(4.0 * unit(random) - 2.0, 4.0 * unit(random) - 2.0, 0.2);
    double least = 1e9; // mm^2
    for (const TriangleFrame& frame : frames)
    {
      least = std::min(least, frame.Nearest(p).SquaredDistance);
    }
    for (std::size_t start = 0; start < count; ++start)
    {
      std::size_t slot = start;
      EXPECT_NEAR(FindInWholeFan(frames, p, slot).SquaredDistance, least, 1e-12);
      EXPECT_NEAR(frames[slot].Nearest(p).SquaredDistance, least, 1e-12);
    }
  }
}

TEST(SlackCandidates, RatiosDoNotDependOnTheFacesWhereSamplesWereBefore)
{
  const Bench bench(0.1, Icosphere(4, 10.0));
  std::vector<SlackCandidate> candidates;
  SlackCandidates(bench.MeshEditor, bench.Fit, bench.Back, 1.4, 1).Find(Always, candidates);
  EXPECT_GT(candidates.size(), 100U);
  SlackFit slack(bench.MeshEditor, bench.Fit, bench.Back);
  EditWorkspace work;
  for (const SlackCandidate& candidate : candidates)
  {
    EXPECT_TRUE(bench.MeshEditor.Gather(candidate.Edge, work).IsAccepted());
    SlackCandidates::Gather(bench.Mesh(), work.Neighborhood, slack);
    EXPECT_NEAR(slack.Evaluate(candidate.Position, candidate.Hint).MaxRatio, candidate.Ratio, 1e-6);
  }
}

TEST(SlackFit, MeasuresSamplesAsBruteForceDoes)
{
  const Bench bench;
  SlackFit slack(bench.MeshEditor, bench.Fit, bench.Back);
  const VertexId vertex = bench.FirstVertex();
  const std::vector<FaceId> faces = bench.Gather(vertex, slack);
  const Vector3 position = 0.95 * bench.Mesh().Position(vertex);
  const double found = slack.MaxRatioOfSamples(position, 1e9);
  double expected = 0.0; // limits
  for (const FaceId face : faces)
  {
    bench.Fit.VisitFace(face,
      [&](const Samples::Sample& sample)
      {
        double least = 1e9; // mm
        for (const HalfEdgeId h : bench.Mesh().OutgoingOf(vertex))
        {
          const TriangleFrame frame(position, bench.Mesh().Position(bench.Mesh().Target(h)),
            bench.Mesh().Position(bench.Mesh().Apex(h)));
          least = std::min(
            least, std::sqrt(frame.Nearest(bench.Fit.SamplePosition(sample)).SquaredDistance));
        }
        expected = std::max(expected, least / sample.Limit);
      });
  }
  EXPECT_GT(expected, 0.5);
  EXPECT_NEAR(found, expected, 1e-6);
}

TEST(SlackFit, StepsLowerTheLargestDistance)
{
  const Bench bench;
  SlackFit slack(bench.MeshEditor, bench.Fit, bench.Back);
  const VertexId vertex = bench.FirstVertex();
  bench.Gather(vertex, slack);
  Vector3 position = 1.06 * bench.Mesh().Position(vertex);
  const double before = slack.Evaluate(position, bench.Back.Of(vertex)).MaxRatio;
  EXPECT_GT(before, 1.9); // the vertex itself
  const SlackFit::Value after = slack.Improve(position, bench.Back.Of(vertex), 8);
  EXPECT_LT(after.MaxRatio, 1.01);
  EXPECT_NEAR(slack.Evaluate(position, after.Hint).MaxRatio, after.MaxRatio, 1e-9);
}

TEST(SlackFit, GivesUpAtTheErrorThatIsEnough)
{
  const Bench bench;
  SlackFit slack(bench.MeshEditor, bench.Fit, bench.Back);
  const VertexId vertex = bench.FirstVertex();
  bench.Gather(vertex, slack);
  const Vector3 position = bench.Mesh().Position(vertex);
  const SlackFit::Value whole = slack.Evaluate(position, bench.Back.Of(vertex));
  EXPECT_GT(slack.Evaluate(position, whole.Hint, 0.9 * whole.Error).Error, 1e300);
  EXPECT_EQ(slack.Evaluate(position, whole.Hint, 1.1 * whole.Error).Error, whole.Error);
}

TEST(SlackRefinement, CollapsesMoreAfterSweepsAndKeepsTheBound)
{
  std::array<Index, 2> faces{};
  for (const int sweeps : { 0, 2 })
  {
    Bench bench(Limit, BumpySphere(3, 10.0, 0.2, 7));
    SlackRefinement slack(bench.MeshEditor, 1);
    EXPECT_TRUE(slack.Begin(Always) && slack.Sweep(sweeps, Always) && slack.Collapse(0, Always));
    faces[sweeps > 0 ? 1 : 0] = bench.Mesh().NumberOfFaces();
    EXPECT_EQ(BrokenInvariant(bench.Mesh()), "");
    EXPECT_EQ(bench.Certified(Limit), ProofStatus::Proved);
  }
  EXPECT_LT(faces[1], faces[0]);
}

TEST(SlackRefinement, StopsAtTheNumberOfFaces)
{
  Bench bench;
  SlackRefinement slack(bench.MeshEditor, 1);
  const Index target = bench.Mesh().NumberOfFaces() - 4;
  EXPECT_TRUE(slack.Begin(Always) && slack.Sweep(1, Always) && slack.Collapse(target, Always));
  EXPECT_EQ(bench.Mesh().NumberOfFaces(), target);
}

TEST(SlackRefinement, GivesVolumeBack)
{
  Bench bench(Limit, BumpySphere(3, 10.0, 0.2, 7));
  SlackRefinement slack(bench.MeshEditor, 1);
  EXPECT_TRUE(slack.Begin(Always) && slack.Sweep(2, Always) && slack.Collapse(0, Always));
  const double input = VolumeOf(bench.Cleaned.Surface);
  const double before = VolumeOf(SurfaceOf(bench.Mesh()));
  EXPECT_TRUE(slack.RestoreVolume(Always));
  const double after = VolumeOf(SurfaceOf(bench.Mesh()));
  EXPECT_GT(std::abs(before - input), 0.0004 * input);
  EXPECT_LT(std::abs(after - input), 0.3 * std::abs(before - input));
  EXPECT_EQ(BrokenInvariant(bench.Mesh()), "");
  EXPECT_EQ(bench.Certified(Limit), ProofStatus::Proved);
}

TEST(SlackRefinement, MovesNothingFarWhereNothingLimits)
{
  const Surface sphere = BumpySphere(3, 10.0, 0.03, 7);
  double farthest = 0.0; // mm, from the center
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
  {
    Random random(seed);
    std::vector<double> tolerances;
    for (std::size_t i = 0; i < sphere.Points.size(); ++i)
    {
      tolerances.push_back(random.Below(3) == 0 ? -1.0 : random.Between(0.05, 0.6));
    }
    RunInputs inputs;
    inputs.Tolerances = &tolerances;
    Options options = Triangles(240);
    options.OutputPointsPrecision = PointsPrecision::Double;
    for (const Vector3& p : Decimate(sphere, options, {}, inputs).Surface.Points)
    {
      farthest = std::max(farthest, p.norm());
    }
  }
  EXPECT_LT(farthest, 11.0);
}
