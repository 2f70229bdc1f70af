// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Non-manifold surfaces are split into patches, simplified up to their boundaries, and joined
// again.
#include "BruteForce.h"
#include "Decimate/Edit/Editor.h"
#include "Decimate/Edit/PatchRules.h"
#include "EditAlone.h"
#include "Mesh/Invariants.h"
#include "Mesh/ManifoldPatches.h"
#include "Mesh/SpatialOrder.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
CleanSurface Split(const Surface& input)
{
  CleanSurface clean = Clean(input, true);
  SplitIntoManifoldPatches(clean);
  return clean;
}

using Coordinates = std::array<double, 3>;

/// The corners of edges of three or more triangles.
std::set<Coordinates> NonManifoldPositions(const Surface& surface)
{
  std::map<std::pair<Index, Index>, int> edges;
  for (const Triangle& t : surface.Triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      ++edges[std::minmax(t[k], t[(k + 1) % 3])];
    }
  }
  std::set<Coordinates> positions;
  for (const auto& [edge, count] : edges)
  {
    for (const Index v : { edge.first, edge.second })
    {
      if (count > 2)
      {
        positions.insert({ surface.Points[v][0], surface.Points[v][1], surface.Points[v][2] });
      }
    }
  }
  return positions;
}

class EachSplit : public EachShape
{
};
}

TEST_P(EachSplit, IsJoinedToTheOriginalSurface)
{
  const CleanSurface before = Clean(GetParam().Surface, true);
  const CleanSurface clean = Split(GetParam().Surface);
  EXPECT_EQ(
    NumberOfOriginalVertices(clean), static_cast<std::int64_t>(before.Surface.Points.size()));
  WithJoined(clean,
    [&](const Surface& joined)
    {
      EXPECT_EQ(joined.Triangles, before.Surface.Triangles);
      for (std::size_t v = 0; v < joined.Points.size(); ++v)
      {
        EXPECT_EQ(
          joined.Points[v], before.Surface.Points[clean.ManifoldPatches.OriginalVertices[v]]);
        EXPECT_EQ(
          clean.InputPoint[v], before.InputPoint[clean.ManifoldPatches.OriginalVertices[v]]);
      }
    });
}

