// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Gaps where edits of a draft are undone, and where a gap is read through a duplicate.
#include "BruteForce.h"
#include "Crossings.h"
#include "EditAlone.h"
#include "GuardedEditor.h"
#include "Mesh/ManifoldPatches.h"
#include "Proof/Guard/FaceGrid.h"
#include "Proof/Guard/GapRule.h"
#include "Proof/Guard/PairFace.h"
#include "Proof/Guard/TrianglePair.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
void CollapseAll(Editor& editor)
{
  const HalfEdgeMesh& mesh = editor.Mesh();
  for (const HalfEdgeId h : HalfEdges(mesh))
  {
    if (mesh.IsAlive(HalfEdgeMesh::Face(h)) && GatherAlone(editor, h).IsAccepted())
    {
      const Vector3 middle = 0.5 * (mesh.Position(mesh.Origin(h)) + mesh.Position(mesh.Target(h)));
      TryAlone(editor, { h, mesh.Origin(h), middle, false });
    }
  }
}

/// mm, to the other fragment, the least of the vertices that each vertex represents.
std::vector<double> GapsNow(const Editor& editor, const GapRule& first)
{
  const std::vector<Index> current = editor.Original().CurrentVertices();
  std::vector<double> gaps(current.size(), std::numeric_limits<double>::infinity());
  for (std::size_t v = 0; v < current.size(); ++v)
  {
    double& least = gaps[current[v]];
    least = std::min<double>(least, first.Of(static_cast<Index>(v)).BetweenFragments);
  }
  return gaps;
}

/// Pairs of triangles of two fragments that are nearer than half the gap at their corners.
int CountNarrow(const Editor& editor, const CleanSurface& clean, double error)
{
  struct Face
  {
    TriangleCorners Corners;
    Vector3 Low, High;
    Index Part;
    double Gap;
  };
  const GapRule first(clean.Surface, 4.0 * error, 1);
  const std::vector<double> gaps = GapsNow(editor, first);
  const HalfEdgeMesh& mesh = editor.Mesh();
  std::vector<Face> faces;
  int count = 0;
  for (FaceId id = 0; id < mesh.NumberOfFaceSlots(); ++id)
  {
    if (!mesh.IsAlive(id))
    {
      continue;
    }
    const Triangle v = mesh.Corners(id);
    const TriangleCorners c = { mesh.Position(v[0]), mesh.Position(v[1]), mesh.Position(v[2]) };
    const Face face = { c, c[0].cwiseMin(c[1]).cwiseMin(c[2]), c[0].cwiseMax(c[1]).cwiseMax(c[2]),
      first.FragmentOf(v[0]), std::min({ gaps[v[0]], gaps[v[1]], gaps[v[2]] }) };
    for (const Face& other : faces)
    {
      const double half = 0.5 * std::min(face.Gap, other.Gap);
      const bool mayBeNear = face.Part != other.Part &&
        (face.Low - other.High).cwiseMax(other.Low - face.High).maxCoeff() < half;
      count +=
        mayBeNear && ShortestConnection(face.Corners, other.Corners).SquaredLength < half * half
        ? 1
        : 0;
    }
    faces.push_back(face);
  }
  return count;
}
}

TEST(GapsOfADraft, AreCheckedAgainWhereAnUndoneEditHasRestoredAFace)
{
  // Two rough walls beside each other: edits of one are undone where those of the other are left.
  const double error = 1.0;
  std::int64_t undone = 0;
  for (const std::uint64_t seed : { 2U, 4U, 6U, 8U, 10U, 12U })
  {
    const Surface outer = BumpySphere(3, 10.0, 0.02, seed);
    const Surface input = Together(outer, TurnedInsideOut(BumpySphere(3, 9.2, 0.03, seed + 1)));
    const CleanSurface clean = Clean(input, true);
    Editor editor(clean, Guarded(error));
    const int before = CountNarrow(editor, clean, error);
    ASSERT_TRUE(MakeProvedDraft(editor, [&] { CollapseAll(editor); }));
    const DraftFigures figures = editor.Totals().Draft;
    undone += figures.Undone;
    ASSERT_GT(figures.Collapses, figures.Undone);
    EXPECT_LE(CountNarrow(editor, clean, error), before) << seed;
  }
  EXPECT_GT(undone, 0);
}

