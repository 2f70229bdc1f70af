// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BruteForce.h"
#include "Decimate/Edit/Editor.h"
#include "EditAlone.h"
#include "Random.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// The collapse on a plain list of triangles: `gone` becomes `keep`, triangles with a repeated
/// corner go.
Surface Collapsed(const Surface& surface, Index keep, Index gone)
{
  Surface result = { surface.Points, {} };
  for (Triangle t : surface.Triangles)
  {
    std::replace(t.begin(), t.end(), gone, keep);
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
    {
      result.Triangles.push_back(t);
    }
  }
  return result;
}

/// Whether the collapse leaves a surface of the same kind: one point less, nothing lost, closed,
/// pinched or doubled.
bool KeepsTopology(const Surface& before, const Surface& after)
{
  const Topology a = CountTopology(before);
  const Topology b = CountTopology(after);
  return a.Points == b.Points + 1 && a.EulerNumber == b.EulerNumber &&
    a.Components == b.Components && a.NonManifoldEdges == b.NonManifoldEdges &&
    a.InconsistentEdges == b.InconsistentEdges && a.NonManifoldPoints == b.NonManifoldPoints &&
    (a.BoundaryEdges == 0) == (b.BoundaryEdges == 0) &&
    RepeatedTriangles(before) == RepeatedTriangles(after);
}

std::string Describe(const Surface& surface, Index from, Index to)
{
  std::string text = "edge " + std::to_string(from) + "-" + std::to_string(to) + " of";
  for (const Triangle& t : surface.Triangles)
  {
    text +=
      " (" + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + ")";
  }
  return surface.Triangles.size() <= 24 ? text : text.substr(0, text.find(" of"));
}

/// Compares the validity of every half-edge with the collapse on the list.
void CompareAllEdges(const Surface& input)
{
  const CleanSurface clean = Clean(input, true);
  const Surface& surface = clean.Surface;
  Editor editor(clean, EditorSettings());
  const HalfEdgeMesh& mesh = editor.Mesh();
  for (const Index h : HalfEdges(mesh))
  {
    const Index from = mesh.Origin(h);
    const Index to = mesh.Target(h);
    const Rejection rejection = GatherAlone(editor, h).Reason();
    if (mesh.Constraint(from) == VertexConstraint::NonManifold ||
      mesh.Constraint(to) == VertexConstraint::NonManifold)
    {
      EXPECT_EQ(rejection, Rejection::NonManifold) << Describe(surface, from, to);
      continue;
    }
    const bool expected = KeepsTopology(surface, Collapsed(surface, from, to));
    EXPECT_EQ(rejection == Rejection::NotRejected, expected) << Describe(surface, from, to);
  }
}

/// The surface with faces taken out at random, so that boundaries, ears and triangular holes
/// appear.
Surface WithHoles(const Surface& surface, Index holes, std::uint64_t seed)
{
  Surface holed = surface;
  Random random(seed);
  for (Index i = 0; i < holes; ++i)
  {
    const Index face = random.Below(static_cast<Index>(holed.Triangles.size()));
    holed.Triangles.erase(holed.Triangles.begin() + face);
  }
  return holed;
}

/// An octahedron whose upper cap is a ring of three: an edge between two vertices with three common
/// neighbors.
Surface Bipyramid(Index around)
{
  Surface solid;
  solid.Points = { { 0, 0, 1 }, { 0, 0, -1 } };
  for (Index i = 0; i < around; ++i)
  {
    const double u = 6.283185307179586 * i / around;
    solid.Points.emplace_back(std::cos(u), std::sin(u), 0.0);
  }
  for (Index i = 0; i < around; ++i)
  {
    const Index a = 2 + i;
    const Index b = 2 + (i + 1) % around;
    solid.Triangles.push_back({ 0, a, b });
    solid.Triangles.push_back({ 1, b, a });
  }
  return solid;
}
}

class LinkCondition : public EachShape
{
};

TEST_P(LinkCondition, VsCollapseOnAPlainTriangleList)
{
  CompareAllEdges(GetParam().Surface);
}

