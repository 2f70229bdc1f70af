// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BruteForce.h"
#include "Collapse/Editor.h"
#include "Collapse/RingQuadrics.h"
#include "Collapse/Sweep.h"
#include "Kernels/Kernels.h"
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

/// Twice the area times the squared distance of p to the plane, over the faces of the ring of v.
double SquaresOver(const HalfEdgeMesh& mesh, const FaceAreas& areas, Index v, const Vector3& p)
{
  double sum = 0.0;
  for (const Index h : mesh.OutgoingOf(v))
  {
    const FaceAreas::Face& face = areas[HalfEdgeMesh::Face(h)];
    const double distance = face.Normal.dot(p - mesh.Position(v));
    sum += 2.0 * face.Area * distance * distance;
  }
  return sum;
}

/// Three times the volume between the ring of v and the same ring with its middle moved to p.
double RingVolume(const HalfEdgeMesh& mesh, const FaceAreas& areas, Index v, const Vector3& p)
{
  double sum = 0.0;
  for (const Index h : mesh.OutgoingOf(v))
  {
    const FaceAreas::Face& face = areas[HalfEdgeMesh::Face(h)];
    sum += face.Area * face.Normal.dot(p - mesh.Position(v));
  }
  return sum;
}

double TwiceRingArea(const HalfEdgeMesh& mesh, const FaceAreas& areas, Index v)
{
  double sum = 0.0;
  for (const Index h : mesh.OutgoingOf(v))
  {
    sum += 2.0 * areas[HalfEdgeMesh::Face(h)].Area;
  }
  return sum;
}

/// One edge judged by one set of kernels: cost, and place in mm.
struct Judged
{
  double Cost = 0.0;
  Vector3 Place = Vector3::Zero();
};

Judged Judge(const Kernels& kernels, const HalfEdgeMesh& mesh, Index v, Index w, Freedom freedom,
  float memory = 0.0F)
{
  EdgeBatch batch;
  batch.First = &mesh.Record(v);
  batch.Others[0] = &mesh.Record(w);
  batch.Freedoms[0] = static_cast<std::int32_t>(freedom);
  batch.Memories[0] = memory;
  batch.Count = 1;
  batch.PerUnit = 1.0 / mesh.Unit();
  EdgeAnswers answers;
  kernels.JudgeEdges(batch, answers);
  const Vector3 move(answers.Moves[0][0], answers.Moves[1][0], answers.Moves[2][0]);
  return { answers.Costs[0], mesh.Position(v) + mesh.Unit() * move };
}

const std::vector<Freedom> Freedoms = { Freedom::Space, Freedom::Edge, Freedom::First,
  Freedom::Second };
}

TEST(EdgeKernel, CostIsThatOfThePlanesOfBothRingsAtThePlaceChosen)
{
  const CleanSurface cleaned = Clean(Bone(), true);
  const Editor editor(cleaned, Editor::Books{ false, true, true });
  const HalfEdgeMesh& mesh = editor.Mesh();
  for (const Index h : HalfEdges(mesh, 7))
  {
    const Index v = mesh.Origin(h);
    const Index w = mesh.Target(h);
    for (const Freedom freedom : Freedoms)
    {
      const Judged answer = Judge(BestKernels(), mesh, v, w, freedom);
      const double q = SquaresOver(mesh, editor.Areas(), v, answer.Place) +
        SquaresOver(mesh, editor.Areas(), w, answer.Place);
      const double s =
        TwiceRingArea(mesh, editor.Areas(), v) + TwiceRingArea(mesh, editor.Areas(), w);
      const double expected = std::pow(s, 0.25) * std::pow(q, 0.75) / std::pow(mesh.Unit(), 3.5);
      EXPECT_NEAR(answer.Cost, expected, 1e-3 * expected + 1e-6);
    }
  }
}

TEST(EdgeKernel, PlaceInSpaceKeepsTheVolumeUnderBothRings)
{
  const CleanSurface cleaned = Clean(Bone(), true);
  const Editor editor(cleaned, Editor::Books{ false, true, true });
  const HalfEdgeMesh& mesh = editor.Mesh();
  for (const Index h : HalfEdges(mesh, 5))
  {
    const Index v = mesh.Origin(h);
    const Index w = mesh.Target(h);
    const Vector3 p = Judge(BestKernels(), mesh, v, w, Freedom::Space).Place;
    const double area = TwiceRingArea(mesh, editor.Areas(), v);
    EXPECT_NEAR(RingVolume(mesh, editor.Areas(), v, p) + RingVolume(mesh, editor.Areas(), w, p),
      0.0, 1e-5 * area * mesh.Unit());
  }
}

