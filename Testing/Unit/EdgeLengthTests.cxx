// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Edge splits, and runs with an edge length.
#include "Decimate/Edit/Editor.h"
#include "Geometry/TriangleGeometry.h"
#include "LabeledSurfaces.h"
#include "LevelRuns.h"
#include "Mesh/FreeSlots.h"
#include "Mesh/Invariants.h"
#include "Proof/Certificate/Certificate.h"
#include "Random.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
double AreaOf(const HalfEdgeMesh& mesh, FaceId face) // mm^2
{
  const Triangle c = mesh.Corners(face);
  return AreaVector(mesh.Position(c[0]), mesh.Position(c[1]), mesh.Position(c[2])).norm();
}

double AreaOf(const HalfEdgeMesh& mesh) // mm^2
{
  double area = 0.0;
  for (FaceId face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    area += mesh.IsAlive(face) ? AreaOf(mesh, face) : 0.0;
  }
  return area;
}

/// Collapses edges of a plain mesh in order of their ids until that many faces are left.
void CollapseTo(Editor& editor, Index faces)
{
  EditWorkspace work;
  for (FaceId face = 0; face < editor.Mesh().NumberOfFaceSlots(); ++face)
  {
    for (Index k = 0; k < 3 && editor.Mesh().NumberOfFaces() > faces; ++k)
    {
      const HalfEdgeId h = HalfEdgeMesh::HalfEdge(face, k);
      if (editor.Mesh().IsAlive(face) && editor.Gather(h, work).IsAccepted())
      {
        Edit edit;
        edit.Edge = h;
        edit.Keep = editor.Mesh().Origin(h);
        edit.Position = editor.Mesh().Position(edit.Keep);
        edit.KeepStays = true;
        editor.Try(edit, work);
        editor.Settle(&work.Counts);
      }
    }
  }
}

Vector3 MiddleOf(const HalfEdgeMesh& mesh, HalfEdgeId h)
{
  return 0.5 * (mesh.Position(mesh.Origin(h)) + mesh.Position(mesh.Target(h)));
}

std::vector<double> LengthsOf(const Surface& surface)
{
  std::vector<double> lengths;
  for (const auto& [edge, triangles] : EdgesOf(surface))
  {
    lengths.push_back((surface.Points[edge.first] - surface.Points[edge.second]).norm());
  }
  return lengths;
}

Options WithLength(Options options, double millimeters)
{
  options.EdgeLength = millimeters;
  return options;
}

double MeanOf(const std::vector<double>& numbers)
{
  double sum = 0.0;
  for (const double number : numbers)
  {
    sum += number;
  }
  return sum / static_cast<double>(numbers.size());
}
}

TEST(FreeSlots, FindsTheNearestOfThoseLeft)
{
  Random random(7);
  std::vector<char> isFree(200, 0);
  for (char& free : isFree)
  {
    free = random.Below(3) == 0 ? 1 : 0;
  }
  FreeSlots slots(isFree);
  ASSERT_EQ(slots.Count(), std::count(isFree.begin(), isFree.end(), 1));
  while (slots.Count() > 0)
  {
    const auto id = static_cast<Index>(random.Below(200));
    const auto nearest = [&](Index except)
    {
      Index best = None;
      for (Index i = 0; i < 200; ++i)
      {
        const bool isBetter = best == None || std::abs(i - id) < std::abs(best - id);
        best = isFree[static_cast<std::size_t>(i)] != 0 && i != except && isBetter ? i : best;
      }
      return best;
    };
    const Index found = slots.FindNearest(id);
    ASSERT_EQ(found, nearest(None));
    ASSERT_EQ(slots.FindNearest(id, found), nearest(found));
    slots.Take(found);
    isFree[static_cast<std::size_t>(found)] = 0;
  }
  EXPECT_EQ(slots.FindNearest(100), None);
}

