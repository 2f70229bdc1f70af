// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BruteForce.h"
#include "Decimate/Edit/CollapseRules.h"
#include "Decimate/Edit/Editor.h"
#include "Decimate/Placement/PlaneQuadric.h"
#include "Random.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// A mesh with the data that placement needs.
struct Bench
{
  explicit Bench(const Surface& surface)
    : Mesh(surface)
    , Areas(Mesh)
  {
  }

  Index EdgeBetween(const Vector3& from, const Vector3& to) const
  {
    for (const Index h : HalfEdges(this->Mesh))
    {
      if ((this->Mesh.Position(this->Mesh.Origin(h)) - from).norm() < 1e-12 &&
        (this->Mesh.Position(this->Mesh.Target(h)) - to).norm() < 1e-12)
      {
        return h;
      }
    }
    return None;
  }

  EdgeNeighborhood Around(Index edge)
  {
    EdgeNeighborhood around;
    around.Gather(this->Mesh, edge);
    return around;
  }

  PositionCandidates Propose(Index edge)
  {
    return PlaneQuadricPositions(this->Mesh, this->Areas, this->Around(edge));
  }

  PositionCandidates Propose(const Vector3& from, const Vector3& to)
  {
    return this->Propose(this->EdgeBetween(from, to));
  }

  /// What the first proposal minimizes: squared distances to the planes of both rings, and the
  /// ridge.
  double SumOfSquares(
    const EdgeNeighborhood& around, const Vector3& position, const Vector3& middle) const
  {
    double sum = 0.0;
    double planes = 0.0;
    const auto add = [&](Index face, Index vertex)
    {
      sum += std::pow(this->Areas[face].Normal.dot(position - this->Mesh.Position(vertex)), 2);
      planes += 1.0; // the trace of each plane's matrix
    };
    for (const Index corner : around.Corners)
    {
      add(HalfEdgeMesh::Face(corner), this->Mesh.Origin(corner));
    }
    add(around.RemovedFaces[0], around.Start);
    add(around.RemovedFaces[1], around.Start);
    return sum + 1e-3 * planes / 3.0 * (position - middle).squaredNorm();
  }

  HalfEdgeMesh Mesh;
  FaceAreas Areas;
};

/// A cube of 4 mm with edges of 1 mm.
Surface Box()
{
  return Scaled(Cube(4), 4.0);
}

/// The ridge moves the minimum by up to this from that of the exact planes, with edges of 1 mm.
constexpr double RidgeTolerance = 0.01; // mm
}

TEST(PlaneQuadric, InAPlaneTheVertexStaysInThePlane)
{
  Bench bench(Grid(5));
  const PositionCandidates proposals = bench.Propose(Vector3(2, 2, 0), Vector3(3, 2, 0));
  ASSERT_GT(proposals.Count, 0U);
  for (std::size_t i = 0; i < proposals.Count; ++i)
  {
    EXPECT_EQ(proposals.Edits[i].Position.z(), 0.0);
  }
  EXPECT_LT((proposals.Edits[0].Position - Vector3(2.5, 2, 0)).norm(), 1e-12)
    << "planes leave it free: the middle";
}

TEST(PlaneQuadric, AtASharpEdgeTheVertexStaysOnTheEdge)
{
  Bench bench(Box());
  const Vector3 position = bench.Propose(Vector3(2, 0, 0), Vector3(3, 0, 0)).Edits[0].Position;
  EXPECT_NEAR(position.y(), 0.0, 1e-12);
  EXPECT_NEAR(position.z(), 0.0, 1e-12);
}

TEST(PlaneQuadric, FromASideToASharpEdgeTheVertexGoesToTheEdge)
{
  Bench bench(Box());
  const Vector3 position = bench.Propose(Vector3(2, 1, 0), Vector3(2, 0, 0)).Edits[0].Position;
  EXPECT_NEAR(position.y(), 0.0, RidgeTolerance);
  EXPECT_NEAR(position.z(), 0.0, RidgeTolerance);
}

TEST(PlaneQuadric, AtACornerTheVertexGoesToTheCorner)
{
  Bench bench(Box());
  for (const Vector3& next : { Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1) })
  {
    EXPECT_LT(bench.Propose(next, Vector3(0, 0, 0)).Edits[0].Position.norm(), RidgeTolerance);
    EXPECT_LT(bench.Propose(Vector3(0, 0, 0), next).Edits[0].Position.norm(), RidgeTolerance);
  }
}

TEST(PlaneQuadric, TheFirstProposalIsTheMinimumOfTheQuadricWithItsRidge)
{
  Bench bench(BumpySphere(2, 5.0, 0.05, 3));
  for (const Index h : HalfEdges(bench.Mesh))
  {
    const EdgeNeighborhood around = bench.Around(h);
    const PositionCandidates proposals = PlaneQuadricPositions(bench.Mesh, bench.Areas, around);
    const Vector3 middle =
      0.5 * (bench.Mesh.Position(around.Start) + bench.Mesh.Position(around.End));
    const double best = bench.SumOfSquares(around, proposals.Edits[0].Position, middle);
    Random random(static_cast<std::uint64_t>(h));
    for (int i = 0; i < 50; ++i)
    {
      const Vector3 other = proposals.Edits[0].Position + random.InCube(0.1);
      EXPECT_LE(best, bench.SumOfSquares(around, other, middle)) << "edge " << h;
    }
    for (std::size_t i = 0; i < proposals.Count; ++i)
    {
      EXPECT_LE(best, bench.SumOfSquares(around, proposals.Edits[i].Position, middle))
        << "edge " << h;
    }
  }
}

