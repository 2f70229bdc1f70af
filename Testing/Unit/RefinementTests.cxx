// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Flips, moves and collapses by sampled error, and the modes made of them.
#include "BruteForce.h"
#include "Decimate/Schedule/BucketSweep.h"
#include "Decimate/Stages/EdgeFlipper.h"
#include "Decimate/Stages/ErrorCollapse.h"
#include "Decimate/Stages/FitStep.h"
#include "Decimate/Stages/VertexBlocks.h"
#include "Decimate/Stages/VertexMover.h"
#include "Mesh/Invariants.h"
#include "Mesh/SpatialOrder.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
const Monitor GoOn = [](double) { return true; };
const VertexRange Everything = VertexRange();

/// In the order of a run, so that blocks of vertices are connected regions.
CleanSurface Sorted(const Surface& surface)
{
  CleanSurface cleaned = Clean(surface, true);
  SortAlongCurve(cleaned, 1);
  return cleaned;
}

/// A surface after a sweep, with samples.
class Bench
{
public:
  Bench(const Surface& surface, Index divisor)
    : Cleaned(Sorted(surface))
    , MeshEditor(this->Cleaned, EditorSettings{ false, false, true })
    , Original(this->MeshEditor.Mesh())
    , Fit(this->Original)
    , Back(this->Original)
    , FaceErrors(static_cast<std::size_t>(this->Original.NumberOfFaceSlots()), -1.0F)
  {
    BucketSweep(this->MeshEditor, 1).Run({ this->Original.NumberOfFaces() / divisor, 0.0 }, GoOn);
    this->Back.Restart(this->MeshEditor.Mesh(), 1, GoOn);
    this->Fit.Distribute(
      this->MeshEditor.Mesh(), this->MeshEditor.Original().CurrentOfInitial(), 1, GoOn);
    this->MeshEditor.PrepareCollapses(1);
  }

  const HalfEdgeMesh& Mesh() const { return this->MeshEditor.Mesh(); }

  template <typename Visit>
  void ForEachVertex(Visit visit)
  {
    for (Index v = 0; v < this->Mesh().NumberOfVertexSlots(); ++v)
    {
      if (this->Mesh().Outgoing(v) != None &&
        this->Mesh().Constraint(v) != VertexConstraint::NonManifold)
      {
        visit(v);
      }
    }
  }

  Index FlipAll()
  {
    EdgeFlipper flipper(this->MeshEditor, this->Fit, this->Back, this->FaceErrors, Everything, 1);
    Index flips = 0;
    this->ForEachVertex([&](Index v) { flips += flipper.Improve(v); });
    return flips;
  }

  Index MoveAll()
  {
    VertexMover mover(this->MeshEditor, this->Fit, this->Back, Everything, 1);
    Index moves = 0;
    this->ForEachVertex([&](Index v) { moves += mover.Improve(v) ? 1 : 0; });
    return moves;
  }

  bool CollapseTo(Index faces, int threads = 1)
  {
    this->MeshEditor.PrepareCollapses(1);
    return ErrorCollapse(this->MeshEditor, this->Fit, this->Back, 4, threads).Run(faces, GoOn);
  }

  /// Where the corners of all faces lie, mm.
  std::vector<Vector3> Corners() const
  {
    std::vector<Vector3> corners;
    for (Index face = 0; face < this->Mesh().NumberOfFaceSlots(); ++face)
    {
      for (Index k = 0; this->Mesh().IsAlive(face) && k < 3; ++k)
      {
        corners.push_back(
          this->Mesh().Position(this->Mesh().Origin(HalfEdgeMesh::HalfEdge(face, k))));
      }
    }
    return corners;
  }

  /// Over all samples, each to the face in whose list it is.
  double SampledError() const
  {
    const ThreeHalves penalty(this->Original.Unit());
    double error = 0.0;
    for (Index face = 0; face < this->Mesh().NumberOfFaceSlots(); ++face)
    {
      this->Fit.VisitFace(face,
        [&](const Samples::Sample& sample)
        {
          const Vector3 p = this->Fit.SamplePosition(sample);
          error +=
            sample.Weight * penalty.Of(FrameOf(this->Mesh(), face).Nearest(p).SquaredDistance);
        });
    }
    return error;
  }