TEST(EdgeSplit, LeavesTheSurfaceWhereItIs)
{
  for (const Surface& surface : { BumpySphere(2, 10.0, 0.1, 3), HeightField(12, 0.5, 4) })
  {
    const CleanSurface clean = Clean(surface, true);
    EditorSettings settings;
    settings.RecordsDistances = false;
    Editor editor(clean, settings);
    const HalfEdgeMesh& mesh = editor.Mesh();
    CollapseTo(editor, mesh.NumberOfFaces() / 3);
    ASSERT_TRUE(editor.PrepareSplits());
    const double area = AreaOf(mesh);
    const Index before = mesh.NumberOfFaces();
    EditWorkspace work;
    int onBoundary = 0;
    for (FaceId face = 0; face < mesh.NumberOfFaceSlots(); ++face)
    {
      const HalfEdgeId h = HalfEdgeMesh::HalfEdge(face, face % 3);
      if (mesh.IsAlive(face))
      {
        const bool isBoundary = mesh.Twin(h) == None;
        const bool isSplit = editor.Try(SplitAt(h, MiddleOf(mesh, h)), work).IsAccepted();
        editor.Settle(&work.Counts);
        onBoundary += isSplit && isBoundary ? 1 : 0;
        ASSERT_EQ(BrokenInvariant(mesh), "") << "face " << face;
      }
    }
    EXPECT_GT(mesh.NumberOfFaces(), before + 40);
    EXPECT_EQ(onBoundary > 0, editor.Original().CleanInput().Surface.Points.size() == 169U);
    EXPECT_NEAR(AreaOf(mesh), area, 1e-9 * area);
    // Every vertex of the input is still in a vertex of the mesh.
    for (const Index v : editor.Original().CurrentOfInitial())
    {
      ASSERT_NE(mesh.Outgoing(v), None);
    }
  }
}

TEST(EdgeSplit, NeedsIdsOfRemovedVertices)
{
  const CleanSurface clean = Clean(Icosphere(2, 10.0), true);
  EditorSettings settings;
  settings.RecordsDistances = false;
  Editor editor(clean, settings);
  ASSERT_TRUE(editor.PrepareSplits());
  EditWorkspace work;
  const HalfEdgeMesh& mesh = editor.Mesh();
  EXPECT_EQ(editor.Try(SplitAt(0, MiddleOf(mesh, 0)), work), Rejection::Shape);
  EXPECT_EQ(mesh.NumberOfFaces(), mesh.NumberOfFaceSlots());
}

TEST(EdgeSplit, KeepsTheErrorBound)
{
  const CleanSurface clean = Clean(Icosphere(3, 10.0), true);
  EditorSettings settings;
  settings.RecordsDistances = false;
  settings.Bound.emplace();
  settings.Bound->Error = 0.5;
  Editor editor(clean, settings);
  CollapseTo(editor, 900);
  ASSERT_TRUE(editor.PrepareSplits());
  EditWorkspace work;
  const HalfEdgeMesh& mesh = editor.Mesh();
  HalfEdgeId h = 0;
  while (!mesh.IsAlive(HalfEdgeMesh::Face(h)))
  {
    h = h + 4;
  }
  const Vector3 middle = MiddleOf(mesh, h);
  const Index faces = mesh.NumberOfFaces();
  EXPECT_TRUE(editor.Try(SplitAt(h, middle + 2.0 * middle.normalized()), work).IsRejected());
  EXPECT_EQ(mesh.NumberOfFaces(), faces);
  EXPECT_TRUE(editor.Try(SplitAt(h, middle), work).IsAccepted());
  editor.Settle(&work.Counts);
  EXPECT_EQ(mesh.NumberOfFaces(), faces + 2);
  EXPECT_EQ(BrokenInvariant(mesh), "");
}

TEST(EdgeLength, HoldsInEveryMode)
{
  const Surface sphere = BumpySphere(3, 20.0, 0.02, 11);
  for (const Mode mode : ProvingModes())
  {
    SCOPED_TRACE(FindMode(mode).Name);
    for (Options options : { Error(1.2), Unmeasured() })
    {
      options = InMode(mode, WithLength(options, 6.0));
      const Result result = Decimate(sphere, options);
      const std::vector<double> lengths = LengthsOf(result.Surface);
      EXPECT_LE(*std::max_element(lengths.begin(), lengths.end()), 8.0 * (1.0 + 1e-6));
      EXPECT_NEAR(MeanOf(lengths), 6.0, 0.9);
      EXPECT_EQ(result.Report.Edges.Longer, 0);
      EXPECT_NEAR(result.Report.Edges.Mean, MeanOf(lengths), 1e-9);
      EXPECT_GT(result.Report.Output.Shape.SmallestAngle, 19.9);
      if (options.MaximumError > 0.0)
      {
        EXPECT_EQ(result.Report.Proof.Status, ProofStatus::Proved);
        EXPECT_LE(Certify(sphere, result.Surface).Upper(), options.MaximumError);
      }
    }
  }
}