TEST(PlaneQuadric, FromInsideToBoundaryOnlyTheBoundaryVertexIsProposed)
{
  Bench bench(HeightField(4, 0.3, 1));
  for (const Index h : HalfEdges(bench.Mesh))
  {
    const Index from = bench.Mesh.Origin(h);
    const Index to = bench.Mesh.Target(h);
    if (bench.Mesh.Constraint(from) == bench.Mesh.Constraint(to))
    {
      continue;
    }
    const Index boundary = bench.Mesh.Constraint(from) == VertexConstraint::Boundary ? from : to;
    const PositionCandidates proposals = bench.Propose(h);
    ASSERT_EQ(proposals.Count, 1U);
    EXPECT_EQ(proposals.Edits[0].Keep, boundary);
    EXPECT_EQ(proposals.Edits[0].Position, bench.Mesh.Position(boundary));
    EXPECT_TRUE(proposals.Edits[0].KeepStays);
  }
}

TEST(PlaneQuadric, ABoundaryEdgeProposesOnlyPositionsOnItself)
{
  Bench bench(HeightField(6, 0.5, 2));
  for (const Index h : HalfEdges(bench.Mesh))
  {
    if (bench.Mesh.Twin(h) != None)
    {
      continue;
    }
    const Vector3& a = bench.Mesh.Position(bench.Mesh.Origin(h));
    const Vector3& b = bench.Mesh.Position(bench.Mesh.Target(h));
    const PositionCandidates proposals = bench.Propose(h);
    ASSERT_GT(proposals.Count, 0U);
    for (std::size_t i = 0; i < proposals.Count; ++i)
    {
      EXPECT_LT(PointTriangleDistance(proposals.Edits[i].Position, a, b, a), 1e-14);
    }
  }
}

TEST(PlaneQuadric, AtACornerOfAFlatBoundaryTheCornerIsKept)
{
  Bench bench(Grid(4));
  EXPECT_EQ(bench.Propose(Vector3(0, 0, 0), Vector3(1, 0, 0)).Edits[0].Position, Vector3(0, 0, 0));
  EXPECT_EQ(bench.Propose(Vector3(4, 4, 0), Vector3(3, 4, 0)).Edits[0].Position, Vector3(4, 4, 0));
}

namespace
{
/// The validity of the position, and the change of volume, mm^3.
std::pair<Rejection, double> CheckAt(
  const Bench& bench, const EdgeNeighborhood& around, const Vector3& position)
{
  FanStorage storage;
  Fan& fan = storage.Reserve(static_cast<int>(around.Corners.size()));
  FillFan(bench.Mesh, around, fan);
  SurfaceChange change;
  change.Requested = { around.Edge, around.Start, position, false };
  const Rejection rejection = CheckPosition(bench.Mesh, around, fan, change);
  return { rejection, change.VolumeChange };
}
}

TEST(EditValidity, RejectsAPositionThatTurnsATriangleOver)
{
  Bench bench(Grid(5));
  const EdgeNeighborhood around = bench.Around(bench.EdgeBetween({ 2, 2, 0 }, { 3, 2, 0 }));
  const auto check = [&](const Vector3& position)
  { return CheckAt(bench, around, position).first; };
  EXPECT_EQ(check({ 2.5, 2, 0 }), Rejection::NotRejected);
  EXPECT_EQ(check({ 9, 2, 0 }), Rejection::Flip);
  EXPECT_EQ(check({ 2.5, 2, 30 }), Rejection::Flip) << "all triangles upright";
}

TEST(EditValidity, RejectsAPositionThatLeavesNoArea)
{
  Bench bench(Grid(5));
  const EdgeNeighborhood around = bench.Around(bench.EdgeBetween({ 2, 2, 0 }, { 3, 2, 0 }));
  // On the line of an edge of the ring.
  EXPECT_NE(CheckAt(bench, around, { 2.5, 3, 0 }).first, Rejection::NotRejected);
}

TEST(EditValidity, VolumeChangeIsTheDifferenceOfTheVolumes)
{
  const Surface surface = BumpySphere(2, 5.0, 0.1, 9);
  Random random(10);
  for (int i = 0; i < 200; ++i)
  {
    Bench bench(surface);
    const Index h =
      HalfEdgeMesh::HalfEdge(random.Below(bench.Mesh.NumberOfFaceSlots()), random.Below(3));
    const EdgeNeighborhood around = bench.Around(h);
    const Vector3 position = bench.Mesh.Position(around.Start) + random.InCube(1);
    Surface after = surface;
    for (Triangle& t : after.Triangles)
    {
      for (Index& corner : t)
      {
        corner = corner == around.End ? static_cast<Index>(around.Start) : corner;
      }
    }
    after.Points[around.Start] = position; // triangles with a repeated corner have no volume
    const double change = CheckAt(bench, around, position).second;
    EXPECT_NEAR(change, SignedVolume(after) - SignedVolume(surface), 1e-10);
  }
}
