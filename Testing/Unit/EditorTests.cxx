// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BruteForce.h"
#include "Decimate/Cost/NormalFieldDeviation.h"
#include "Decimate/Stages/ThesisCollapse.h"
#include "EditAlone.h"
#include "Mesh/Invariants.h"
#include "Mesh/MeanEdgeLength.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
constexpr double Tolerance = 0.95;

QueuePolicies OfThesis()
{
  return std::get<QueuePolicies>(FindMode(Mode::Thesis).Schedule);
}

/// Runs the loop to its end and calls check(editor, edit) after every collapse.
StopReason RunToTheEnd(const Surface& surface, const Editor::Hook& check)
{
  const CleanSurface cleaned = Clean(surface, true);
  Editor editor(cleaned, EditorSettings());
  editor.SetHook(check);
  ThesisCollapse loop(editor, OfThesis(), Tolerance);
  return loop.Run({ 0, 0.0 }, [](double) { return true; });
}

/// Compares one collapse with the mesh before it.
class EditCheck
{
public:
  explicit EditCheck(const Surface& surface)
    : Before(Clean(surface, true).Surface)
  {
  }

  void operator()(const Editor& editor, const Edit& edit)
  {
    const Index gone = this->Before.OtherEnd(edit.Edge, edit.Keep);
    this->CheckNewPosition(edit, gone);
    this->CheckFaces(editor.Mesh(), edit.Keep, gone);
    this->Before = editor.Mesh();
  }

private:
  void CheckNewPosition(const Edit& edit, Index gone) const
  {
    const VertexConstraint keepKind = this->Before.Constraint(edit.Keep);
    const VertexConstraint goneKind = this->Before.Constraint(gone);
    EXPECT_NE(keepKind, VertexConstraint::NonManifold);
    EXPECT_NE(goneKind, VertexConstraint::NonManifold);
    const Vector3& a = this->Before.Position(edit.Keep);
    const Vector3& b = this->Before.Position(gone);
    EXPECT_TRUE(!edit.KeepStays || edit.Position == a);
    if (keepKind == VertexConstraint::Boundary && goneKind == VertexConstraint::Boundary)
    {
      EXPECT_EQ(this->Before.Twin(edit.Edge), None) << "an inside edge between boundary vertices";
      EXPECT_LT(PointTriangleDistance(edit.Position, a, b, a), 1e-12) << "off the boundary edge";
    }
    else if (keepKind == VertexConstraint::Boundary || goneKind == VertexConstraint::Boundary)
    {
      EXPECT_EQ(edit.Position, keepKind == VertexConstraint::Boundary ? a : b)
        << "the boundary vertex moved";
    }
  }

  /// Faces away from the edge are as before; those around it have not turned over.
  void CheckFaces(const HalfEdgeMesh& after, Index keep, Index gone) const
  {
    for (Index face = 0; face < after.NumberOfFaceSlots(); ++face)
    {
      if (!after.IsAlive(face))
      {
        continue;
      }
      const Triangle old = this->Before.Corners(face);
      Vector3 normals[2] = { Normal(this->Before, face), Normal(after, face) };
      bool touched = false;
      for (std::size_t i = 0; i < 3; ++i)
      {
        touched = touched || old[i] == keep || old[i] == gone;
        EXPECT_EQ(after.Corners(face)[i], old[i] == gone ? keep : old[i]);
      }
      EXPECT_TRUE(touched ? normals[0].dot(normals[1]) > 0.0 || normals[0].isZero(0.0)
                          : normals[0] == normals[1])
        << "face " << face << " turned over";
      EXPECT_GT(normals[1].norm(), touched ? 0.0 : -1.0) << "face " << face << " lost its area";
    }
  }

  static Vector3 Normal(const HalfEdgeMesh& mesh, Index face)
  {
    const Triangle c = mesh.Corners(face);
    return AreaVector(mesh.Position(c[0]), mesh.Position(c[1]), mesh.Position(c[2]));
  }

  HalfEdgeMesh Before;
};
}