TEST_P(EachSplit, LeavesManifoldPatchesWithStationaryDuplicates)
{
  CleanSurface clean = Clean(GetParam().Surface, true);
  SortAlongCurve(clean);
  SplitIntoManifoldPatches(clean);
  const std::vector<Index> originals = clean.ManifoldPatches.OriginalVertices;
  const std::vector<Index> order = CurveOrder(clean.Surface.Points);
  SortAlongCurve(clean);
  for (std::size_t v = 0; v < originals.size(); ++v)
  {
    EXPECT_EQ(order[clean.ManifoldPatches.OriginalVertices[v]], originals[order[v]])
      << "duplicates are where sorting all points puts them";
  }
  const HalfEdgeMesh mesh(clean.Surface, 1, clean.ManifoldPatches);
  EXPECT_EQ(BrokenInvariant(mesh), "");
  std::int64_t constrained = 0; // where a patch meets itself along a single edge
  for (Index v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    constrained += mesh.Constraint(v) == VertexConstraint::NonManifold ? 1 : 0;
  }
  EXPECT_EQ(CountTopology(clean.Surface).NonManifoldPoints, constrained);
  EXPECT_LE(constrained, GetParam().Name == "DenseSoup" ? 40 : 2);
  for (Index v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    const bool isAlone = mesh.NextDuplicate(v) == v;
    EXPECT_EQ(mesh.OriginalVertex(mesh.NextDuplicate(v)), mesh.OriginalVertex(v));
    EXPECT_EQ(mesh.Position(mesh.NextDuplicate(v)), mesh.Position(v));
    EXPECT_TRUE(isAlone ? !mesh.IsStationary(v) : mesh.IsStationary(v) || mesh.IsConstrained(v));
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, EachSplit, testing::ValuesIn(BrokenShapes()), NameOf);

TEST(ManifoldPatches, AreSimplifiedUpToTheirBoundariesInEveryMode)
{
  const Surface input = HalvedBall(10);
  const Topology before = CountTopology(input);
  ASSERT_GT(before.NonManifoldEdges, 40);
  const std::set<Coordinates> nonManifold = NonManifoldPositions(input);
  for (const Mode mode : AllModes())
  {
    const Result result = Decimate(input, InMode(mode, Reduction(0.8)));
    const Topology after = CountTopology(result.Surface);
    EXPECT_EQ(result.Report.Stop, StopReason::TargetReached) << WordOf(mode);
    EXPECT_LE(5 * after.Faces, before.Faces + 5) << WordOf(mode);
    EXPECT_EQ(after.NonManifoldEdges, before.NonManifoldEdges) << WordOf(mode);
    EXPECT_EQ(after.BoundaryEdges, 0) << WordOf(mode) << ": a crack";
    EXPECT_EQ(after.EulerNumber, before.EulerNumber) << WordOf(mode);
    EXPECT_EQ(NonManifoldPositions(result.Surface), nonManifold) << WordOf(mode);
    EXPECT_EQ(result.Report.Input.NonManifoldEdges, before.NonManifoldEdges) << WordOf(mode);
    EXPECT_EQ(result.Report.Input.Points, before.Points) << WordOf(mode);
    EXPECT_EQ(result.Report.Input.Components, 1) << WordOf(mode);
  }
}

TEST(ManifoldPatches, NeverMeetAlongAnEdgeThatTheyDidNotHaveInCommon)
{
  // So few triangles are requested that only invalid edits are left.
  for (const std::uint64_t seed : { 1, 2, 3, 4 })
  {
    const Surface soup = RandomSoup(200, 260, seed);
    for (const Surface& input : { HalvedBall(4 + static_cast<Index>(seed)), soup })
    {
      const Topology before = CountTopology(input);
      for (const Mode mode : AllModes())
      {
        const Topology after = CountTopology(Decimate(input, InMode(mode, Triangles(1))).Surface);
        EXPECT_LE(after.NonManifoldEdges, before.NonManifoldEdges) << WordOf(mode) << seed;
        EXPECT_LE(after.BoundaryEdges, before.BoundaryEdges) << WordOf(mode) << seed;
      }
    }
  }
}

/// Two open strips that have one point in common, at which each has a single triangle.
Surface BowTie()
{
  Surface tie = { { { 0, 0, 0 } }, {} };
  for (const double side : { 1.0, -1.0 })
  {
    const Index first = static_cast<Index>(tie.Points.size());
    for (const double x : { 1.0, 2.0, 3.0 })
    {
      tie.Points.push_back({ side * x, -0.5, 0 });
      tie.Points.push_back({ side * x, 0.5, 0 });
    }
    tie.Triangles.push_back({ 0, first, first + 1 });
    for (Index k = first; k < first + 4; k += 2)
    {
      tie.Triangles.push_back({ k, k + 2, k + 1 });
      tie.Triangles.push_back({ k + 1, k + 2, k + 3 });
    }
  }
  for (std::size_t t = tie.Triangles.size() / 2; t < tie.Triangles.size(); ++t)
  {
    std::swap(tie.Triangles[t][1], tie.Triangles[t][2]); // both halves have the same side up
  }
  return tie;
}

TEST(ManifoldPatches, KeepTheLastTriangleAtAStationaryEndOfABoundary)
{
  const CleanSurface clean = Split(BowTie());
  Editor editor(HalfEdgeMesh(clean.Surface, 1, clean.ManifoldPatches), clean, EditorSettings());
  const HalfEdgeMesh& mesh = editor.Mesh();
  for (const Index last : { 0, 5 }) // the only triangles of their patches at the point
  {
    for (const Index k : { 0, 2 })
    {
      const Index h = HalfEdgeMesh::HalfEdge(last, k);
      ASSERT_TRUE(mesh.IsStationary(mesh.Origin(h)) || mesh.IsStationary(mesh.Target(h)));
      EXPECT_EQ(GatherAlone(editor, h), Rejection::Boundary) << last << " " << k;
    }
  }
}

TEST(ManifoldPatches, RequireOnlyDuplicatesToLieInTheBlock)
{
  // Otherwise a single patch boundary would prevent every edit at the ends of blocks in the whole
  // mesh.
  const CleanSurface clean = Split(HalvedBall(6));
  const HalfEdgeMesh mesh(clean.Surface, 1, clean.ManifoldPatches);
  const VertexRange nothing = { 0, 0 };
  const auto hasCopies = [&mesh](Index v) { return mesh.NextDuplicate(v) != v; };
  EdgeNeighborhood around;
  std::int64_t alone = 0;
  for (const Index h : HalfEdges(mesh))
  {
    if (mesh.Twin(h) != None && !mesh.IsConstrained(mesh.Origin(h)) &&
      !mesh.IsConstrained(mesh.Target(h)))
    {
      around.Gather(mesh, h);
      const bool isAlone = !hasCopies(around.Start) && !hasCopies(around.End) &&
        std::none_of(around.Ring.begin(), around.Ring.end(), hasCopies);
      EXPECT_EQ(
        CheckPatches(mesh, around, nothing), isAlone ? Decision::Accept() : Decision::Defer());
      const Index a = around.Apexes[0];
      const Index b = around.Apexes[1];
      EXPECT_EQ(CheckNewEdge(mesh, a, b, nothing).IsDeferred(), hasCopies(a) || hasCopies(b));
      alone += isAlone ? 1 : 0;
    }
  }
  EXPECT_GT(alone, 100);
}

TEST(ManifoldPatches, GiveTheSameBytesForAnyNumberOfThreads)
{
  Surface input = ThreeLeavedBook(75); // enough points for blocks
  for (Vector3& p : input.Points)
  {
    p += 0.3 * std::sin(0.9 * p[1]) *
      Vector3(-p[2], 0.0, p[0])
        .normalized()
        .unaryExpr([](double x) { return std::isfinite(x) ? x : 0.0; });
  }
  ExpectTheSameBytesForAnyNumberOfThreads(input, InMode(Mode::Fast, Triangles(30000)));
  Options proved = InMode(Mode::Fast, Triangles(33200));
  proved.MaximumError = 0.1;
  ExpectTheSameBytesForAnyNumberOfThreads(input, proved);
}
