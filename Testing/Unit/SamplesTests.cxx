// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Relations between the current faces and the original: nearest points, walks, samples.
#include "BruteForce.h"
#include "Decimate/Schedule/BucketSweep.h"
#include "Geometry/TriangleFrame.h"
#include "Proof/Reference/OriginalHints.h"
#include "Proof/Reference/Samples.h"
#include "Random.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
const Monitor GoOn = [](double) { return true; };

/// Checks all members of the nearest point. Lengths are of the order of size.
void ExpectNearest(const Vector3& p, const std::array<Vector3, 3>& t, double size)
{
  const TriangleFrame frame(t[0], t[1], t[2]);
  const TriangleFrame::Point point = frame.Nearest(p);
  const double tolerance = 1e-7 * size;
  EXPECT_NEAR(
    std::sqrt(point.SquaredDistance), PointTriangleDistance(p, t[0], t[1], t[2]), tolerance);
  EXPECT_NEAR((frame.At(point) - p).norm(), std::sqrt(point.SquaredDistance), tolerance);
  const std::array<double, 3> weights = { 1.0 - point.B - point.C, point.B, point.C };
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_GE(weights[i], -1e-12);
    EXPECT_TRUE((point.Clamped & (1 << i)) == 0 || std::abs(weights[i]) < 1e-12);
  }
}

/// How often each sample is in the list of a live face.
std::vector<int> TimesListed(const Samples& samples, const HalfEdgeMesh& mesh)
{
  std::vector<int> times(static_cast<std::size_t>(samples.Count()), 0);
  for (Index face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    EXPECT_TRUE(mesh.IsAlive(face) || samples.First(face) == None) << "face " << face;
    for (Index s = samples.First(face); s != None; s = samples[s].Next)
    {
      ++times[static_cast<std::size_t>(s)];
    }
  }
  return times;
}
}

TEST(TriangleFrame, NearestAgreesWithBruteForceOnTrianglesOfAllShapes)
{
  Random random(5);
  for (int i = 0; i < 20000; ++i)
  {
    const double size = std::pow(10.0, random.Between(-3.0, 3.0));
    std::array<Vector3, 3> t = { random.InCube(size), random.InCube(size), random.InCube(size) };
    if (i % 4 == 0)
    {
      t[2] = t[0] + random.Uniform() * (t[1] - t[0]) + 1e-4 * t[2]; // a needle
    }
    ExpectNearest(random.InCube(2.0 * size), t, size);
  }
}

TEST(TriangleFrame, NearestIsRightWhereATriangleHasNoArea)
{
  Random random(6);
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3 a = random.InCube(1.0);
    const Vector3 b = random.InCube(1.0);
    ExpectNearest(random.InCube(2.0), { a, b, a + random.Uniform() * (b - a) }, 1.0);
    ExpectNearest(random.InCube(2.0), { a, a, a }, 1.0);
  }
}

TEST(SurfaceWalk, FindsTheNearestPointOfAConvexSurfaceFromNearby)
{
  const Surface sphere = Icosphere(3, 10.0);
  const HalfEdgeMesh mesh(sphere);
  Random random(7);
  for (int i = 0; i < 2000; ++i)
  {
    Vector3 p = random.InCube(1.0);
    p *= random.Between(10.0, 14.0) / p.norm();
    const Index near = sphere.Triangles[BruteNearest(sphere, p).Triangle][0];
    const Index start = mesh.Target(mesh.Outgoing(mesh.Target(mesh.Outgoing(near))));
    const PointOnMesh found = WalkFromVertex(mesh, p, start);
    EXPECT_NEAR(std::sqrt(found.Point.SquaredDistance), BruteNearest(sphere, p).Distance, 1e-9);
  }
}

TEST(SurfaceWalk, NeverEndsFartherThanItBegan)
{
  Random random(8);
  for (const NamedSurface& shape : AllShapes())
  {
    const HalfEdgeMesh mesh(Clean(shape.Surface, true).Surface);
    for (int i = 0; i < 200; ++i)
    {
      const Index face = random.Below(mesh.NumberOfFaceSlots());
      const Vector3 p = random.InCube(20.0);
      const double began = FrameOf(mesh, face).Nearest(p).SquaredDistance;
      const PointOnMesh found = WalkFrom(mesh, p, face);
      EXPECT_LE(found.Point.SquaredDistance, began) << shape.Name;
      EXPECT_EQ(found.Point.SquaredDistance, FrameOf(mesh, found.Face).Nearest(p).SquaredDistance);
    }
  }
}