TEST(EdgeKernel, PlaceOnAnEdgeIsItsBestAndOnIt)
{
  const CleanSurface cleaned = Clean(Bone(), true);
  const Editor editor(cleaned, Editor::Books{ false, true, true });
  const HalfEdgeMesh& mesh = editor.Mesh();
  for (const Index h : HalfEdges(mesh, 11))
  {
    const Vector3& start = mesh.Position(mesh.Origin(h));
    const Vector3& end = mesh.Position(mesh.Target(h));
    const Judged best = Judge(BestKernels(), mesh, mesh.Origin(h), mesh.Target(h), Freedom::Edge);
    EXPECT_NEAR((best.Place - start).norm() + (end - best.Place).norm(), (end - start).norm(),
      1e-6 * (end - start).norm());
    for (const Freedom freedom : { Freedom::First, Freedom::Second })
    {
      const Judged other = Judge(BestKernels(), mesh, mesh.Origin(h), mesh.Target(h), freedom);
      EXPECT_LE(best.Cost, other.Cost * (1.0 + 1e-3));
    }
  }
}

TEST(EdgeKernel, WhatWasLeftBehindMakesAnEdgeDearer)
{
  const CleanSurface cleaned = Clean(Bone(), true);
  const Editor editor(cleaned, Editor::Books{ false, false, true });
  const HalfEdgeMesh& mesh = editor.Mesh();
  const auto cost = [&](float memory) {
    return Judge(BestKernels(), mesh, mesh.Origin(0), mesh.Target(0), Freedom::Space, memory).Cost;
  };
  EXPECT_GT(cost(0.1F), cost(0.0F));
  EXPECT_GT(cost(0.5F), cost(0.1F));
}

TEST(EdgeKernel, AnEdgeThatLeadsNowhereIsNeverTaken)
{
  const CleanSurface cleaned = Clean(Bone(), true);
  const Editor editor(cleaned, Editor::Books{ false, false, true });
  const HalfEdgeMesh& mesh = editor.Mesh();
  EXPECT_TRUE(
    std::isinf(Judge(BestKernels(), mesh, mesh.Origin(0), mesh.Target(0), Freedom::Nowhere).Cost));
}

TEST(Kernels, AllSetsGiveTheSameBits)
{
  const CleanSurface cleaned = Clean(Bone(), true);
  const Editor editor(cleaned, Editor::Books{ false, false, true });
  const HalfEdgeMesh& mesh = editor.Mesh();
  ASSERT_FALSE(AvailableKernels().empty());
  for (const Index h : HalfEdges(mesh))
  {
    for (const Freedom freedom : Freedoms)
    {
      const Judged expected =
        Judge(*AvailableKernels().front(), mesh, mesh.Origin(h), mesh.Target(h), freedom, 0.25F);
      for (const Kernels* kernels : AvailableKernels())
      {
        const Judged found = Judge(*kernels, mesh, mesh.Origin(h), mesh.Target(h), freedom, 0.25F);
        EXPECT_EQ(found.Cost, expected.Cost) << kernels->Name;
        EXPECT_EQ(found.Place, expected.Place) << kernels->Name;
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

class RingQuadrics : public EachShape
{
};

TEST_P(RingQuadrics, AreWhatASumAfreshGivesAfterManyCollapses)
{
  const CleanSurface cleaned = Clean(GetParam().Surface, true);
  Editor editor(cleaned, Editor::Books{ false, false, true });
  const Index faces = editor.Mesh().NumberOfFaces();
  Sweep(editor, { faces / 4, 0.0, false }, 1).Run([](double) { return true; });
  HalfEdgeMesh afresh = editor.Mesh();
  SumRingQuadrics(afresh, 1);
  for (Index v = 0; v < afresh.NumberOfVertexSlots(); ++v)
  {
    if (afresh.Outgoing(v) == None || afresh.Kind(v) == VertexKind::Locked)
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

TEST(Sweep, GivesTheSameBytesForAnyNumberOfThreads)
{
  const Surface input = BumpySphere(7, 20.0, 0.05, 8); // enough for rounds of several blocks
  for (const int faces : { 100000, 30000, 2000 })
  {
    Options options = InFastMode(Triangles(faces));
    const Surface expected = Decimate(input, options).Surface;
    for (const int threads : { 2, 4, 8 })
    {
      options.NumberOfThreads = threads;
      EXPECT_TRUE(SameBytes(Decimate(input, options).Surface, expected)) << threads;
    }
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
  const Result byNumber = Decimate(Bone(), options);
  EXPECT_EQ(byNumber.Report.Stop, StopReason::TargetReached);
  EXPECT_EQ(byNumber.Surface.Triangles.size(), 40U);
  const Result errorAlone = Decimate(Bone(), InFastMode(Error(0.05)));
  EXPECT_EQ(errorAlone.Report.Stop, StopReason::ErrorReached);
}

TEST(FastMode, AnOpenBorderThatIsStraightStaysWhereItIs)
{
  const Result result = Decimate(Grid(12), InFastMode(Reduction(0.8)));
  EXPECT_NEAR(result.Report.Output.Area, result.Report.Input.Area, 1e-9);
}

TEST(Sweep, EndsWhereEveryFragmentIsAsSmallAsItMayBe)
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
  for (const Mode mode : { Mode::Fast, Mode::Balanced, Mode::Accurate })
  {
    const Report report = Decimate(input, InMode(mode, Triangles(4))).Report;
    EXPECT_EQ(report.Stop, StopReason::NothingLeft) << WordOf(mode);
    EXPECT_EQ(report.Output.Components, 600) << WordOf(mode);
  }
}