TEST(EdgeLength, ALongerOneTakesFewerTriangles)
{
  const Surface sphere = BumpySphere(3, 20.0, 0.02, 11);
  const Result fine = Decimate(sphere, WithLength(Error(1.2), 4.0));
  const Result coarse = Decimate(sphere, WithLength(Error(1.2), 7.0));
  EXPECT_GT(fine.Surface.Triangles.size(), 2 * coarse.Surface.Triangles.size());
  EXPECT_LT(MeanOf(LengthsOf(fine.Surface)), 0.7 * MeanOf(LengthsOf(coarse.Surface)));
}

TEST(EdgeLength, SplitsLongEdgesOfTheInputAndMakesNoMoreTriangles)
{
  // A slender prism has edges as long as itself; the plate gives the ids.
  const Surface both = Together(Prism(6, 1, 2), Moved(FlatPlate(30), { 200.0, 0.0, 0.0 }));
  const std::vector<double> before = LengthsOf(both);
  const double longest = *std::max_element(before.begin(), before.end());
  const double length = 0.4 * longest;
  const Result result =
    Decimate(both, InMode(Mode::Fast, WithLength(Error(0.05 * longest), length)));
  const std::vector<double> after = LengthsOf(result.Surface);
  EXPECT_LE(*std::max_element(after.begin(), after.end()), 4.0 / 3.0 * length * (1.0 + 1e-6));
  EXPECT_LE(result.Surface.Triangles.size(), both.Triangles.size());
  EXPECT_EQ(result.Report.Proof.Status, ProofStatus::Proved);
}

TEST(EdgeLength, KeepsLabelsOfTriangles)
{
  const Surface ball = HalvedBall(8);
  const Labels labels = PatchesAsLabels(ball);
  const Result result = RunWith(labels, ball, WithLength(Error(0.8), 3.0));
  ASSERT_EQ(result.Report.Status, InputStatus::Good);
  EXPECT_EQ(result.Report.Proof.Status, ProofStatus::Proved);
  std::map<Index, double> before;
  std::map<Index, double> after;
  const auto area = [](const Surface& surface, const Triangle& c)
  { return AreaVector(surface.Points[c[0]], surface.Points[c[1]], surface.Points[c[2]]).norm(); };
  for (std::size_t t = 0; t < ball.Triangles.size(); ++t)
  {
    before[labels.OfTriangle[t]] += area(ball, ball.Triangles[t]);
  }
  const std::vector<Index> labelsAfter = LabelsAfter(labels, result);
  for (std::size_t t = 0; t < result.Surface.Triangles.size(); ++t)
  {
    after[labelsAfter[t]] += area(result.Surface, result.Surface.Triangles[t]);
  }
  ASSERT_EQ(before.size(), after.size());
  for (const auto& [label, size] : before)
  {
    EXPECT_NEAR(after[label], size, 0.25 * size) << "label " << label;
  }
}

TEST(EdgeLength, LeavesConstrainedTriangles)
{
  const Surface sphere = BumpySphere(4, 20.0, 0.02, 11);
  std::vector<double> tolerances(sphere.Points.size(), 0.6);
  std::set<std::array<double, 3>> constrained;
  for (std::size_t p = 0; p < sphere.Points.size(); ++p)
  {
    const Vector3& x = sphere.Points[p];
    if (x.z() > 15.0)
    {
      tolerances[p] = 0.0;
      constrained.insert({ x.x(), x.y(), x.z() });
    }
  }
  RunInputs inputs;
  inputs.Tolerances = &tolerances;
  const Result result = Decimate(sphere, WithLength(Unmeasured(), 4.0), {}, inputs);
  std::size_t kept = 0;
  for (const Vector3& x : result.Surface.Points)
  {
    kept += constrained.count({ x.x(), x.y(), x.z() });
    EXPECT_TRUE(x.z() <= 15.0 || constrained.count({ x.x(), x.y(), x.z() }) == 1);
  }
  EXPECT_EQ(kept, constrained.size());
  EXPECT_GT(result.Report.Edges.Shorter, 0);
}

TEST(EdgeLength, GivesTheSameBytesWhateverTheThreads)
{
  const Surface bone = LargeBone();
  Options options = InMode(Mode::Fast, WithLength(Error(0.4), 3.0));
  const Result one = Decimate(bone, options);
  options.NumberOfThreads = 3;
  const Result three = Decimate(bone, options);
  EXPECT_EQ(one.Surface.Triangles, three.Surface.Triangles);
  EXPECT_EQ(one.Surface.Points, three.Surface.Points);
}
