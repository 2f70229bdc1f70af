// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Which components lie within which others: nested and separate shapes, among them shapes whose
// faces lie along the axes.
#include "Mesh/HalfEdgeMesh.h"
#include "Mesh/Statistics.h"
#include "Proof/Guard/Containment.h"
#include "Shapes.h"

#include <gtest/gtest.h>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
std::vector<std::vector<Index>> EnclosingOf(const Surface& surface)
{
  const Components components = FindComponents(surface);
  return FindEnclosing(
    HalfEdgeMesh(surface), components.Count,
    [&](VertexId v) { return components.OfPoint[static_cast<std::size_t>(v)]; }, nullptr, 1);
}

using Lists = std::vector<std::vector<Index>>;
}

TEST(Containment, NestedComponentsAreEnclosedByAllThatAreAroundThem)
{
  const Surface balls =
    Together(Together(Icosphere(2, 10.0), TurnedInsideOut(Icosphere(2, 8.0))), Icosphere(1, 1.0));
  EXPECT_EQ(EnclosingOf(balls), (Lists{ {}, { 0 }, { 0, 1 } }));
}

TEST(Containment, ComponentsBesideEachOtherAreEnclosedByNone)
{
  const Surface cubes = Together(Cube(4), Moved(Cube(4), Vector3(1.5, 0.0, 0.0)));
  EXPECT_EQ(EnclosingOf(cubes), (Lists{ {}, {} }));
  EXPECT_EQ(EnclosingOf(Cube(4)), (Lists{ {} }));
}

TEST(Containment, RaysAlongEdgesDecideToo)
{
  // The inner cube's vertices lie in planes of edges of the outer one.
  const Surface inner = Moved(Scaled(Cube(2), 0.5), Vector3(0.25, 0.25, 0.25));
  EXPECT_EQ(EnclosingOf(Together(inner, Cube(4))), (Lists{ { 1 }, {} }));
}

TEST(Containment, ATinyComponentBelowATipIsOnItsSide)
{
  Surface tip = Icosphere(2, 10.0);
  const Vector3 top = tip.Points[0];
  tip.Points[0] *= 1.5;
  const Surface speck = Scaled(Tetrahedron(), 0.01);
  EXPECT_EQ(EnclosingOf(Together(tip, Moved(speck, 1.3 * top))), (Lists{ {}, { 0 } }));
  EXPECT_EQ(EnclosingOf(Together(tip, Moved(speck, 1.6 * top))), (Lists{ {}, {} }));
}
