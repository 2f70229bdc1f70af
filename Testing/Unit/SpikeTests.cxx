// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Thin spikes, whose tips have no area: accumulated error of a collapse, its penalty, and the
// distance of results.
#include "BruteForce.h"
#include "Decimate/Cost/SampledErrorCost.h"
#include "Decimate/Schedule/BucketSweep.h"
#include "Mesh/SpatialOrder.h"
#include "Random.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
constexpr std::size_t TrianglesPerSpur = 997;
constexpr double Height = 0.6; // mm

/// Puts a thin spur on the middle of a triangle.
void GrowSpur(Surface& surface, std::size_t triangle)
{
  constexpr double thickness = 0.05; // of the triangle
  const Triangle old = surface.Triangles[triangle];
  const std::array<Vector3, 3> p = { surface.Points[old[0]], surface.Points[old[1]],
    surface.Points[old[2]] };
  const Vector3 middle = (p[0] + p[1] + p[2]) / 3.0;
  const Index first = static_cast<Index>(surface.Points.size());
  for (const Vector3& corner : p)
  {
    surface.Points.push_back(middle + thickness * (corner - middle));
  }
  surface.Points.push_back(middle + Height * (p[1] - p[0]).cross(p[2] - p[0]).normalized());
  const Index tip = first + 3;
  surface.Triangles[triangle] = { first, first + 1, tip };
  surface.Triangles.push_back({ first + 1, first + 2, tip });
  surface.Triangles.push_back({ first + 2, first, tip });
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Index base = first + static_cast<Index>(k);
    const Index next = first + static_cast<Index>((k + 1) % 3);
    surface.Triangles.push_back({ old[k], old[(k + 1) % 3], next });
    surface.Triangles.push_back({ old[k], next, base });
  }
}

/// A sphere with a thin spur on every so many triangles.
Surface SpikySphere()
{
  Surface surface = Icosphere(5, 20.0);
  const std::size_t count = surface.Triangles.size();
  for (std::size_t i = 0; i < count; i += TrianglesPerSpur)
  {
    GrowSpur(surface, i);
  }
  return surface;
}

double MaxDistance(const Surface& from, const Surface& to)
{
  const BoundingTree tree(to);
  double largest = 0.0; // mm^2
  for (const Vector3& p : from.Points)
  {
    largest = std::max(largest, tree.FindNearest(p).Point.SquaredDistance);
  }
  return std::sqrt(largest);
}

/// mm, from the points of the original to what is left of them.
double PeakAfterSweep(const Surface& input, Index faces, double spikeWeight)
{
  CleanSurface cleaned = Clean(input, true);
  SortAlongCurve(cleaned, 1);
  Editor editor(cleaned, EditorSettings{ false, false, true });
  BucketSweep(editor, 1, SweepSettings{ spikeWeight, 1 })
    .Run({ faces, 0.0 }, [](double) { return true; });
  return MaxDistance(cleaned.Surface, SurfaceOf(editor.Mesh()));
}

double DistanceTo(const std::vector<std::array<Vector3, 3>>& triangles, const Vector3& p)
{
  double least = std::numeric_limits<double>::infinity();
  for (const std::array<Vector3, 3>& t : triangles)
  {
    least = std::min(least, PointTriangleDistance(p, t[0], t[1], t[2]));
  }
  return least;
}

/// The triangles around an edge before its collapse, and after it.
struct AroundEdge
{
  AroundEdge(const HalfEdgeMesh& mesh, const EdgeNeighborhood& around, const Vector3& position)
  {
    const auto add = [&](Index face)
    {
      const Triangle c = mesh.Corners(face);
      this->Before.push_back({ mesh.Position(c[0]), mesh.Position(c[1]), mesh.Position(c[2]) });
    };
    for (const Index h : around.Corners)
    {
      add(HalfEdgeMesh::Face(h));
      this->After.push_back(
        { position, mesh.Position(mesh.Target(h)), mesh.Position(mesh.Apex(h)) });
    }
    for (Index i = 0; i < around.NumberOfRemovedFaces; ++i)
    {
      add(around.RemovedFaces[static_cast<std::size_t>(i)]);
    }
  }
  std::vector<std::array<Vector3, 3>> Before, After;
};
}