  Index SamplesListed() const
  {
    Index count = 0;
    for (Index face = 0; face < this->Mesh().NumberOfFaceSlots(); ++face)
    {
      this->Fit.VisitFace(face, [&](const Samples::Sample&) { ++count; });
    }
    return count;
  }

  CleanSurface Cleaned;
  Editor MeshEditor;
  HalfEdgeMesh Original;
  Samples Fit;
  OriginalHints Back;
  std::vector<float> FaceErrors;
};

/// The mean distance both ways by brute force over the vertices: independent of the measure used in
/// the loop.
double BruteDistance(const Surface& a, const Surface& b)
{
  double sum = 0.0;
  for (const Vector3& p : a.Points)
  {
    sum += BruteNearest(b, p).Distance;
  }
  return sum / static_cast<double>(a.Points.size());
}
}

class EachRefinement : public EachShape
{
};

TEST_P(EachRefinement, KeepsTheInvariantsAndEverySampleAfterEveryEdit)
{
  Bench bench(GetParam().Surface, 3);
  std::string broken;
  bench.MeshEditor.SetHook([&](const Editor& editor, const Edit&)
    { broken = broken.empty() ? BrokenInvariant(editor.Mesh()) : broken; });
  for (int sweep = 0; sweep < 2; ++sweep)
  {
    bench.FlipAll();
    EXPECT_EQ(bench.SamplesListed(), bench.Fit.Count());
    bench.MoveAll();
    bench.Fit.Settle(bench.Mesh(), 1, GoOn);
    std::fill(bench.FaceErrors.begin(), bench.FaceErrors.end(), -1.0F);
    const Index faces = bench.Mesh().NumberOfFaces();
    EXPECT_TRUE(bench.CollapseTo(faces * 4 / 5));
    EXPECT_EQ(bench.SamplesListed(), bench.Fit.Count());
    EXPECT_GE(bench.Mesh().NumberOfFaces(), faces * 4 / 5 - 1);
  }
  EXPECT_EQ(broken, "");
}

TEST_P(EachRefinement, NeverRaisesTheSampledErrorByFlips)
{
  Bench bench(GetParam().Surface, 4);
  const double before = bench.SampledError();
  bench.FlipAll();
  EXPECT_LE(bench.SampledError(), before * (1.0 + 1e-6));
}

