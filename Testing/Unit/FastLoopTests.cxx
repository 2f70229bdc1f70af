// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Collapse/Editor.h"
#include "Collapse/LevelQueue.h"
#include "Cost/VertexQuadrics.h"
#include "Mesh/MeanEdgeLength.h"
#include "Random.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
using Freedom = VertexQuadrics::Freedom;

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
double RingQuadric(const HalfEdgeMesh& mesh, const FaceAreas& areas, Index v, const Vector3& p)
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
}

TEST(LevelQueue, VsAMapOfQueues)
{
  LevelQueue queue(500);
  std::map<LevelQueue::Level, std::vector<Index>> expected;
  Random random(3);
  for (Index v = 0; v < 500; ++v)
  {
    const LevelQueue::Level level = 900 + static_cast<LevelQueue::Level>(40.0 * random.Uniform());
    queue.Set(v, level);
    expected[level].push_back(v);
  }
  for (const auto& [level, vertices] : expected)
  {
    for (const Index v : vertices)
    {
      const LevelQueue::Entry entry = queue.Pop();
      EXPECT_EQ(entry.Vertex, v);
      EXPECT_EQ(entry.At, level);
    }
  }
  EXPECT_EQ(queue.Pop().Vertex, None);
}

TEST(LevelQueue, ForgetsWhatWasSetElsewhereOrRemoved)
{
  LevelQueue queue(3);
  queue.Set(0, 5);
  queue.Set(1, 5);
  queue.Set(0, 9);
  queue.Remove(1);
  queue.Set(2, 7);
  EXPECT_EQ(queue.Pop().Vertex, 2);
  queue.Set(2, 4); // below the lowest level there was
  EXPECT_EQ(queue.Pop().Vertex, 2);
  EXPECT_EQ(queue.Pop().Vertex, 0);
  EXPECT_EQ(queue.Pop().Vertex, None);
}

TEST(LevelQueue, LevelsRiseEightTimesAnOctave)
{
  const LevelQueue::Level one = LevelQueue::LevelOf(1.0);
  EXPECT_EQ(LevelQueue::LevelOf(2.0), one + LevelQueue::LevelsOfOctave);
  EXPECT_EQ(LevelQueue::LevelOf(1.0 + 1.0 / 8.0), one + 1);
  EXPECT_EQ(LevelQueue::LevelOf(1.0 + 1.0 / 16.0), one);
  EXPECT_EQ(LevelQueue::LevelOf(0.0), 0);
  EXPECT_LT(LevelQueue::LevelOf(1e300), LevelQueue::NumberOfLevels);
}

TEST(VertexQuadrics, CostIsThatOfThePlanesOfBothRingsAtThePlaceChosen)
{
  const Editor editor(Clean(Bone(), true), false);
  const HalfEdgeMesh& mesh = editor.Mesh();
  const double unit = MeanEdgeLength(mesh);
  const VertexQuadrics quadrics(mesh, editor.Areas(), unit);
  for (Index h = 0; h < 3 * mesh.NumberOfFaceSlots(); h += 7)
  {
    const Index v = mesh.Origin(h);
    const Index w = mesh.Target(h);
    for (const Freedom freedom : { Freedom::Space, Freedom::Edge, Freedom::First, Freedom::Second })
    {
      const VertexQuadrics::Answer answer = quadrics.Evaluate(v, w, freedom);
      const double q = RingQuadric(mesh, editor.Areas(), v, answer.Position) +
        RingQuadric(mesh, editor.Areas(), w, answer.Position);
      const double s =
        TwiceRingArea(mesh, editor.Areas(), v) + TwiceRingArea(mesh, editor.Areas(), w);
      const double expected = std::pow(s, 0.25) * std::pow(q, 0.75) / std::pow(unit, 3.5);
      EXPECT_NEAR(answer.Cost, expected, 1e-6 * expected + 1e-10);
    }
  }
}

TEST(VertexQuadrics, PlaceInSpaceKeepsTheVolumeUnderBothRings)
{
  const Editor editor(Clean(Bone(), true), false);
  const HalfEdgeMesh& mesh = editor.Mesh();
  const VertexQuadrics quadrics(mesh, editor.Areas(), MeanEdgeLength(mesh));
  for (Index h = 0; h < 3 * mesh.NumberOfFaceSlots(); h += 5)
  {
    const Index v = mesh.Origin(h);
    const Index w = mesh.Target(h);
    const Vector3 p = quadrics.Evaluate(v, w, Freedom::Space).Position;
    EXPECT_NEAR(
      RingVolume(mesh, editor.Areas(), v, p) + RingVolume(mesh, editor.Areas(), w, p), 0.0, 1e-9);
  }
}

TEST(VertexQuadrics, PlaceOnAnEdgeIsItsBestAndOnIt)
{
  const Editor editor(Clean(Bone(), true), false);
  const HalfEdgeMesh& mesh = editor.Mesh();
  const VertexQuadrics quadrics(mesh, editor.Areas(), MeanEdgeLength(mesh));
  for (Index h = 0; h < 3 * mesh.NumberOfFaceSlots(); h += 11)
  {
    const Vector3& start = mesh.Position(mesh.Origin(h));
    const Vector3& end = mesh.Position(mesh.Target(h));
    const VertexQuadrics::Answer best =
      quadrics.Evaluate(mesh.Origin(h), mesh.Target(h), Freedom::Edge);
    EXPECT_NEAR(
      (best.Position - start).norm() + (end - best.Position).norm(), (end - start).norm(), 1e-12);
    for (const Freedom freedom : { Freedom::First, Freedom::Second })
    {
      EXPECT_LE(
        best.Cost, quadrics.Evaluate(mesh.Origin(h), mesh.Target(h), freedom).Cost * (1.0 + 1e-9));
    }
  }
}

TEST(VertexQuadrics, WhatWasLeftBehindMakesAnEdgeDearer)
{
  const Editor editor(Clean(Bone(), true), false);
  VertexQuadrics quadrics(editor.Mesh(), editor.Areas(), MeanEdgeLength(editor.Mesh()));
  const Index v = editor.Mesh().Origin(0);
  const Index w = editor.Mesh().Target(0);
  const double before = quadrics.Evaluate(v, w, Freedom::Space).Cost;
  quadrics.Remember(w, 0.1);
  const double little = quadrics.Evaluate(v, w, Freedom::Space).Cost;
  quadrics.Remember(v, 0.5);
  EXPECT_GT(little, before);
  EXPECT_GT(quadrics.Evaluate(v, w, Freedom::Space).Cost, little);
}

TEST(FastMode, IsCloserToTheInputThanTheThesisAtTheSameCount)
{
  for (const double fraction : { 0.5, 0.8, 0.9 })
  {
    Options options = Reduction(fraction);
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
