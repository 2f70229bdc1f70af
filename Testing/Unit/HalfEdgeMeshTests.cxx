// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BruteForce.h"
#include "Mesh/Cleaning.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Mesh/Invariants.h"
#include "Runs.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
Index CountKind(const HalfEdgeMesh& mesh, VertexConstraint kind)
{
  Index count = 0;
  for (Index v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    count += mesh.Constraint(v) == kind ? 1 : 0;
  }
  return count;
}

/// Points on edges of three or more triangles or of two that run the same way, or whose triangles
/// are not one fan.
std::set<Index> PointsToLock(const Surface& surface)
{
  std::map<std::pair<Index, Index>, std::vector<bool>> edges;
  std::map<Index, Surface> fans;
  for (const Triangle& t : surface.Triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Index a = t[i];
      const Index b = t[(i + 1) % 3];
      edges[std::minmax(a, b)].push_back(a < b);
      fans[a].Triangles.push_back(t);
    }
  }
  std::set<Index> constrained;
  for (const auto& [ends, directions] : edges)
  {
    if (directions.size() > 2 || (directions.size() == 2 && directions[0] == directions[1]))
    {
      constrained.insert({ ends.first, ends.second });
    }
  }
  for (auto& [point, fan] : fans)
  {
    // Without the point itself, the triangles around it are edges; one fan is one connected path or
    // cycle.
    Surface rest = { surface.Points, fan.Triangles };
    for (Triangle& t : rest.Triangles)
    {
      std::replace(t.begin(), t.end(), point, t[0] == point ? t[1] : t[0]);
    }
    if (CountTopology(rest).Components > 1)
    {
      constrained.insert(point);
    }
  }
  return constrained;
}
}

TEST(HalfEdgeMesh, InvariantsHoldOnAllShapes)
{
  for (const NamedSurface& shape : AllShapes())
  {
    SCOPED_TRACE(shape.Name);
    const HalfEdgeMesh mesh(Clean(shape.Surface, true).Surface);
    EXPECT_EQ(BrokenInvariant(mesh), "");
    EXPECT_EQ(mesh.NumberOfFaces(), static_cast<Index>(shape.Surface.Triangles.size()));
  }
}

TEST(HalfEdgeMesh, ConstrainsExactlyTheNonManifoldVertices)
{
  for (const NamedSurface& shape : AllShapes())
  {
    SCOPED_TRACE(shape.Name);
    const Surface surface = Clean(shape.Surface, true).Surface;
    const HalfEdgeMesh mesh(surface);
    const std::set<Index> expected = PointsToLock(surface);
    std::set<Index> found;
    for (Index v = 0; v < mesh.NumberOfVertexSlots(); ++v)
    {
      if (mesh.Constraint(v) == VertexConstraint::NonManifold)
      {
        found.insert(v);
      }
    }
    EXPECT_EQ(found, expected);
  }
}

TEST(HalfEdgeMesh, ClosedShapesHaveNoBoundaryAndNoConstraints)
{
  for (const NamedSurface& shape : ClosedShapes())
  {
    const HalfEdgeMesh mesh(shape.Surface);
    EXPECT_EQ(CountKind(mesh, VertexConstraint::Free), mesh.NumberOfVertexSlots()) << shape.Name;
  }
}

TEST(HalfEdgeMesh, BoundaryVerticesAreThoseOfBoundaryEdges)
{
  for (const NamedSurface& shape : OpenShapes())
  {
    SCOPED_TRACE(shape.Name);
    const Surface surface = Clean(shape.Surface, true).Surface;
    const HalfEdgeMesh mesh(surface);
    std::set<Index> boundary;
    for (const auto& [from, to] : BoundaryEdges(surface))
    {
      boundary.insert({ from, to });
    }
    for (Index v = 0; v < mesh.NumberOfVertexSlots(); ++v)
    {
      EXPECT_EQ(mesh.Constraint(v) == VertexConstraint::Boundary, boundary.count(v) == 1) << v;
    }
  }
}

TEST(HalfEdgeMesh, RingsVisitEveryFaceAndEveryNeighborOnce)
{
  for (const NamedSurface& shape : AllShapes())
  {
    SCOPED_TRACE(shape.Name);
    const Surface surface = Clean(shape.Surface, true).Surface;
    const HalfEdgeMesh mesh(surface);
    std::map<Index, std::multiset<Index>> faces;
    std::map<Index, std::set<Index>> neighbors;
    for (std::size_t i = 0; i < surface.Triangles.size(); ++i)
    {
      for (const Index a : surface.Triangles[i])
      {
        faces[a].insert(static_cast<Index>(i));
        neighbors[a].insert(surface.Triangles[i].begin(), surface.Triangles[i].end());
      }
    }
    for (Index v = 0; v < mesh.NumberOfVertexSlots(); ++v)
    {
      if (mesh.Constraint(v) == VertexConstraint::NonManifold)
      {
        continue;
      }
      std::multiset<Index> foundFaces;
      for (const Index h : mesh.OutgoingOf(v))
      {
        EXPECT_EQ(mesh.Origin(h), v);
        foundFaces.insert(HalfEdgeMesh::Face(h));
      }
      std::multiset<Index> foundNeighbors = { v };
      mesh.VisitEdges(v, [&](Index h) { foundNeighbors.insert(mesh.OtherEnd(h, v)); });
      EXPECT_EQ(foundFaces, faces[v]) << v;
      EXPECT_EQ(foundNeighbors, std::multiset<Index>(neighbors[v].begin(), neighbors[v].end()))
        << v;
    }
  }
}

TEST(HalfEdgeMesh, RingsRunCounterClockwise)
{
  const HalfEdgeMesh mesh(Grid(4));
  const Index middle = 12;
  std::vector<Vector3> around;
  for (const Index h : mesh.OutgoingOf(middle))
  {
    around.push_back(mesh.Position(mesh.Target(h)) - mesh.Position(middle));
  }
  ASSERT_EQ(around.size(), 6U);
  for (std::size_t i = 0; i < around.size(); ++i)
  {
    EXPECT_GT(around[i].cross(around[(i + 1) % around.size()]).z(), 0.0);
  }
}

TEST(HalfEdgeMesh, NextAndPreviousStayInTheFace)
{
  const HalfEdgeMesh mesh(Grid(2));
  for (const Index h : HalfEdges(mesh))
  {
    EXPECT_EQ(HalfEdgeMesh::Face(HalfEdgeMesh::Next(h)), HalfEdgeMesh::Face(h));
    EXPECT_EQ(HalfEdgeMesh::Previous(HalfEdgeMesh::Next(h)), h);
    EXPECT_EQ(HalfEdgeMesh::Next(HalfEdgeMesh::Next(h)), HalfEdgeMesh::Previous(h));
  }
}
