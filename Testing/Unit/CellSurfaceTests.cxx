// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Surfaces of cells: neighboring cells fit together, each label has a manifold surface, no edge
// crosses a face of the cell.
#include "Labels/LabelMap/CellSurface.h"
#include "Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
using Position = std::array<long, 3>; // in units of 1e-9 voxels
using DirectedEdge = std::pair<Position, Position>;
using LabelEdge = std::tuple<Index, Position, Position>;

Position Rounded(const Vector3& x)
{
  return { std::lround(1e9 * x[0]), std::lround(1e9 * x[1]), std::lround(1e9 * x[2]) };
}

/// The directed edges of the surface of each label.
std::map<Index, std::multiset<std::pair<int, int>>> EdgesOfLabels(const CellSurface& surface)
{
  std::map<Index, std::multiset<std::pair<int, int>>> edges;
  for (const CellTriangle& triangle : surface)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const int a = triangle.Points[k];
      const int b = triangle.Points[(k + 1) % 3];
      edges[triangle.From].insert({ a, b });
      edges[triangle.To].insert({ b, a });
    }
  }
  return edges;
}

/// Whether the points lie on one side of the unit cube.
bool OnASide(const Vector3& a, const Vector3& b)
{
  for (Index axis = 0; axis < 3; ++axis)
  {
    if (a[axis] == b[axis] && (a[axis] == 0.0 || a[axis] == 1.0))
    {
      return true;
    }
  }
  return false;
}

void ExpectManifoldLabels(const CellSurface& surface)
{
  for (const auto& [label, edges] : EdgesOfLabels(surface))
  {
    for (const auto& edge : edges)
    {
      ASSERT_EQ(edges.count(edge), 1U) << "label " << label;
      const bool isInside = edges.count({ edge.second, edge.first }) == 1;
      const bool onASide = OnASide(surface.Position(edge.first), surface.Position(edge.second));
      ASSERT_NE(isInside, onASide) << "edges lie on a face where the surface ends, and only there";
    }
  }
}

/// Edges of one triangle of a label on a side of the cell, moved by the offset of the cell;
/// reversed on request.
std::set<LabelEdge> EdgesOnSide(const CellSurface& surface, Index axis, double side, bool reverse)
{
  std::set<LabelEdge> result;
  for (const auto& [label, edges] : EdgesOfLabels(surface))
  {
    for (const auto& [first, second] : edges)
    {
      Vector3 a = surface.Position(first);
      Vector3 b = surface.Position(second);
      if (a[axis] == side && b[axis] == side)
      {
        a[axis] = b[axis] = 0.0;
        result.insert({ label, Rounded(reverse ? b : a), Rounded(reverse ? a : b) });
      }
    }
  }
  return result;
}

CellLabels RandomLabels(Random& random, int labels)
{
  CellLabels result = {};
  for (Index& label : result)
  {
    label = random.Below(labels);
  }
  return result;
}

/// A neighbor along the axis: it has the upper labels of the cell below.
CellLabels NeighborOf(const CellLabels& labels, unsigned int axis, Random& random, int count)
{
  CellLabels result = RandomLabels(random, count);
  for (unsigned int corner = 0; corner < 8; ++corner)
  {
    if ((corner >> axis & 1U) == 0)
    {
      result[corner] = labels[corner | 1U << axis];
    }
  }
  return result;
}
}

class RandomCells : public testing::TestWithParam<int>
{
};

TEST_P(RandomCells, HaveManifoldLabelsAndNoEdgeAcrossAFace)
{
  Random random(7);
  CellSurface surface;
  for (int cell = 0; cell < 25000 && !HasFailure(); ++cell)
  {
    BuildCellSurface(RandomLabels(random, GetParam()), surface);
    ExpectManifoldLabels(surface);
  }
}

TEST_P(RandomCells, FitTheirNeighbors)
{
  Random random(8);
  CellSurface first;
  CellSurface second;
  for (int cell = 0; cell < 6000 && !HasFailure(); ++cell)
  {
    const CellLabels labels = RandomLabels(random, GetParam());
    const auto axis = static_cast<unsigned int>(cell % 3);
    BuildCellSurface(labels, first);
    BuildCellSurface(NeighborOf(labels, axis, random, GetParam()), second);
    EXPECT_EQ(EdgesOnSide(first, static_cast<Index>(axis), 1.0, false),
      EdgesOnSide(second, static_cast<Index>(axis), 0.0, true));
  }
}

