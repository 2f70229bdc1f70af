// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Decimate/Cost/NormalFieldDeviation.h"
#include "Mesh/MeanEdgeLength.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// Two triangles of 1 mm2 each on an edge of 2 mm; the second one's apex lies where it is told.
Surface Hinge(const Vector3& apex)
{
  return { { { 0, 0, 0 }, { 2, 0, 0 }, { 1, 1, 0 }, apex }, { { 0, 1, 2 }, { 1, 0, 3 } } };
}

/// Cost of half-edge 0, the hinge's edge.
double HingeCost(const Vector3& apex, double tolerance)
{
  const HalfEdgeMesh mesh(Hinge(apex));
  const FaceAreas areas(mesh);
  return NormalFieldDeviation(mesh, areas, tolerance, MeanEdgeLength(mesh)).OfEdge(0);
}

double CostOfVertex(const Surface& surface, Index vertex, double tolerance)
{
  const HalfEdgeMesh mesh(surface);
  const FaceAreas areas(mesh);
  return NormalFieldDeviation(mesh, areas, tolerance, MeanEdgeLength(mesh)).OfVertex(vertex);
}
}

TEST(NormalFieldDeviation, EdgeCostsAreThoseComputedByHand)
{
  // (1 + 1) (1 - w n1.n2) 2
  EXPECT_NEAR(HingeCost({ 1, -1, 0 }, 0.95), 0.2, 1e-15);
  EXPECT_NEAR(HingeCost({ 1, 0, -1 }, 0.95), 4.0, 1e-15);
  EXPECT_NEAR(HingeCost({ 1, 1, 0 }, 0.95), 7.8, 1e-15);
}

TEST(NormalFieldDeviation, AFlatEdgeCostsNothingAtToleranceOneAndMoreTheSmallerItIs)
{
  const Vector3 flat(1, -1, 0);
  EXPECT_EQ(HingeCost(flat, 1.0), 0.0);
  EXPECT_LT(HingeCost(flat, 0.95), HingeCost(flat, 0.5));
  EXPECT_LT(HingeCost(flat, 0.5), HingeCost(flat, 0.0));
  EXPECT_NEAR(HingeCost(flat, 0.0), 4.0, 1e-15);
}

TEST(NormalFieldDeviation, CostOfAFoldedEdgeIncreasesWithTheTolerance)
{
  const Vector3 folded(1, 0.8, 0.6);
  EXPECT_LT(HingeCost(folded, 0.0), HingeCost(folded, 1.0));
}

TEST(NormalFieldDeviation, BothHalvesOfAnEdgeCostTheSame)
{
  const HalfEdgeMesh mesh(BumpySphere(2, 3.0, 0.2, 5));
  const FaceAreas areas(mesh);
  const NormalFieldDeviation costs(mesh, areas, 0.9, MeanEdgeLength(mesh));
  for (const Index h : HalfEdges(mesh))
  {
    EXPECT_DOUBLE_EQ(costs.OfEdge(h), costs.OfEdge(mesh.Twin(h)));
  }
}

TEST(NormalFieldDeviation, ABoundaryEdgeHasATwinOfTheSameAreaAtRightAngles)
{
  const HalfEdgeMesh mesh(SingleTriangle());
  const FaceAreas areas(mesh);
  for (const double tolerance : { 0.0, 0.95, 1.0 })
  {
    const NormalFieldDeviation costs(mesh, areas, tolerance, MeanEdgeLength(mesh));
    EXPECT_NEAR(costs.OfEdge(0), 2.0 * 0.5 * 1.0, 1e-15);
    EXPECT_NEAR(costs.OfEdge(1), 2.0 * 0.5 * std::sqrt(2.0), 1e-15);
  }
}

TEST(NormalFieldDeviation, MeanEdgeLengthCountsEachEdgeOnce)
{
  EXPECT_NEAR(
    MeanEdgeLength(HalfEdgeMesh(Tetrahedron())), (3.0 + 3.0 * std::sqrt(2.0)) / 6.0, 1e-15);
  EXPECT_NEAR(MeanEdgeLength(HalfEdgeMesh(SingleTriangle())), (2.0 + std::sqrt(2.0)) / 3.0, 1e-15);
  EXPECT_NEAR(MeanEdgeLength(HalfEdgeMesh(Grid(1))), (4.0 + std::sqrt(2.0)) / 5.0, 1e-15);
}

TEST(NormalFieldDeviation, VertexCostOfARightAngledCornerIsThatComputedByHand)
{
  // Three edges of 1 mm between faces of 0.5 mm2 at right angles: 1 mm3 each whatever w.
  const double mean = (3.0 + 3.0 * std::sqrt(2.0)) / 6.0;
  const double expected = 3.0 + mean * (1.5 - 0.5 * std::sqrt(3.0));
  EXPECT_NEAR(CostOfVertex(Tetrahedron(), 0, 0.95), expected, 1e-14);
  EXPECT_NEAR(CostOfVertex(Tetrahedron(), 0, 0.3), expected, 1e-14);
}

TEST(NormalFieldDeviation, AFlatRingHasNoCurvature)
{
  // Point 12 of the grid: six edges, each between faces of 0.5 mm2, two of them diagonals.
  const double edges = 0.05 * (4.0 + 2.0 * std::sqrt(2.0));
  EXPECT_NEAR(CostOfVertex(Grid(4), 12, 0.95), edges, 1e-14);
  EXPECT_NEAR(CostOfVertex(Grid(4), 12, 1.0), 0.0, 1e-14);
}

TEST(NormalFieldDeviation, ABoundaryVertexCountsItsBoundaryEdges)
{
  // Point 1 of the grid of one cell: corner of one triangle with two boundary edges of 1 mm.
  EXPECT_NEAR(CostOfVertex(Grid(1), 1, 0.95), 2.0, 1e-15);
}

TEST(NormalFieldDeviation, CostsGrowWithTheCubeOfTheScaleExactly)
{
  const Surface surface = BumpySphere(2, 3.0, 0.2, 5);
  for (Index v = 0; v < static_cast<Index>(surface.Points.size()); ++v)
  {
    EXPECT_EQ(CostOfVertex(Scaled(surface, 4.0), v, 0.95), 64.0 * CostOfVertex(surface, v, 0.95))
      << v;
  }
}

TEST(NormalFieldDeviation, FacesWithoutAreaCostNothingAndGiveNoNaN)
{
  const Surface surface = { { { 0, 0, 0 }, { 2, 0, 0 }, { 1, 0, 0 }, { 1, 2, 0 }, { 1, -2, 0 } },
    { { 0, 2, 3 }, { 2, 1, 3 }, { 1, 0, 4 }, { 0, 1, 2 } } };
  for (Index v = 0; v < 5; ++v)
  {
    EXPECT_TRUE(std::isfinite(CostOfVertex(surface, v, 0.95))) << v;
  }
}
