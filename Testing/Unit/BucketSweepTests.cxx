// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BruteForce.h"
#include "Decimate/Edit/Editor.h"
#include "Decimate/Edit/RingQuadrics.h"
#include "Decimate/Kernels/Kernels.h"
#include "Decimate/Schedule/BucketSweep.h"
#include "Mesh/MeanEdgeLength.h"
#include "Random.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
Surface Bone()
{
  return BumpySphere(3, 5.0, 0.1, 7);
}

Options InFastMode(Options options)
{
  options.Mode = Mode::Fast;
  return options;
}

/// The cost of one edge by one set of kernels, and its position in mm.
struct EvaluatedEdge
{
  double Cost = 0.0;
  Vector3 Position = Vector3::Zero();
};

const std::vector<Freedom> Freedoms = { Freedom::Space, Freedom::Edge, Freedom::First,
  Freedom::Second };
}

/// A bumpy sphere with areas and quadrics whose edges are evaluated one by one.
class EdgeKernel : public testing::Test
{
protected:
  const HalfEdgeMesh& Mesh() const { return this->MeshEditor.Mesh(); }

  /// Twice the area times the squared distance of p to the plane, over the faces of the ring of v.
  double SquaresOver(Index v, const Vector3& p) const
  {
    return this->SumOverRing(v,
      [&](const FaceAreas::Face& face)
      {
        const double distance = face.Normal.dot(p - this->Mesh().Position(v));
        return 2.0 * face.Area * distance * distance;
      });
  }

  /// Three times the volume between the ring of v and the same ring with its middle moved to p.
  double RingVolume(Index v, const Vector3& p) const
  {
    return this->SumOverRing(v,
      [&](const FaceAreas::Face& face)
      { return face.Area * face.Normal.dot(p - this->Mesh().Position(v)); });
  }

  double TwiceRingArea(Index v) const
  {
    return this->SumOverRing(v, [](const FaceAreas::Face& face) { return 2.0 * face.Area; });
  }

  /// The edge of h, which starts at First.
  EvaluatedEdge Evaluate(
    Index h, Freedom freedom, float memory = 0.0F, const Kernels& kernels = BestKernels()) const
  {
    const Vector3& start = this->Mesh().Position(this->Mesh().Origin(h));
    EdgeBatch batch;
    batch.First = &this->Mesh().Record(this->Mesh().Origin(h));
    batch.Others[0] = &this->Mesh().Record(this->Mesh().Target(h));
    batch.Freedoms[0] = static_cast<std::int32_t>(freedom);
    batch.AccumulatedErrors[0] = memory;
    batch.Count = 1;
    batch.PerUnit = 1.0 / this->Mesh().Unit();
    EdgeResults results;
    kernels.EvaluateEdges(batch, results);
    const Vector3 move(results.Moves[0][0], results.Moves[1][0], results.Moves[2][0]);
    return { results.Costs[0], start + this->Mesh().Unit() * move };
  }

private:
  template <typename Value>
  double SumOverRing(Index v, const Value& value) const
  {
    double sum = 0.0;
    for (const Index h : this->Mesh().OutgoingOf(v))
    {
      sum += value(this->MeshEditor.Areas()[HalfEdgeMesh::Face(h)]);
    }
    return sum;
  }

  const CleanSurface Cleaned = Clean(Bone(), true);
  const Editor MeshEditor{ this->Cleaned, EditorSettings{ false, true, true } };
};

TEST_F(EdgeKernel, CostIsThatOfThePlanesOfBothRingsAtTheChosenPosition)
{
  for (const Index h : HalfEdges(this->Mesh(), 7))
  {
    const Index v = this->Mesh().Origin(h);
    const Index w = this->Mesh().Target(h);
    for (const Freedom freedom : Freedoms)
    {
      const EvaluatedEdge result = this->Evaluate(h, freedom);
      const double q =
        this->SquaresOver(v, result.Position) + this->SquaresOver(w, result.Position);
      const double s = this->TwiceRingArea(v) + this->TwiceRingArea(w);
      const double expected =
        std::pow(s, 0.25) * std::pow(q, 0.75) / std::pow(this->Mesh().Unit(), 3.5);
      EXPECT_NEAR(result.Cost, expected, 1e-3 * expected + 1e-6);
    }
  }
}