class EachSample : public EachShape
{
};

TEST_P(EachSample, IsInTheListOfExactlyOneFaceAndAllRepresentTheWholeArea)
{
  const CleanSurface clean = Clean(GetParam().Surface, true);
  for (const Index divisor : { 2, 10 })
  {
    Editor editor(clean, EditorSettings{ false, false, true });
    const HalfEdgeMesh original = editor.Mesh();
    BucketSweep(editor, 1).Run({ original.NumberOfFaces() / divisor, 0.0 }, GoOn);
    Samples samples(original);
    ASSERT_TRUE(samples.Distribute(editor.Mesh(), editor.Original().CurrentOfInitial(), 1, GoOn));
    const std::vector<int> one(static_cast<std::size_t>(samples.Count()), 1);
    EXPECT_EQ(TimesListed(samples, editor.Mesh()), one);
    double area = 0.0; // squares of the unit
    for (Index s = 0; s < samples.Count(); ++s)
    {
      area += samples[s].Weight;
    }
    const double expected = TotalArea(clean.Surface) / (original.Unit() * original.Unit());
    EXPECT_NEAR(area, expected, 1e-5 * expected);
    ASSERT_TRUE(samples.Settle(editor.Mesh(), 1, GoOn));
    EXPECT_EQ(TimesListed(samples, editor.Mesh()), one);
  }
}

TEST_P(EachSample, LiesOnTheOriginalBeforeAnythingIsCollapsed)
{
  const CleanSurface clean = Clean(GetParam().Surface, true);
  const Editor editor(clean, EditorSettings{ false, false, true });
  const HalfEdgeMesh& mesh = editor.Mesh();
  Samples samples(mesh);
  ASSERT_TRUE(samples.Distribute(mesh, editor.Original().CurrentOfInitial(), 1, GoOn));
  for (Index face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    samples.VisitFace(face,
      [&](const Samples::Sample& sample)
      {
        const Vector3 p = samples.SamplePosition(sample);
        EXPECT_NEAR(std::sqrt(FrameOf(mesh, face).Nearest(p).SquaredDistance), 0.0, 1e-4);
      });
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, EachSample, testing::ValuesIn(AllShapes()), NameOf);

TEST(Samples, AreTheSameForAnyNumberOfThreads)
{
  const CleanSurface clean = Clean(BumpySphere(5, 20.0, 0.05, 8), true);
  Editor editor(clean, EditorSettings{ false, false, true });
  const HalfEdgeMesh original = editor.Mesh();
  BucketSweep(editor, 1).Run({ original.NumberOfFaces() / 8, 0.0 }, GoOn);
  Samples one(original);
  one.Distribute(editor.Mesh(), editor.Original().CurrentOfInitial(), 1, GoOn);
  Samples four(original);
  four.Distribute(editor.Mesh(), editor.Original().CurrentOfInitial(), 4, GoOn);
  ASSERT_EQ(one.Count(), four.Count());
  for (Index s = 0; s < one.Count(); ++s)
  {
    EXPECT_EQ(one[s].Position, four[s].Position);
    EXPECT_EQ(one[s].Next, four[s].Next);
  }
}

TEST(OriginalHints, LeadToTheNearestPointOfTheOriginalOnASmoothSurface)
{
  const CleanSurface clean = Clean(BumpySphere(4, 20.0, 0.02, 8), true);
  Editor editor(clean, EditorSettings{ false, false, true });
  const HalfEdgeMesh original = editor.Mesh();
  BucketSweep(editor, 1).Run({ original.NumberOfFaces() / 8, 0.0 }, GoOn);
  OriginalHints hints(original);
  ASSERT_TRUE(hints.Restart(editor.Mesh(), 1, GoOn));
  for (Index v = 0; v < editor.Mesh().NumberOfVertexSlots(); ++v)
  {
    if (editor.Mesh().Outgoing(v) != None)
    {
      const Vector3& p = editor.Mesh().Position(v);
      EXPECT_NEAR(std::sqrt(hints.Find(p, v).Point.SquaredDistance),
        BruteNearest(clean.Surface, p).Distance, 1e-9);
    }
  }
}