/// Every edge of the cell with different ends has a point, no other edge has.
TEST_P(RandomCells, HaveAPointOnEachEdgeWithDifferentEnds)
{
  Random random(9);
  CellSurface surface;
  for (int cell = 0; cell < 5000 && !HasFailure(); ++cell)
  {
    const CellLabels labels = RandomLabels(random, GetParam());
    BuildCellSurface(labels, surface);
    std::set<int> used;
    for (const CellTriangle& triangle : surface)
    {
      used.insert(triangle.Points.begin(), triangle.Points.end());
    }
    for (int edge = 0; edge < NumberOfCellEdges; ++edge)
    {
      const auto& [a, b] = EdgeCorners[static_cast<std::size_t>(edge)];
      EXPECT_EQ(used.count(edge) == 1,
        labels[static_cast<std::size_t>(a)] != labels[static_cast<std::size_t>(b)]);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
  Labels, RandomCells, testing::Values(2, 3, 4, 8), testing::PrintToStringParamName());

TEST(TwoLabelCells, HaveManifoldLabelsAndNoEdgeAcrossAFace)
{
  for (const CellSurface& surface : TwoLabelSurfaces())
  {
    ExpectManifoldLabels(surface);
    EXPECT_EQ(surface.NumberOfInnerPoints(), 0U);
  }
}

TEST(TwoLabelCells, SeparateEachCornerFromTheOthers)
{
  for (unsigned int corner = 0; corner < 8; ++corner)
  {
    EXPECT_EQ(TwoLabelSurfaces()[1U << corner].NumberOfTriangles(), 1U);
    EXPECT_EQ(TwoLabelSurfaces()[255U - (1U << corner)].NumberOfTriangles(), 1U);
  }
}

/// The larger label is cut off where two labels alternate around a face, so the smaller one stays
/// connected.
TEST(TwoLabelCells, KeepTheSmallerLabelConnected)
{
  const CellSurface& oneFace = TwoLabelSurfaces()[0b00001001];
  EXPECT_EQ(oneFace.NumberOfTriangles(), 2U) << "a triangle at each of the two corners";
  const CellSurface& allFaces = TwoLabelSurfaces()[0b01101001];
  EXPECT_EQ(allFaces.NumberOfTriangles(), 4U);
}

TEST(TwoLabelCells, HaveTheNormalFromTheSmallerToTheLargerLabel)
{
  for (unsigned int corner = 0; corner < 8; ++corner)
  {
    const CellSurface& surface = TwoLabelSurfaces()[1U << corner];
    const CellTriangle& triangle = *surface.begin();
    const Vector3& a = surface.Position(triangle.Points[0]);
    const Vector3& b = surface.Position(triangle.Points[1]);
    const Vector3& c = surface.Position(triangle.Points[2]);
    EXPECT_EQ(triangle.From, 0);
    EXPECT_EQ(triangle.To, 1);
    EXPECT_GT((b - a).cross(c - a).dot(CellCorner(static_cast<int>(corner)) - a), 0.0);
  }
}

TEST(ThreeLabelCells, MeetAtPointsOnFaces)
{
  // Half of the cell has label 1, a quarter each 2 and 3: three walls along a line between two
  // faces.
  CellSurface surface;
  BuildCellSurface({ 1, 1, 1, 1, 2, 3, 2, 3 }, surface);
  EXPECT_EQ(surface.NumberOfInnerPoints(), 0U);
  std::set<int> facePoints;
  for (const CellTriangle& triangle : surface)
  {
    for (const int point : triangle.Points)
    {
      if (point >= FirstFacePoint)
      {
        facePoints.insert(point);
      }
    }
  }
  EXPECT_EQ(facePoints, (std::set<int>{ FirstFacePoint + 2, FirstFacePoint + 3 }));
  EXPECT_TRUE(surface.Position(FirstFacePoint + 2).isApprox(Vector3(0.5, 0.0, 2.0 / 3.0), 1e-12));
}

TEST(EightLabelCells, MeetAtTheCenter)
{
  CellSurface surface;
  BuildCellSurface({ 0, 1, 2, 3, 4, 5, 6, 7 }, surface);
  EXPECT_EQ(surface.NumberOfInnerPoints(), 1U);
  EXPECT_EQ(surface.NumberOfTriangles(), 24U);
  EXPECT_TRUE(surface.Position(FirstInnerPoint).isApprox(Vector3::Constant(0.5), 1e-12));
}