TEST_P(EachRefinement, VisitsEveryUnconstrainedVertexOnceForAnyNumberOfThreads)
{
  const HalfEdgeMesh mesh(Clean(GetParam().Surface, true).Surface);
  VertexBlocks blocks(mesh);
  for (const int threads : { 1, 3 })
  {
    std::vector<int> visits(static_cast<std::size_t>(mesh.NumberOfVertexSlots()), 0);
    EXPECT_TRUE(blocks.ForEach(mesh, threads, GoOn,
      [&](VertexRange) { return [&](Index v) { ++visits[static_cast<std::size_t>(v)]; }; }));
    for (Index v = 0; v < mesh.NumberOfVertexSlots(); ++v)
    {
      EXPECT_EQ(visits[static_cast<std::size_t>(v)],
        mesh.Constraint(v) == VertexConstraint::NonManifold ? 0 : 1);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, EachRefinement, testing::ValuesIn(AllShapes()), NameOf);

TEST(FitStep, BringsAVertexOntoThePlaneOfTheSamplesInAFewSteps)
{
  Vector3 vertex(0.0, 0.0, 0.5);
  const std::array<Vector3, 4> ring = { Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(-1, 0, 0),
    Vector3(0, -1, 0) };
  for (int i = 0; i < 10; ++i)
  {
    FitStep step;
    for (std::size_t k = 0; k < 4; ++k)
    {
      const TriangleFrame frame(vertex, ring[k], ring[(k + 1) % 4]);
      const Vector3 p = (ring[k] + ring[(k + 1) % 4]) / 4.0; // on the plane z = 0
      step.AddSample(p, frame, frame.Nearest(p), 1.0);
    }
    EXPECT_GE(step.Gain(step.Solve()), 0.0);
    vertex += step.Solve();
  }
  EXPECT_LT(vertex.norm(), 1e-3);
}

TEST(ThreeHalves, IsItsPowerAndFitsWithTheWeightOfItsSlope)
{
  const ThreeHalves penalty(0.25);
  for (const double d : { 0.01, 0.3, 2.0 })
  {
    const double expected = std::pow(d / 0.25, 1.5);
    EXPECT_NEAR(penalty.Of(d * d), expected, 1e-12 * expected);
    const Penalty result = penalty.WithWeight(2.0, d * d);
    EXPECT_NEAR(result.Value, 2.0 * expected, 1e-12 * expected);
    const double h = 1e-6 * d;
    const double slope =
      (penalty.Of((d + h) * (d + h)) - penalty.Of((d - h) * (d - h))) / (2.0 * h);
    EXPECT_NEAR(result.Weight * d, slope, 1e-6 * slope);
  }
  EXPECT_EQ(penalty.Of(0.0), 0.0);
  EXPECT_TRUE(std::isfinite(penalty.WithWeight(1.0, 0.0).Weight));
}

TEST(RefinedModes, AreCloserToTheInputTheMoreTheyDo)
{
  const Surface input = BumpySphere(4, 20.0, 0.05, 8);
  for (const double fraction : { 0.5, 0.8, 0.9 })
  {
    std::vector<double> there;
    std::vector<double> back;
    for (const Mode mode : ProvingModes())
    {
      const Surface output = Decimate(input, InMode(mode, Reduction(fraction))).Surface;
      there.push_back(BruteDistance(input, output));
      back.push_back(BruteDistance(output, input));
    }
    EXPECT_LT(there[1] + back[1], 0.95 * (there[0] + back[0])) << fraction;
    EXPECT_LT(there[2] + back[2], there[1] + back[1]) << fraction;
  }
}

TEST(RefinedModes, GiveTheSameBytesForAnyNumberOfThreads)
{
  const Surface input = BumpySphere(6, 20.0, 0.05, 8); // many blocks
  for (const Mode mode : { Mode::Balanced, Mode::Accurate })
  {
    for (const int faces : { 20000, 1000 })
    {
      ExpectTheSameBytesForAnyNumberOfThreads(input, InMode(mode, Triangles(faces)));
    }
  }
}

TEST(RefinedModes, GiveTheSameBytesWhereTheLastCollapsesRunInBlocks)
{
  // Balanced leaves 2 % of so many triangles to them: more than the 1024 collapses from which on
  // blocks are worth it.
  const Surface input = HeightField(240, 0.5, 9);
  ExpectTheSameBytesForAnyNumberOfThreads(input, InMode(Mode::Balanced, Triangles(20000)));
}

TEST(ErrorCollapse, GivesTheSameBytesForAnyNumberOfThreadsWhereItRunsInBlocks)
{
  const Surface input = BumpySphere(6, 20.0, 0.05, 8);
  std::vector<Vector3> expected;
  for (const int threads : { 1, 2, 4, 8 })
  {
    Bench bench(input, 4);
    const Index faces = bench.Mesh().NumberOfFaces() - 8000; // enough for both cuts into blocks
    EXPECT_TRUE(bench.CollapseTo(faces, threads));
    EXPECT_EQ(bench.Mesh().NumberOfFaces(), faces);
    EXPECT_EQ(BrokenInvariant(bench.Mesh()), "");
    EXPECT_EQ(bench.SamplesListed(), bench.Fit.Count());
    const std::vector<Vector3> corners = bench.Corners();
    expected = threads == 1 ? corners : expected;
    EXPECT_TRUE(corners == expected) << threads;
  }
}

TEST(RefinedModes, EndAtTheFirstStopReached)
{
  const Surface input = BumpySphere(3, 5.0, 0.1, 7);
  for (const Mode mode : { Mode::Balanced, Mode::Accurate })
  {
    Options options = InMode(mode, Triangles(40));
    options.MaximumError = 0.05;
    EXPECT_EQ(Decimate(input, options).Report.Stop, StopReason::ErrorReached);
    options.MaximumError = 100.0;
    options.AllowLargeError = true;
    const Result byNumber = Decimate(input, options);
    EXPECT_EQ(byNumber.Report.Stop, StopReason::TargetReached);
    EXPECT_EQ(byNumber.Surface.Triangles.size(), 40U);
  }
}

TEST(RefinedModes, LeaveAnOpenBoundaryThatIsStraightWhereItIs)
{
  for (const Mode mode : { Mode::Balanced, Mode::Accurate })
  {
    const Result result = Decimate(Grid(12), InMode(mode, Reduction(0.8)));
    EXPECT_NEAR(result.Report.Output.Area, result.Report.Input.Area, 1e-9);
  }
}
