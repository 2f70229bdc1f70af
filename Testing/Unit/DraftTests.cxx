// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Collapses that are drafted, proved together and undone: compared with the mesh as it was, edit by
// edit, and by brute force.
#include "Crossings.h"
#include "Decimate/Edit/Editor.h"
#include "EditAlone.h"
#include "Mesh/Invariants.h"
#include "MeshState.h"
#include "Proof/Certificate/Certificate.h"
#include "Proof/EditFilters/EditJournal.h"
#include "Run/Levels.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
const Monitor Never = [](double) { return true; };

EditorSettings Proving(double error, bool hasGuard = true)
{
  EditorSettings settings;
  settings.RecordsDistances = false;
  settings.KeepsAreas = false;
  settings.KeepsQuadrics = true;
  settings.GuardsIntersections = hasGuard;
  settings.Bound = ErrorBoundSettings{ error };
  return settings;
}

EditorSettings Recording(const std::shared_ptr<EditJournal>& journal)
{
  EditorSettings settings;
  settings.MoreFilters = { journal };
  settings.KeepsAreas = false;
  settings.RecordsDistances = false;
  return settings;
}

/// Into the middle of the edge, if it is allowed.
bool CollapseEdge(Editor& editor, HalfEdgeId h)
{
  const HalfEdgeMesh& mesh = editor.Mesh();
  if (!mesh.IsAlive(HalfEdgeMesh::Face(h)) || !GatherAlone(editor, h).IsAccepted())
  {
    return false;
  }
  const Vector3 middle = 0.5 * (mesh.Position(mesh.Origin(h)) + mesh.Position(mesh.Target(h)));
  return TryAlone(editor, { h, mesh.Origin(h), middle, false }).IsAccepted();
}

Index CollapseMany(Editor& editor, Index step, Index most = 1 << 30)
{
  Index count = 0;
  for (const Index h : HalfEdges(editor.Mesh(), step))
  {
    count += count < most && CollapseEdge(editor, h) ? 1 : 0;
  }
  return count;
}

VertexId VertexAt(const HalfEdgeMesh& mesh, const CleanSurface& clean, const Vector3& p)
{
  VertexId v = 0;
  while (v < mesh.NumberOfVertexSlots() && (mesh.Position(v) + clean.Origin - p).norm() > 1e-9)
  {
    ++v;
  }
  return v;
}

HalfEdgeId EdgeBetween(const HalfEdgeMesh& mesh, VertexId from, VertexId to)
{
  HalfEdgeId edge;
  for (const HalfEdgeId h : mesh.OutgoingOf(from))
  {
    edge = mesh.Target(h) == to ? h : edge;
  }
  return edge;
}

/// A plate with a tip of that height (mm) in the middle and, under the tip, a tetrahedron or none.
Surface TippedPlate(bool hasTetrahedron, double height = 0.4)
{
  Surface plate = Grid(8);
  Vector3 low = plate.Points[0];
  Vector3 high = low;
  for (const Vector3& p : plate.Points)
  {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  for (Vector3& p : plate.Points)
  {
    p = 8.0 * (p - low) / (high - low).maxCoeff();
    p[2] = (p - Vector3(4.0, 4.0, p[2])).norm() < 1e-6 ? height : 0.0;
  }
  if (!hasTetrahedron)
  {
    return plate;
  }
  Surface inside = Tetrahedron();
  Vector3 middle = Vector3::Zero();
  for (const Vector3& p : inside.Points)
  {
    middle += p / 4.0;
  }
  double radius = 0.0;
  for (const Vector3& p : inside.Points)
  {
    radius = std::max(radius, (p - middle).norm());
  }
  for (Vector3& p : inside.Points)
  {
    p = Vector3(4.03, 4.02, 0.2) + 0.03 * (p - middle) / radius;
  }
  return Together(plate, inside);
}

/// Flattens the tip in a draft, and returns how many of the edits are left.
std::int64_t CollapsesLeftOfTip(bool hasTetrahedron)
{
  const Surface input = TippedPlate(hasTetrahedron);
  const CleanSurface clean = Clean(input, true);
  Editor editor(clean, Proving(0.8));
  const HalfEdgeMesh& mesh = editor.Mesh();
  const VertexId tip = VertexAt(mesh, clean, Vector3(4.0, 4.0, 0.4));
  const VertexId next = VertexAt(mesh, clean, Vector3(5.0, 4.0, 0.0));
  EXPECT_TRUE(MakeProvedDraft(editor,
    [&]
    {
      const HalfEdgeId edge = EdgeBetween(mesh, tip, next);
      EXPECT_TRUE(GatherAlone(editor, edge).IsAccepted());
      TryAlone(editor, { edge, next, mesh.Position(next), false });
    }));
  return editor.Totals().Collapses;
}
}