TEST_F(EdgeKernel, FreePositionPreservesTheVolumeUnderBothRings)
{
  for (const Index h : HalfEdges(this->Mesh(), 5))
  {
    const Index v = this->Mesh().Origin(h);
    const Index w = this->Mesh().Target(h);
    const Vector3 p = this->Evaluate(h, Freedom::Space).Position;
    const double area = this->TwiceRingArea(v);
    EXPECT_NEAR(
      this->RingVolume(v, p) + this->RingVolume(w, p), 0.0, 1e-5 * area * this->Mesh().Unit());
  }
}

TEST_F(EdgeKernel, PositionOnAnEdgeIsOptimalAndOnTheEdge)
{
  for (const Index h : HalfEdges(this->Mesh(), 11))
  {
    const Vector3& start = this->Mesh().Position(this->Mesh().Origin(h));
    const Vector3& end = this->Mesh().Position(this->Mesh().Target(h));
    const EvaluatedEdge best = this->Evaluate(h, Freedom::Edge);
    EXPECT_NEAR((best.Position - start).norm() + (end - best.Position).norm(), (end - start).norm(),
      1e-6 * (end - start).norm());
    for (const Freedom freedom : { Freedom::First, Freedom::Second })
    {
      const EvaluatedEdge other = this->Evaluate(h, freedom);
      EXPECT_LE(best.Cost, other.Cost * (1.0 + 1e-3));
    }
  }
}

TEST_F(EdgeKernel, AccumulatedErrorIncreasesTheCost)
{
  const auto cost = [&](float memory) { return this->Evaluate(0, Freedom::Space, memory).Cost; };
  EXPECT_GT(cost(0.1F), cost(0.0F));
  EXPECT_GT(cost(0.5F), cost(0.1F));
}

TEST_F(EdgeKernel, EdgesWithoutFreedomHaveInfiniteCost)
{
  EXPECT_TRUE(std::isinf(this->Evaluate(0, Freedom::Nowhere).Cost));
}

TEST_F(EdgeKernel, GivesTheSameBitsInAllSets)
{
  ASSERT_FALSE(AvailableKernels().empty());
  for (const Index h : HalfEdges(this->Mesh()))
  {
    for (const Freedom freedom : Freedoms)
    {
      const EvaluatedEdge expected = this->Evaluate(h, freedom, 0.25F, *AvailableKernels().front());
      for (const Kernels* kernels : AvailableKernels())
      {
        const EvaluatedEdge found = this->Evaluate(h, freedom, 0.25F, *kernels);
        EXPECT_EQ(found.Cost, expected.Cost) << kernels->Name;
        EXPECT_EQ(found.Position, expected.Position) << kernels->Name;
      }
    }
  }
}

TEST(Kernels, OfEachProcessorGiveTheSameBytesOfAWholeRun)
{
  const Surface bone = BumpySphere(5, 20.0, 0.02, 31);
  Options options;
  options.Mode = Mode::Fast;
  const Surface expected = Decimate(bone, options).Surface;
  for (const Kernels* kernels : AvailableKernels())
  {
    ChooseKernels(kernels);
    EXPECT_TRUE(SameBytes(Decimate(bone, options).Surface, expected)) << kernels->Name;
  }
  ChooseKernels(nullptr);
}

namespace
{
float CostWithoutKernel(const CollapseInput& input)
{
  return QuadricDeviation(input);
}
}

TEST(BucketSweep, GivesTheSameMeshWithoutAKernelForItsPolicies)
{
  const SweepPolicies policies = { CostWithoutKernel, VolumePreservingPosition };
  ASSERT_FALSE(EdgeEvaluator(policies).HasKernel());
  const CleanSurface cleaned = Clean(Bone(), true);
  const EditorSettings settings = { false, false, true };
  const auto goOn = [](double) { return true; };
  Editor expected(cleaned, settings);
  Editor found(cleaned, settings);
  const StopTargets stops = { expected.Mesh().NumberOfFaces() / 8, 0.0 };
  BucketSweep(expected, 1).Run(stops, goOn);
  BucketSweep(found, 1, {}, policies).Run(stops, goOn);
  EXPECT_TRUE(SameBytes(SurfaceOf(found.Mesh()), SurfaceOf(expected.Mesh())));
}

class RingQuadrics : public EachShape
{
};

