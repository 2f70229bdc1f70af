// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Edits that are checked at the same time and applied one after the other: what the check of each
// read has not changed.
#include "Base/WorkerTeam.h"
#include "BruteForce.h"
#include "Decimate/Edit/Editor.h"
#include "Decimate/Schedule/BucketSweep.h"
#include "Proof/ErrorBound/Coverage.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <set>
#include <stdexcept>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
const Monitor Always = [](double) { return true; };

EditorSettings Proving(double error, std::shared_ptr<EditFilter> filter = nullptr)
{
  EditorSettings settings{ false, false, true };
  settings.GuardsIntersections = true;
  settings.Bound = ErrorBoundSettings{ error };
  if (filter)
  {
    settings.MoreFilters = { std::move(filter) };
  }
  return settings;
}

/// Id and corners.
using FoundFace = std::pair<Index, std::array<Vector3, 3>>;

std::array<Vector3, 3> PositionsOf(const HalfEdgeMesh& mesh, Index face)
{
  const Triangle c = mesh.Corners(face);
  return { mesh.Position(c[0]), mesh.Position(c[1]), mesh.Position(c[2]) };
}

/// Compares the faces near an edit when it is checked with those when it is committed.
class NearFacesFilter : public EditFilter
{
public:
  explicit NearFacesFilter(double reach)
    : Distance(reach)
  {
  }
  bool NeedsSurfaceChange() const override { return true; }
  std::shared_ptr<EditFilter::Pending> MakePending() override { return std::make_shared<Seen>(); }
  Decision Check(const HalfEdgeMesh& mesh, const SurfaceChange& change,
    EditFilter::Pending& pending) const override
  {
    Seen& seen = static_cast<Seen&>(pending);
    seen.Faces = this->FacesNear(mesh, change);
    seen.IsCompared = false;
    ++this->Checked;
    return Decision::Accept();
  }
  double Reach(const EditFilter::Pending&) const override { return this->Distance; }
  bool StillAccepts(const HalfEdgeMesh& mesh, const SurfaceChange& change,
    EditFilter::Pending& pending) const override
  {
    Seen& seen = static_cast<Seen&>(pending);
    this->Stale += seen.Faces == this->FacesNear(mesh, change) ? 0 : 1;
    seen.IsCompared = true;
    return true;
  }
  void Commit(
    const HalfEdgeMesh&, const SurfaceChange&, EditFilter::Pending& pending, Tally&) override
  {
    this->NotCompared += static_cast<Seen&>(pending).IsCompared ? 0 : 1;
    ++this->Committed;
  }

  mutable std::atomic<int> Checked{ 0 };
  mutable int Stale = 0;
  int NotCompared = 0;
  int Committed = 0;

private:
  struct Seen : public EditFilter::Pending
  {
    std::vector<FoundFace> Faces;
    bool IsCompared = false;
  };

  /// Whose box is within the distance, along each axis, of the box around the faces that change.
  std::vector<FoundFace> FacesNear(const HalfEdgeMesh& mesh, const SurfaceChange& change) const
  {
    std::vector<FoundFace> near;
    Vector3 low = change.NewFaces[0].Corners[0];
    Vector3 high = low;
    const auto add = [&](const std::array<Vector3, 3>& corners)
    {
      for (const Vector3& p : corners)
      {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
    };
    for (const Index face : change.OldFaces)
    {
      add(PositionsOf(mesh, face));
    }
    for (const SurfaceChange::Face& face : change.NewFaces)
    {
      add(face.Corners);
    }
    for (Index face = 0; face < mesh.NumberOfFaceSlots(); ++face)
    {
      if (!mesh.IsAlive(face))
      {
        continue;
      }
      const std::array<Vector3, 3> p = PositionsOf(mesh, face);
      const Vector3 below = low - p[0].cwiseMax(p[1]).cwiseMax(p[2]);
      const Vector3 above = p[0].cwiseMin(p[1]).cwiseMin(p[2]) - high;
      if (below.cwiseMax(above).maxCoeff() <= this->Distance)
      {
        near.emplace_back(face, p);
      }
    }
    return near;
  }

  double Distance; // mm
};

/// Declines each edge once.
class ChangesItsMindFilter : public EditFilter
{
public:
  bool StillAccepts(
    const HalfEdgeMesh&, const SurfaceChange& change, EditFilter::Pending&) const override
  {
    this->Accepts = !this->Declined.insert(change.Requested.Edge).second;
    return this->Accepts;
  }
  void Commit(const HalfEdgeMesh&, const SurfaceChange&, EditFilter::Pending&, Tally&) override
  {
    EXPECT_TRUE(this->Accepts);
    ++this->Committed;
  }

  int Committed = 0;

private:
  mutable bool Accepts = false;
  mutable std::set<Index> Declined;
};

/// Into the middle of the edge.
bool Check(const Editor& editor, HalfEdgeId h, EditWorkspace& space)
{
  const HalfEdgeMesh& mesh = editor.Mesh();
  const Vector3 middle = 0.5 * (mesh.Position(mesh.Origin(h)) + mesh.Position(mesh.Target(h)));
  return editor.Gather(h, space).IsAccepted() &&
    editor.Check({ h, mesh.Origin(h), middle, false }, space).IsAccepted();
}
}