INSTANTIATE_TEST_SUITE_P(Shapes, LinkCondition,
  testing::Values(NamedSurface{ "Tetrahedron", Tetrahedron() }, NamedSurface{ "Cube", Cube(2) },
    NamedSurface{ "Icosahedron", Icosphere(0, 1.0) },
    NamedSurface{ "Icosphere", Icosphere(1, 1.0) }, NamedSurface{ "ThinTorus", Torus(3, 3) },
    NamedSurface{ "Torus", Torus(5, 4) }, NamedSurface{ "Bipyramid3", Bipyramid(3) },
    NamedSurface{ "Bipyramid4", Bipyramid(4) }, NamedSurface{ "Bipyramid5", Bipyramid(5) },
    NamedSurface{ "Needles", Needles(6) }, NamedSurface{ "Envelope", Envelope() },
    NamedSurface{ "SingleTriangle", SingleTriangle() }, NamedSurface{ "Square", Grid(1) },
    NamedSurface{ "Grid", Grid(3) }, NamedSurface{ "HoledPlate", HoledPlate(3) },
    NamedSurface{ "ThinCylinder", OpenCylinder(3, 2) },
    NamedSurface{ "ShortCylinder", OpenCylinder(4, 1) }, NamedSurface{ "Annulus", Annulus(6, 2) },
    NamedSurface{ "PinchedVertex", PinchedVertex(4, 3) },
    NamedSurface{ "PinchedSolids", PinchedSolids(3) },
    NamedSurface{ "TetrahedronChain", TetrahedronChain(3) },
    NamedSurface{ "Book", ThreeLeavedBook(3) }, NamedSurface{ "MoebiusStrip", MoebiusStrip(9, 3) },
    NamedSurface{ "InconsistentGrid", InconsistentGrid(4) },
    NamedSurface{ "Duplicates", DuplicateTriangles(1, 4) },
    NamedSurface{ "SparseSoup", RandomSoup(60, 20, 5) },
    NamedSurface{ "DenseSoup", RandomSoup(12, 30, 6) }),
  NameOf);

TEST(LinkConditionRandom, VsCollapseOnAPlainTriangleListWithHolesAndSoups)
{
  for (std::uint64_t seed = 0; seed < 60; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    CompareAllEdges(WithHoles(Icosphere(1, 1.0), 1 + static_cast<Index>(seed % 30), seed));
    CompareAllEdges(WithHoles(Torus(4, 4), 1 + static_cast<Index>(seed % 12), seed));
    CompareAllEdges(RandomSoup(10, 6 + static_cast<Index>(seed % 20), seed));
  }
}

TEST(EditValidity, TheTableOfEndsHolds)
{
  // A grid of 3 x 3 cells: point 5 is inside, 6 too; 1 and 4 are on the boundary, the edge 1-4 is
  // not.
  const CleanSurface clean = Clean(Grid(3), true);
  Editor editor(clean, EditorSettings());
  const HalfEdgeMesh& mesh = editor.Mesh();
  const auto edge = [&](Index from, Index to)
  {
    for (const Index h : HalfEdges(mesh))
    {
      if (mesh.Origin(h) == from && mesh.Target(h) == to)
      {
        return h;
      }
    }
    return None;
  };
  EXPECT_EQ(GatherAlone(editor, edge(5, 6)), Rejection::NotRejected);
  EXPECT_EQ(GatherAlone(editor, edge(5, 9)), Rejection::NotRejected);
  EXPECT_EQ(GatherAlone(editor, edge(1, 2)), Rejection::NotRejected);
  EXPECT_EQ(GatherAlone(editor, edge(5, 1)), Rejection::NotRejected);
  EXPECT_EQ(GatherAlone(editor, edge(2, 7)), Rejection::Boundary)
    << "it would pinch the corner off";
}

TEST(EditValidity, RejectsCollapsesOfTheLeastFragments)
{
  for (const Surface& surface : { Tetrahedron(), Envelope(), SingleTriangle() })
  {
    const CleanSurface cleaned = Clean(surface, true);
    Editor editor(cleaned, EditorSettings());
    for (const Index h : HalfEdges(editor.Mesh()))
    {
      EXPECT_EQ(GatherAlone(editor, h), Rejection::Fragment);
    }
  }
}

TEST(EditValidity, TheLinkConditionRejectsAnEdgeAroundATunnel)
{
  const CleanSurface cleaned = Clean(Torus(3, 12), true);
  Editor editor(cleaned, EditorSettings());
  std::int64_t rejected = 0;
  for (const Index h : HalfEdges(editor.Mesh()))
  {
    rejected += GatherAlone(editor, h) == Rejection::LinkCondition ? 1 : 0;
  }
  EXPECT_GT(rejected, 0);
}