namespace
{
HalfEdgeId EdgeAt(const Editor& editor, const CleanSurface& clean, Vector3 from, Vector3 to)
{
  const HalfEdgeMesh& mesh = editor.Mesh();
  HalfEdgeId edge;
  for (const HalfEdgeId h : HalfEdges(mesh))
  {
    const bool isIt = (mesh.Position(mesh.Origin(h)) + clean.Origin - from).norm() < 1e-9 &&
      (mesh.Position(mesh.Target(h)) + clean.Origin - to).norm() < 1e-9;
    edge = isIt ? h : edge;
  }
  return edge;
}

}

/// The first two edits narrow the gap between two plates from both sides, the third one keeps it.
TEST(GapsOfADraft, AreNotAllowedByThoseThatTheDraftHasNarrowed)
{
  for (const double depth : { 0.2, 0.3 })
  {
    const CleanSurface clean =
      Clean(Together(Moved(Grid(8), Vector3(0.0, 0.0, 1.0)), TurnedInsideOut(Grid(8))), true);
    Editor editor(clean, Guarded(1.0));
    const auto collapse = [&](const Vector3& from, const Vector3& to, const Vector3& position)
    {
      const HalfEdgeId edge = EdgeAt(editor, clean, from, to);
      const VertexId keep = editor.Mesh().Target(edge);
      return TryAlone(editor, { edge, keep, position - clean.Origin, false }).IsAccepted();
    };
    const Vector3 below = Vector3(4.0, 4.0, depth);
    const Vector3 above = Vector3(4.0, 4.0, 1.0 - depth);
    const auto collapseAll = [&]
    {
      EXPECT_TRUE(collapse(Vector3(3.0, 4.0, 0.0), Vector3(4.0, 4.0, 0.0), below));
      EXPECT_TRUE(collapse(Vector3(3.0, 4.0, 1.0), Vector3(4.0, 4.0, 1.0), above));
      EXPECT_TRUE(collapse(Vector3(5.0, 4.0, 1.0), above, above));
    };
    ASSERT_TRUE(MakeProvedDraft(editor, collapseAll));
    EXPECT_EQ(editor.Totals().Draft.Collapses, 3);
    EXPECT_EQ(editor.Totals().Collapses, depth < 0.25 ? 3 : 1);
  }
}

namespace
{
/// To its target.
bool CheckToTarget(const Editor& editor, HalfEdgeId h, EditWorkspace& space)
{
  const HalfEdgeMesh& mesh = editor.Mesh();
  const VertexId target = mesh.Target(h);
  return editor.Gather(h, space).IsAccepted() &&
    editor.Check({ h, target, mesh.Position(target), false }, space).IsAccepted();
}

/// Two grids, the second of long triangles, have the point (8, 4, 0) alone in common. An edit there
/// gives it the gap of (7, 4, 0) or of (7, 3, 0). Whether an edit of the second grid that has been
/// checked before, more than 10 mm away, is still accepted.
bool IsStillAccepted(bool hasGap)
{
  Surface wide = Moved(Grid(8), Vector3(0.0, -4.0, 0.0));
  for (Vector3& p : wide.Points)
  {
    p = Vector3(8.0 + 10.0 * p[0], 4.0 + (p[1] == -4.0 ? 0.0 : 0.1 + p[1] + 4.0), 0.0);
  }
  const Surface speck =
    Moved(Scaled(Tetrahedron(), 0.1), hasGap ? Vector3(6.95, 3.95, 0.3) : Vector3(3.0, 3.95, 0.3));
  CleanSurface clean = Clean(Together(Together(Grid(8), wide), speck), true);
  SplitIntoManifoldPatches(clean);
  Editor editor(clean, Guarded(0.2));
  EditWorkspace here;
  EditWorkspace there;
  const Vector3 common(8.0, 4.0, 0.0);
  EXPECT_TRUE(CheckToTarget(editor, EdgeAt(editor, clean, { 7.0, 4.0, 0.0 }, common), here));
  EXPECT_TRUE(
    CheckToTarget(editor, EdgeAt(editor, clean, { 28.0, 5.1, 0.0 }, { 38.0, 5.1, 0.0 }), there));
  editor.Apply(here);
  return editor.StillAccepts(there);
}
}

