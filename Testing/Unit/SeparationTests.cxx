// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// How near a surface comes to itself: against the thickness and the gaps of shapes that are known,
// and distances by brute force.
#include "Crossings.h"
#include "EditAlone.h"
#include "GuardedEditor.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Mesh/Statistics.h"
#include "Proof/Certificate/Certificate.h"
#include "Proof/Guard/Separation.h"
#include "Runs.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
/// A box of 12 x 12 x height mm with edges of 1 mm along its sides, one cell high.
Surface Plate(double height)
{
  Surface plate = Scaled(Cube(12), 12.0);
  for (Vector3& p : plate.Points)
  {
    p[2] *= height / 12.0;
  }
  return plate;
}

double EndAlong(int axis, const Surface& surface, bool isMost)
{
  double value = surface.Points[0][axis];
  for (const Vector3& p : surface.Points)
  {
    value = isMost ? std::max(value, p[axis]) : std::min(value, p[axis]);
  }
  return value;
}

std::vector<double> DistancesOf(const Surface& surface, double limit, int threads = 1)
{
  return FindSeparations(HalfEdgeMesh(surface), limit, threads, {}).value();
}
}

TEST(Separation, AreTheThicknessOfAPlateAwayFromItsRim)
{
  const double height = 0.5;
  const Surface plate = Plate(height);
  const double middle = 0.5 * (EndAlong(0, plate, false) + EndAlong(0, plate, true));
  const std::vector<double> distances = DistancesOf(plate, 2.0);
  const std::vector<double> below = DistancesOf(plate, 0.9 * height);
  int found = 0;
  for (std::size_t v = 0; v < plate.Points.size(); ++v)
  {
    const Vector3& p = plate.Points[v];
    const double inPlane = std::max(std::abs(p[0] - middle), std::abs(p[1] - middle)); // mm
    if (inPlane < 2.5)
    {
      EXPECT_NEAR(distances[v], height, 1e-6);
      EXPECT_TRUE(std::isinf(below[v]));
      ++found;
    }
  }
  EXPECT_GT(found, 20);
}

TEST(Separation, AreNotAboveTheDistanceToAnotherComponent)
{
  const Surface spheres = NearSpheres(3, 0.3);
  const std::vector<double> distances = DistancesOf(spheres, 1.0);
  const Components components = FindComponents(spheres);
  ASSERT_EQ(components.Count, 2);
  const double gap = LeastDistanceOfComponents(spheres);
  const double least = *std::min_element(distances.begin(), distances.end());
  EXPECT_LE(least, gap + 1e-6);
  EXPECT_GT(least, 0.9 * gap);
}

TEST(Separation, AreInfiniteWhereTheSurfaceIsOneDiskWithinTheLimit)
{
  for (const Surface& surface : { Icosphere(4, 10.0), HeightField(20, 0.05, 3) })
  {
    const std::vector<double> distances = DistancesOf(surface, 0.5);
    EXPECT_TRUE(std::all_of(
      distances.begin(), distances.end(), [](double distance) { return std::isinf(distance); }));
  }
}

TEST(Separation, AreFiniteAroundATube)
{
  // No ball about a point of a thin ring holds one disk if it holds a section of the ring.
  const Surface ring = Torus(48, 8);
  const double most = EndAlong(2, ring, true) - EndAlong(2, ring, false); // mm, of the tube
  for (const double distance : DistancesOf(ring, 2.0 * most))
  {
    EXPECT_LT(distance, 1.01 * most);
  }
}

TEST(Separation, AreZeroWhereTrianglesIntersect)
{
  const Surface ball = Icosphere(2, 10.0);
  const Surface both = Together(ball, Moved(ball, Vector3(15.0, 0.3, 0.2)));
  const std::vector<double> distances = DistancesOf(both, 1.0);
  const auto half = static_cast<Index>(ball.Triangles.size());
  int crossing = 0;
  for (Index a = 0; a < half; ++a)
  {
    for (Index b = half; b < 2 * half; ++b)
    {
      const Triangle& one = both.Triangles[static_cast<std::size_t>(a)];
      if (Cross(both, one, both.Triangles[static_cast<std::size_t>(b)]))
      {
        EXPECT_EQ(distances[one[0]], 0.0);
        ++crossing;
      }
    }
  }
  EXPECT_GT(crossing, 5);
}

TEST(Separation, DoNotDependOnTheThreads)
{
  const Surface surface = BumpySphere(4, 3.0, 0.2, 7);
  EXPECT_EQ(DistancesOf(surface, 1.0, 1), DistancesOf(surface, 1.0, 3));
}

TEST(Separation, IsNotAboveTheDistanceOfNeedles)
{
  // A needle so thin that its normal is rounding, and a triangle that touches it.
  for (const double height : { 1e-6, 1e-10, 1e-13, 1e-15 })
  {
    Surface both;
    both.Points = { Vector3(100.1, 37.3, 55.7), Vector3(101.1, 37.9, 55.1),
      Vector3(100.6, 37.6 + height, 55.4), Vector3(100.6, 37.6, 55.4), Vector3(100.7, 39.0, 56.0),
      Vector3(100.5, 39.0, 57.0) };
    both.Triangles = { { 0, 1, 2 }, { 3, 4, 5 } };
    for (const double distance : DistancesOf(both, 1.0))
    {
      EXPECT_LT(distance, 1e-5) << height;
    }
  }
}

TEST(Separation, ADraftMovesLessThanHalfOfThem)
{
  const double error = 1.0;
  for (const Surface& input : { NearSpheres(3, 0.3), Plate(0.5), Scaled(Torus(60, 12), 0.1) })
  {
    const CleanSurface clean = Clean(input, true);
    Editor editor(clean, Guarded(error));
    const auto collapseAll = [&]
    {
      for (const Index h : HalfEdges(editor.Mesh(), 1))
      {
        const HalfEdgeId edge = h;
        const HalfEdgeMesh& mesh = editor.Mesh();
        if (mesh.IsAlive(HalfEdgeMesh::Face(edge)) && GatherAlone(editor, edge).IsAccepted())
        {
          const VertexId from = mesh.Origin(edge);
          const Vector3 middle = 0.5 * (mesh.Position(from) + mesh.Position(mesh.Target(edge)));
          TryAlone(editor, { edge, from, middle, false });
        }
      }
    };
    ASSERT_TRUE(MakeProvedDraft(editor, collapseAll));
    EXPECT_GT(editor.Totals().Collapses, 20);
    CertificateOptions options;
    options.Tolerance = error;
    for (const double distance : DistancesOf(clean.Surface, 2.0 * error))
    {
      options.ToleranceMap.push_back(std::min(error, 0.5 * distance));
    }
    const Surface result = SurfaceOf(editor.Mesh());
    EXPECT_EQ(Certify(clean.Surface, result, options).Proof, ProofStatus::Proved);
  }
}