class LeftBehind : public EachShape
{
};

TEST_P(LeftBehind, IsTheLargestOfBothEndsToTheNewFanAndOfThePositionToTheOldOne)
{
  const CleanSurface cleaned = Clean(GetParam().Surface, true);
  Editor editor(cleaned, EditorSettings{ false, false, true });
  const HalfEdgeMesh& mesh = editor.Mesh();
  Random random(5);
  EditWorkspace work;
  for (const Index edge : HalfEdges(mesh, 7))
  {
    if (!editor.Gather(edge, work).IsAccepted())
    {
      continue;
    }
    const Vector3 start = mesh.Position(work.Neighborhood.Start);
    const Vector3 end = mesh.Position(work.Neighborhood.End);
    const Vector3 position = 0.5 * (start + end) + random.InCube((end - start).norm());
    Fan& fan = work.FanArrays.Current();
    for (int k = 0; k < 3; ++k)
    {
      fan.Position[k] = position[k] - start[k];
    }
    const AroundEdge faces(mesh, work.Neighborhood, position);
    const double expected = std::max({ 0.5 + DistanceTo(faces.After, start),
      0.25 + DistanceTo(faces.After, end), 0.5 + DistanceTo(faces.Before, position) });
    for (const Kernels* kernels : AvailableKernels())
    {
      EXPECT_NEAR(kernels->AccumulateError(fan, 0.5, 0.25), expected, 1e-9 * (1.0 + expected))
        << kernels->Name << " at half-edge " << edge;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, LeftBehind, testing::ValuesIn(AllShapes()), NameOf);

TEST(BucketSweep, CollapsesNoSpikeTooEarly)
{
  const Surface input = SpikySphere();
  const Index faces = static_cast<Index>(input.Triangles.size()) / 4;
  EXPECT_GT(PeakAfterSweep(input, faces, 0.0), 0.9 * Height) << "or there is nothing to show";
  EXPECT_LT(PeakAfterSweep(input, faces, FindMode(Mode::Fast).Sweep.SpikeWeight), 0.1 * Height);
}

TEST(RefinedModes, LeaveNothingFarInEitherDirection)
{
  const Surface input = SpikySphere();
  for (const Mode mode : { Mode::Balanced, Mode::Accurate })
  {
    const Surface result = Decimate(input, InMode(mode, Reduction(0.75))).Surface;
    EXPECT_LT(MaxDistance(input, result), 0.2 * Height) << WordOf(mode);
    EXPECT_LT(MaxDistance(result, input), 0.2 * Height) << WordOf(mode);
  }
}

TEST(FarPenalty, IsNothingUpToTheLimitAndFitsWithTheWeightOfItsSlopeBeyond)
{
  const FarPenalty penalty(2.0, 0.5);
  for (const double d : { 0.0, 1.0, 2.0 })
  {
    EXPECT_EQ(penalty.Of(d * d), 0.0);
    EXPECT_EQ(penalty.WithWeight(d * d).Weight, 0.0);
  }
  for (const double d : { 2.1, 4.0, 30.0 })
  {
    const double h = 1e-5 * d;
    const double slope =
      (penalty.Of((d + h) * (d + h)) - penalty.Of((d - h) * (d - h))) / (2.0 * h);
    EXPECT_GT(penalty.Of(d * d), 0.0);
    EXPECT_EQ(penalty.WithWeight(d * d).Value, penalty.Of(d * d));
    EXPECT_NEAR(2.0 * penalty.WithWeight(d * d).Weight * d, slope, 1e-5 * slope);
  }
}

TEST(FarPenalty, IsZeroWithoutAUsualDistance)
{
  const FarPenalty penalty(0.0, 0.0);
  EXPECT_EQ(penalty.Of(0.0), 0.0);
  EXPECT_EQ(penalty.Of(1e6), 0.0);
  EXPECT_EQ(penalty.WithWeight(1e6).Weight, 0.0);
}