TEST(Draft, UndoRestoresTheMeshBitForBit)
{
  for (const Surface& input :
    { BumpySphere(3, 10.0, 0.3, 5), HeightField(12, 0.4, 3), Torus(24, 12) })
  {
    const CleanSurface clean = Clean(input, true);
    Editor editor(clean, Proving(2.0));
    const std::vector<double> before = StateOf(editor.Mesh());
    const auto collapseAndStop = [&]
    {
      EXPECT_GT(CollapseMany(editor, 1), 20);
      EXPECT_NE(StateOf(editor.Mesh()), before);
      return false;
    };
    EXPECT_FALSE(editor.MakeDraft(1, collapseAndStop, Never));
    EXPECT_EQ(editor.Totals().Draft.Status, DraftStatus::Used);
    EXPECT_EQ(StateOf(editor.Mesh()), before);
    EXPECT_EQ(editor.Totals().Collapses, 0);
    const std::vector<Index> current = editor.Original().CurrentVertices();
    for (std::size_t v = 0; v < current.size(); ++v)
    {
      ASSERT_EQ(current[v], static_cast<Index>(v));
    }
  }
}

TEST(Draft, IsMadeOnceAndOnlyWithABound)
{
  const CleanSurface clean = Clean(Icosphere(2, 10.0), true);
  EditorSettings settings = Proving(1.0);
  settings.Bound.reset();
  const auto nothing = [] {};
  Editor unbound(clean, settings);
  EXPECT_FALSE(MakeProvedDraft(unbound, nothing));
  settings = Proving(1.0);
  settings.RecordsEdits = true;
  Editor recording(clean, settings);
  EXPECT_FALSE(MakeProvedDraft(recording, nothing));
  EXPECT_EQ(recording.Totals().Draft.Status, DraftStatus::EditsAreRecorded);
  Editor editor(clean, Proving(1.0));
  EXPECT_TRUE(MakeProvedDraft(editor, nothing));
  EXPECT_FALSE(MakeProvedDraft(editor, nothing));
}

TEST(Draft, KeepsOnlyWhatIsProved)
{
  for (const double error : { 0.02, 0.2, 1.0 })
  {
    const Surface input = BumpySphere(4, 10.0, 0.3, 7);
    const CleanSurface clean = Clean(input, true);
    Editor editor(clean, Proving(error));
    ASSERT_TRUE(MakeProvedDraft(editor, [&] { CollapseMany(editor, 1); }));
    EXPECT_EQ(BrokenInvariant(editor.Mesh()), "");
    Surface result = SurfaceOf(editor.Mesh());
    for (Vector3& p : result.Points)
    {
      p += clean.Origin;
    }
    CertificateOptions options;
    options.Tolerance = error;
    EXPECT_EQ(Certify(input, result, options).Proof, ProofStatus::Proved) << error;
    // Its coverage serves the edits that follow.
    CollapseMany(editor, 5);
    result = SurfaceOf(editor.Mesh());
    for (Vector3& p : result.Points)
    {
      p += clean.Origin;
    }
    EXPECT_EQ(Certify(input, result, options).Proof, ProofStatus::Proved) << error;
  }
}

TEST(Draft, JumpsOverNothing)
{
  EXPECT_EQ(CollapsesLeftOfTip(false), 1);
  EXPECT_EQ(CollapsesLeftOfTip(true), 0);
}