TEST_P(RingQuadrics, EqualNewSumsAfterManyCollapses)
{
  const CleanSurface cleaned = Clean(GetParam().Surface, true);
  Editor editor(cleaned, EditorSettings{ false, false, true });
  const Index faces = editor.Mesh().NumberOfFaces();
  BucketSweep(editor, 1).Run({ faces / 4, 0.0 }, [](double) { return true; });
  HalfEdgeMesh afresh = editor.Mesh();
  SumRingQuadrics(afresh, 1);
  for (Index v = 0; v < afresh.NumberOfVertexSlots(); ++v)
  {
    if (afresh.Outgoing(v) == None || afresh.Constraint(v) == VertexConstraint::NonManifold)
    {
      continue;
    }
    const RingQuadric& kept = editor.Mesh().Record(v).Quadric;
    const RingQuadric& expected = afresh.Record(v).Quadric;
    const float size = expected.M[0] + expected.M[3] + expected.M[5];
    for (std::size_t i = 0; i < 6; ++i)
    {
      EXPECT_NEAR(kept.M[i], expected.M[i], 2e-5F * size) << "vertex " << v;
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(kept.G[i], expected.G[i], 2e-5F * size) << "vertex " << v;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, RingQuadrics, testing::ValuesIn(AllShapes()), NameOf);

TEST(BucketSweep, GivesTheSameBytesForAnyNumberOfThreads)
{
  const Surface input = BumpySphere(7, 20.0, 0.05, 8); // enough for rounds of several blocks
  for (const int faces : { 100000, 30000, 2000 })
  {
    ExpectTheSameBytesForAnyNumberOfThreads(input, InFastMode(Triangles(faces)));
  }
}

TEST(FastMode, IsCloserToTheInputThanTheThesisAtTheSameCount)
{
  for (const double fraction : { 0.5, 0.8, 0.9 })
  {
    Options options = InMode(Mode::Thesis, Reduction(fraction));
    options.MeasureDistances = true;
    const Surface input = BumpySphere(5, 20.0, 0.05, 8);
    const Report thesis = Decimate(input, options).Report;
    const Report fast = Decimate(input, InFastMode(options)).Report;
    EXPECT_EQ(fast.Output.Faces, thesis.Output.Faces);
    EXPECT_LT(fast.OutputToInput.Mean, thesis.OutputToInput.Mean) << fraction;
    EXPECT_LT(fast.InputToOutput.RootMeanSquare, thesis.InputToOutput.RootMeanSquare) << fraction;
    EXPECT_NEAR(fast.Output.Volume, fast.Input.Volume, 1e-3 * fast.Input.Volume);
  }
}

TEST(FastMode, EndsAtTheFirstStopReached)
{
  Options options = InFastMode(Triangles(40));
  options.MaximumError = 0.05;
  const Result byError = Decimate(Bone(), options);
  EXPECT_EQ(byError.Report.Stop, StopReason::ErrorReached);
  EXPECT_GT(byError.Surface.Triangles.size(), 40U);
  options.MaximumError = 100.0;
  options.AllowLargeError = true;
  const Result byNumber = Decimate(Bone(), options);
  EXPECT_EQ(byNumber.Report.Stop, StopReason::TargetReached);
  EXPECT_EQ(byNumber.Surface.Triangles.size(), 40U);
  const Result errorAlone = Decimate(Bone(), InFastMode(Error(0.05)));
  EXPECT_EQ(errorAlone.Report.Stop, StopReason::ErrorReached);
}

TEST(FastMode, AnOpenBoundaryThatIsStraightStaysWhereItIs)
{
  const Result result = Decimate(Grid(12), InFastMode(Reduction(0.8)));
  EXPECT_NEAR(result.Report.Output.Area, result.Report.Input.Area, 1e-9);
}

TEST(BucketSweep, EndsWhenEveryFragmentHasItsLeastSize)
{
  // Enough points for rounds, and far more triangles than can be had.
  Surface input;
  const Surface piece = Icosphere(1, 1.0);
  for (int i = 0; i < 600; ++i)
  {
    const Index first = static_cast<Index>(input.Points.size());
    for (const Vector3& p : piece.Points)
    {
      input.Points.emplace_back(p + Vector3(3.0 * i, 0.0, 0.0));
    }
    for (const Triangle& t : piece.Triangles)
    {
      input.Triangles.push_back({ first + t[0], first + t[1], first + t[2] });
    }
  }
  for (const Mode mode : ProvingModes())
  {
    const Report report = Decimate(input, InMode(mode, Triangles(4))).Report;
    EXPECT_EQ(report.Stop, StopReason::NothingLeft) << WordOf(mode);
    EXPECT_EQ(report.Output.Components, 600) << WordOf(mode);
  }
}