class EveryCollapse : public EachShape
{
};

TEST_P(EveryCollapse, KeepsTheInvariantsOfTheMesh)
{
  std::int64_t collapses = 0;
  RunToTheEnd(GetParam().Surface,
    [&](const Editor& editor, const Edit&)
    {
      ASSERT_EQ(BrokenInvariant(editor.Mesh()), "") << "collapse " << collapses;
      ++collapses;
      ASSERT_EQ(editor.Totals().Collapses, collapses);
    });
}

TEST_P(EveryCollapse, LeavesTheTopologyAsItWas)
{
  const Surface before = Clean(GetParam().Surface, true).Surface;
  const Topology expected = CountTopology(before);
  const bool hasLoops = expected.NonManifoldPoints + expected.InconsistentEdges == 0;
  const std::size_t loops = BoundaryLoopLengths(before).size();
  const std::int64_t repeated = RepeatedTriangles(before);
  std::int64_t collapses = 0;
  RunToTheEnd(GetParam().Surface,
    [&](const Editor& editor, const Edit&)
    {
      const Surface now = SurfaceOf(editor.Mesh());
      const Topology found = CountTopology(now);
      ++collapses;
      ASSERT_EQ(found.EulerNumber, expected.EulerNumber) << "collapse " << collapses;
      ASSERT_EQ(found.Components, expected.Components) << "collapse " << collapses;
      ASSERT_EQ(found.NonManifoldEdges, expected.NonManifoldEdges) << "collapse " << collapses;
      ASSERT_EQ(found.NonManifoldPoints, expected.NonManifoldPoints) << "collapse " << collapses;
      ASSERT_EQ(found.InconsistentEdges, expected.InconsistentEdges) << "collapse " << collapses;
      ASSERT_TRUE(!hasLoops || BoundaryLoopLengths(now).size() == loops)
        << "collapse " << collapses;
      ASSERT_EQ(RepeatedTriangles(now), repeated) << "collapse " << collapses;
    });
}

TEST_P(EveryCollapse, KeepsTheRulesOfBoundariesAndTurnsNoFaceOver)
{
  RunToTheEnd(GetParam().Surface, EditCheck(GetParam().Surface));
}

TEST_P(EveryCollapse, KeepsAreasAndPointsUpToDate)
{
  const Surface before = Clean(GetParam().Surface, true).Surface;
  Index collapses = 0;
  RunToTheEnd(GetParam().Surface,
    [&](const Editor& editor, const Edit& edit)
    {
      const HalfEdgeMesh& mesh = editor.Mesh();
      FaceAreas areas(editor.Areas());
      for (const Index h : mesh.OutgoingOf(edit.Keep))
      {
        const Index face = HalfEdgeMesh::Face(h);
        areas.Update(mesh, face);
        EXPECT_EQ(areas[face].Area, editor.Areas()[face].Area);
        EXPECT_EQ(areas[face].Normal, editor.Areas()[face].Normal);
      }
      if (++collapses % 16 == 0)
      {
        const double distance = BruteNearest(before, edit.Position).Distance;
        EXPECT_GE(editor.Original().RunningError(edit.Keep), distance - 1e-12);
        EXPECT_GE(editor.Original().MaxError(), distance - 1e-12);
      }
    });
}

INSTANTIATE_TEST_SUITE_P(Shapes, EveryCollapse, testing::ValuesIn(AllShapes()), NameOf);

TEST(Editor, ARejectedEditChangesNothingAndIsCounted)
{
  const CleanSurface clean = Clean(Grid(4), true);
  Editor editor(clean, EditorSettings());
  std::int64_t calls = 0;
  editor.SetHook([&](const Editor&, const Edit&) { ++calls; });
  for (const Index h : HalfEdges(editor.Mesh()))
  {
    EXPECT_NE(TryAlone(editor, { h, editor.Mesh().Origin(h), { 9999, 9999, 9999 }, false }),
      Rejection::NotRejected);
  }
  EXPECT_EQ(calls, 0);
  EXPECT_EQ(editor.Totals().Collapses, 0);
  EXPECT_TRUE(SameBytes(SurfaceOf(editor.Mesh()), clean.Surface));
  std::int64_t rejections = 0;
  for (const std::int64_t count : editor.Totals().Rejections)
  {
    rejections += count;
  }
  EXPECT_EQ(rejections, 3 * editor.Mesh().NumberOfFaceSlots());
  EXPECT_EQ(editor.Totals().Rejections[static_cast<std::size_t>(Rejection::NotRejected)], 0);
}