TEST(Draft, AbortUndoesAllOfIt)
{
  const Surface input = Icosphere(4, 10.0);
  const CleanSurface clean = Clean(input, true);
  Editor editor(clean, Proving(0.5));
  const std::vector<double> before = StateOf(editor.Mesh());
  bool isCollapsed = false;
  const auto collapse = [&] { return isCollapsed = CollapseMany(editor, 1) > 20; };
  EXPECT_FALSE(editor.MakeDraft(1, collapse, [&](double) { return !isCollapsed; }));
  EXPECT_GT(editor.Totals().Draft.Collapses, 20);
  EXPECT_EQ(StateOf(editor.Mesh()), before);
}

TEST(Draft, AbortAtManyCallsOfTheMonitorLeavesTheMeshAsItWas)
{
  const Surface input = Icosphere(2, 10.0);
  const CleanSurface clean = Clean(input, true);
  int calls = 0;
  bool isDone = false;
  for (int most = 0; !isDone; most += 1 + most / 4)
  {
    Editor editor(clean, Proving(0.5));
    const std::vector<double> before = StateOf(editor.Mesh());
    calls = 0;
    isDone = editor.MakeDraft(
      1, [&] { return CollapseMany(editor, 1) > 20; }, [&](double) { return calls++ < most; });
    EXPECT_EQ(calls > most, !isDone);
    EXPECT_EQ(StateOf(editor.Mesh()) == before, !isDone) << most;
    EXPECT_GT(CollapseMany(editor, 5), 0); // with its own filters
  }
  EXPECT_GT(calls, 5);
}

TEST(Draft, IsReportedWithAReason)
{
  const Surface input = Icosphere(4, 10.0);
  const Report report = Decimate(input, InMode(Mode::Fast, Error(0.1))).Report;
  EXPECT_EQ(report.Edits.Draft.Status, DraftStatus::Used);
  EXPECT_GT(report.Edits.Draft.Collapses, report.Edits.Draft.Undone);
  EXPECT_EQ(Decimate(input, Triangles(1000)).Report.Edits.Draft.Status, DraftStatus::NoBound);
  EXPECT_EQ(Decimate(input, InMode(Mode::Thesis, Error(0.1))).Report.Edits.Draft.Status,
    DraftStatus::NoBound);
  Options careful = InMode(Mode::Fast, Error(0.1));
  careful.ProveEachEdit = true;
  EXPECT_EQ(Decimate(input, careful).Report.Edits.Draft.Status, DraftStatus::EachEditIsProved);
}

TEST(Draft, ReachesATargetWithinTheBound)
{
  const Surface input = Icosphere(4, 10.0);
  Options options = InMode(Mode::Fast, Error(0.5));
  options.TargetNumberOfTriangles = 2000;
  const Result result = Decimate(input, options);
  EXPECT_EQ(result.Report.Stop, StopReason::TargetReached);
  EXPECT_EQ(result.Surface.Triangles.size(), 2000U);
  EXPECT_EQ(result.Report.Proof.Status, ProofStatus::Proved);
}

TEST(EditJournal, UndoesWhatDependsOnAnEditAndNothingElse)
{
  const CleanSurface clean = Clean(Icosphere(3, 10.0), true);
  const auto journal = std::make_shared<EditJournal>(HalfEdgeMesh(clean.Surface));
  Editor editor(clean, Recording(journal));
  ASSERT_GT(CollapseMany(editor, 3), 100);
  for (Index edit = 0; edit < journal->Count(); edit += 7)
  {
    // By definition: an edit depends on it if it has a face in common with it or with one that
    // depends on it, and is later.
    std::set<Index> touched;
    std::vector<Index> expected;
    for (Index later = edit; later < journal->Count(); ++later)
    {
      bool depends = later == edit;
      for (Index i = 0; i < journal->Entry(later).NumberOfFaces; ++i)
      {
        depends = depends || touched.count(journal->OldFace(later, i).Face) > 0;
      }
      for (Index i = 0; depends && i < journal->Entry(later).NumberOfFaces; ++i)
      {
        touched.insert(journal->OldFace(later, i).Face);
      }
      if (depends)
      {
        expected.insert(expected.begin(), later);
      }
    }
    EXPECT_EQ(journal->DependentsOf(edit), expected);
  }
}