TEST(IntersectionGuard, AcceptsNoEditThatHasReadAGapThroughADuplicateAfterThatGapHasChanged)
{
  EXPECT_TRUE(IsStillAccepted(false));
  EXPECT_FALSE(IsStillAccepted(true));
}

namespace
{
/// Whether the long edge of a roof may be collapsed to a position beyond a speck that is far from
/// the faces before and after: 0.28 mm and 0.61 mm, and 0.15 mm from the box around each of them.
bool MayJumpOver(const Surface& speck)
{
  const double half = 3.7; // mm, of the edge
  Surface roof;
  roof.Points = { { 0.9, -half, 0.1 }, { 0.9, half, 0.1 }, { 0.0, -half, 0.0 }, { 0.0, half, 0.0 },
    { 1.0, -half, 1.0 }, { 1.0, half, 1.0 }, { 0.5, -7.5, 0.5 }, { 0.5, 7.5, 0.5 } };
  roof.Triangles = { { 0, 1, 3 }, { 1, 0, 4 }, { 0, 3, 2 }, { 1, 4, 5 }, { 0, 2, 6 }, { 0, 6, 4 },
    { 1, 7, 3 }, { 1, 5, 7 } };
  const CleanSurface clean = Clean(Together(roof, speck), true);
  Editor editor(clean, Guarded(0.89));
  const HalfEdgeMesh& mesh = editor.Mesh();
  const auto isAt = [&](VertexId v, const Vector3& p)
  { return (mesh.Position(v) + clean.Origin - p).norm() < 1e-9; };
  for (const HalfEdgeId h : HalfEdges(mesh))
  {
    if (isAt(mesh.Origin(h), roof.Points[0]) && isAt(mesh.Target(h), roof.Points[1]))
    {
      EXPECT_TRUE(GatherAlone(editor, h).IsAccepted());
      const Vector3 beyond = Vector3(0.1, 0.0, 0.9) - clean.Origin;
      return TryAlone(editor, { h, mesh.Origin(h), beyond, false }).IsAccepted();
    }
  }
  return false;
}
}

TEST(IntersectionGuard, NothingIsJumpedOverThatIsFarFromTheFacesBeforeAndAfter)
{
  Surface speck = Scaled(Tetrahedron(), 0.05);
  Vector3 middle = Vector3::Zero();
  for (const Vector3& p : speck.Points)
  {
    middle += p / 4.0;
  }
  EXPECT_FALSE(MayJumpOver(Moved(speck, Vector3(0.65, 0.02, 0.35) - middle)));
  EXPECT_TRUE(MayJumpOver(Moved(speck, Vector3(0.65, 0.02, -3.35) - middle)));
}

namespace
{
/// Whether a face that meets one face may be replaced by one that meets another.
bool MeetsMore(bool isOfAnotherFragment)
{
  const Surface upright = { { { 0.0, -1.0, -1.0 }, { 0.0, 1.0, -1.0 }, { 0.0, 0.0, 1.0 } },
    { { 0, 1, 2 } } };
  const Surface flat = { { { -0.5, -0.2, 0.0 }, { 0.5, -0.2, 0.0 }, { 0.0, 0.4, 0.0 } },
    { { 0, 1, 2 } } };
  const Vector3 away(5.0, 0.0, 0.0);
  const HalfEdgeMesh mesh(
    Together(Together(upright, Moved(upright, away)), Together(flat, Moved(flat, away))));
  std::vector<PairFace> pieces;
  for (FaceId face = 0; face < 4; ++face)
  {
    pieces.emplace_back(mesh, mesh.Corners(face), CornersOf(mesh, mesh.Corners(face)));
    pieces.back().Fragment = 0;
  }
  pieces[3].Fragment = isOfAnotherFragment ? 1 : 0;
  std::vector<PairFace> before = { pieces[0] };
  std::vector<PairFace> after = { pieces[1] };
  std::vector<PairFace> near = { pieces[2], pieces[3] };
  return MeetMore(before, after, near, WrittenPositions());
}
}

TEST(IntersectionGuard, APairOfOneFragmentIsNotReplacedByAPairOfTwo)
{
  EXPECT_FALSE(MeetsMore(false));
  EXPECT_TRUE(MeetsMore(true));
}
