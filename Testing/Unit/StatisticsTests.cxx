// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BruteForce.h"
#include "Mesh/Statistics.h"
#include "Shapes.h"

#include <gtest/gtest.h>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

TEST(Statistics, CountsAgreeWithBruteForceOnAllShapes)
{
  for (const NamedSurface& shape : AllShapes())
  {
    SCOPED_TRACE(shape.Name);
    const SurfaceStatistics found = Describe(shape.Surface);
    const Topology expected = CountTopology(shape.Surface);
    EXPECT_EQ(found.Faces, expected.Faces);
    EXPECT_EQ(found.Points, expected.Points);
    EXPECT_EQ(found.Components, expected.Components);
    EXPECT_EQ(found.BoundaryEdges, expected.BoundaryEdges);
    EXPECT_EQ(found.NonManifoldEdges, expected.NonManifoldEdges);
    EXPECT_EQ(found.EulerNumber, expected.EulerNumber);
    EXPECT_NEAR(found.Area, TotalArea(shape.Surface), 1e-12 * (1.0 + found.Area));
    EXPECT_NEAR(found.Volume, SignedVolume(shape.Surface), 1e-12 * (1.0 + found.Area * 20.0));
  }
}

TEST(Statistics, EulerNumbersAreThoseOfTheTextbook)
{
  EXPECT_EQ(Describe(Icosphere(2, 1.0)).EulerNumber, 2);
  EXPECT_EQ(Describe(Torus(12, 8)).EulerNumber, 0);
  EXPECT_EQ(Describe(TunnelBlock(6)).EulerNumber, 0);
  EXPECT_EQ(Describe(NestedSpheres(1)).EulerNumber, 4);
  EXPECT_EQ(Describe(Grid(5)).EulerNumber, 1);
  EXPECT_EQ(Describe(OpenCylinder(8, 3)).EulerNumber, 0);
  EXPECT_EQ(Describe(MoebiusStrip(20, 2)).EulerNumber, 0);
}

TEST(Statistics, VolumesAndAreasAreThoseOfTheTextbook)
{
  EXPECT_NEAR(Describe(Tetrahedron()).Volume, 1.0 / 6.0, 1e-15);
  EXPECT_NEAR(Describe(Cube(3)).Volume, 1.0, 1e-12);
  EXPECT_NEAR(Describe(Cube(3)).Area, 6.0, 1e-12);
  EXPECT_NEAR(Describe(TurnedInsideOut(Cube(3))).Volume, -1.0, 1e-12);
  EXPECT_NEAR(Describe(TunnelBlock(6)).Volume, (36 - 4) * 3, 1e-10);
  EXPECT_EQ(Describe(Envelope()).Volume, 0.0);
}

TEST(Statistics, EmptySurfaceHasNothing)
{
  const SurfaceStatistics found = Describe({});
  EXPECT_EQ(found.Faces, 0);
  EXPECT_EQ(found.Components, 0);
  EXPECT_EQ(found.EulerNumber, 0);
  EXPECT_EQ(found.Area, 0.0);
}

TEST(Statistics, ComponentsAreNumberedByTheirLeastPointAndUnusedPointsHaveNone)
{
  Surface surface = Together(Tetrahedron(), SingleTriangle());
  surface.Points.insert(surface.Points.begin(), Vector3(5, 5, 5));
  for (Triangle& t : surface.Triangles)
  {
    t = { t[0] + 1, t[1] + 1, t[2] + 1 };
  }
  std::swap(surface.Triangles.front(), surface.Triangles.back());
  const Components found = FindComponents(surface);
  EXPECT_EQ(found.Count, 2);
  EXPECT_EQ(found.OfPoint, (std::vector<Index>{ None, 0, 0, 0, 0, 1, 1, 1 }));
}