TEST(Editor, AnEditCanBeAppliedWithoutValidationFirst)
{
  const CleanSurface cleaned = Clean(Grid(4), true);
  Editor editor(cleaned, EditorSettings());
  const HalfEdgeMesh& mesh = editor.Mesh();
  for (const Index h : HalfEdges(mesh))
  {
    if (mesh.Constraint(mesh.Origin(h)) == VertexConstraint::Free &&
      mesh.Constraint(mesh.Target(h)) == VertexConstraint::Free)
    {
      const Vector3 middle = 0.5 * (mesh.Position(mesh.Origin(h)) + mesh.Position(mesh.Target(h)));
      EXPECT_EQ(TryAlone(editor, { h, mesh.Target(h), middle, false }), Rejection::NotRejected);
      break;
    }
  }
  EXPECT_EQ(editor.Totals().Collapses, 1);
  EXPECT_EQ(mesh.NumberOfFaces(), 30);
  EXPECT_EQ(BrokenInvariant(mesh), "");
}

TEST(ThesisCollapse, TakesTheVertexOfLowestCostAndThenItsLowestEdge)
{
  // Checked against costs computed anew for the whole mesh before each of the first collapses, as
  // long as the lowest edge of the lowest vertex is not rejected.
  const Surface surface = BumpySphere(2, 5.0, 0.05, 21);
  HalfEdgeMesh before(Clean(surface, true).Surface);
  FaceAreas areas(before);
  const double mean = MeanEdgeLength(before);
  std::int64_t lowest = 0;
  std::int64_t collapses = 0;
  RunToTheEnd(surface,
    [&](const Editor& editor, const Edit& edit)
    {
      if (++collapses <= 60)
      {
        const NormalFieldDeviation costs(before, areas, Tolerance, mean);
        Index best = None;
        for (Index v = 0; v < before.NumberOfVertexSlots(); ++v)
        {
          const bool isThere = before.Outgoing(v) != None;
          best = isThere && (best == None || costs.OfVertex(v) < costs.OfVertex(best)) ? v : best;
        }
        Index edge = None;
        before.VisitEdges(best,
          [&](Index h) { edge = edge == None || costs.OfEdge(h) < costs.OfEdge(edge) ? h : edge; });
        lowest += edge == edit.Edge || edge == before.Twin(edit.Edge) ? 1 : 0;
      }
      before = editor.Mesh();
      areas = editor.Areas();
    });
  EXPECT_GT(lowest, 50) << "of 60";
}

TEST(ThesisCollapse, AVertexWithRejectedEdgesIsTriedAgainAfterItsRingChanges)
{
  // All remaining edges are rejected again after the loop has ended.
  for (const NamedSurface& shape : AllShapes())
  {
    const CleanSurface cleaned = Clean(shape.Surface, true);
    Editor editor(cleaned, EditorSettings());
    ThesisCollapse loop(editor, OfThesis(), Tolerance);
    EXPECT_EQ(loop.Run({ 0, 0.0 }, [](double) { return true; }), StopReason::NothingLeft)
      << shape.Name;
    const Index faces = editor.Mesh().NumberOfFaces();
    ThesisCollapse again(editor, OfThesis(), Tolerance);
    again.Run({ 0, 0.0 }, [](double) { return true; });
    EXPECT_GT(editor.Mesh().NumberOfFaces(), 0) << shape.Name;
    EXPECT_GE(10 * editor.Mesh().NumberOfFaces(), 9 * faces) << shape.Name;
  }
}