TEST(BatchSweep, AppliesNoEditNearWhichTheMeshHasChangedSinceItsCheck)
{
  const CleanSurface cleaned = Clean(BumpySphere(3, 10.0, 0.1, 7), true);
  for (const int threads : { 1, 3 })
  {
    const auto filter = std::make_shared<NearFacesFilter>(1.0);
    Editor editor(cleaned, Proving(0.3, filter));
    BucketSweep(editor, threads).Run({ 0, 0.0 }, Always);
    EXPECT_EQ(filter->Stale, 0);
    EXPECT_EQ(filter->NotCompared, 0);
    EXPECT_GT(filter->Committed, 100);
    EXPECT_GT(filter->Checked, filter->Committed) << "no two edits of a batch were near each other";
  }
}

TEST(BatchSweep, TriesAnEditAgainThatIsNoLongerAccepted)
{
  const CleanSurface cleaned = Clean(BumpySphere(2, 10.0, 0.1, 7), true);
  const auto filter = std::make_shared<ChangesItsMindFilter>();
  Editor editor(cleaned, Proving(0.3, filter));
  BucketSweep(editor, 1).Run({ 0, 0.0 }, Always);
  EXPECT_GT(filter->Committed, 30);
  EXPECT_EQ(filter->Committed, editor.Totals().Collapses);
}

TEST(BatchSweep, ErrorBoundAcceptsNoEditOfWhichAnotherOneHasChangedTheCoverage)
{
  const CleanSurface cleaned = Clean(BumpySphere(3, 10.0, 0.1, 7), true);
  std::vector<Index> edges = HalfEdges(HalfEdgeMesh(cleaned.Surface, 1), 97);
  for (const Index near : HalfEdges(HalfEdgeMesh(cleaned.Surface, 1)))
  {
    if (near > 0 && near < 24)
    {
      edges.push_back(near);
    }
  }
  int shared = 0;
  int apart = 0;
  for (const HalfEdgeId h : edges)
  {
    Editor editor(cleaned, Proving(1.0));
    EditWorkspace first;
    EditWorkspace second;
    if (!Check(editor, 0, first) || !Check(editor, h, second))
    {
      continue;
    }
    // On the mesh as it was at first every face covers itself.
    const std::vector<Index>& faces = second.Change.OldFaces;
    const bool haveCommon = std::any_of(faces.begin(), faces.end(),
      [&](Index face)
      {
        const std::vector<Index>& others = first.Change.OldFaces;
        return std::find(others.begin(), others.end(), face) != others.end();
      });
    editor.Apply(first);
    EXPECT_EQ(editor.StillAccepts(second), !haveCommon) << h;
    ++(haveCommon ? shared : apart);
  }
  EXPECT_GT(shared, 2);
  EXPECT_GT(apart, 10);
}

TEST(BatchSweep, ACoverageHasAnotherVersionAfterEachChange)
{
  Coverage coverage(1, 2);
  std::set<Coverage::Version> versions = { coverage.VersionOf(0) };
  for (const Index element : { 0, 1 })
  {
    coverage.Add(0, element);
    EXPECT_TRUE(versions.insert(coverage.VersionOf(0)).second);
    coverage.Free(0, 0);
    EXPECT_TRUE(versions.insert(coverage.VersionOf(0)).second);
  }
}

TEST(BatchSweep, FragmentGuardAcceptsNoEditForWhichAnotherOneHasLeftNoVolume)
{
  const Surface sphere = Icosphere(2, 10.0);
  const HalfEdgeMesh mesh(sphere, 1);
  FragmentGuard guard(mesh, sphere);
  const FragmentVolumes none;
  SurfaceChange change;
  change.Vertex = 0;
  change.VolumeChange = -0.4 * 4.0 / 3.0 * 3.14 * 1000.0; // two of them leave too little
  change.Unsettled = &none;
  const std::shared_ptr<EditFilter::Pending> first = guard.MakePending();
  const std::shared_ptr<EditFilter::Pending> second = guard.MakePending();
  ASSERT_TRUE(guard.Screen(mesh, change, *first).IsAccepted());
  ASSERT_TRUE(guard.Screen(mesh, change, *second).IsAccepted());
  EXPECT_TRUE(guard.StillAccepts(mesh, change, *second));
  Tally tally;
  guard.Commit(mesh, change, *first, tally);
  guard.Settle(&tally, 1);
  EXPECT_FALSE(guard.StillAccepts(mesh, change, *second));
}

TEST(WorkerTeam, CallsEachPartOnceInEveryRun)
{
  for (const int threads : { 1, 4 })
  {
    WorkerTeam team(threads);
    std::vector<std::atomic<int>> calls(50);
    for (std::size_t run = 0; run < 200; ++run)
    {
      team.Run(run % 50, [&](std::size_t part) { ++calls[part]; });
    }
    for (std::size_t part = 0; part < 50; ++part)
    {
      EXPECT_EQ(calls[part], 4 * static_cast<int>(49 - part)) << part;
    }
  }
}

TEST(WorkerTeam, RethrowsWhatAPartThrowsAndGoesOn)
{
  WorkerTeam team(2);
  const auto fail = [](std::size_t part)
  {
    if (part == 7)
    {
      throw std::runtime_error("seven");
    }
  };
  EXPECT_THROW(team.Run(20, fail), std::runtime_error);
  std::atomic<int> calls{ 0 };
  team.Run(20, [&](std::size_t) { ++calls; });
  EXPECT_EQ(calls, 20);
}
