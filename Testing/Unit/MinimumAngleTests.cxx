// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Runs with a least angle, and what keeps it. Angles are measured by acos.
#include "Decimate/Stages/RingShape.h"
#include "Decimate/Stages/ShapeImprover.h"
#include "Geometry/SmallestAngle.h"
#include "Mesh/Invariants.h"
#include "Proof/Certificate/Certificate.h"
#include "Proof/EditFilters/ShapeFilter.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
double SmallestAngleOf(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const auto angle = [](const Vector3& at, const Vector3& p, const Vector3& q)
  {
    const double cosine = (p - at).normalized().dot((q - at).normalized());
    return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::acos(-1.0);
  };
  return std::min({ angle(a, b, c), angle(b, c, a), angle(c, a, b) });
}

double SmallestAngleOf(const Surface& surface)
{
  double smallest = 60.0;
  for (const Triangle& v : surface.Triangles)
  {
    smallest = std::min(
      smallest, SmallestAngleOf(surface.Points[v[0]], surface.Points[v[1]], surface.Points[v[2]]));
  }
  return smallest;
}

Options WithAngle(Options options, double degrees)
{
  options.MinimumAngle = degrees;
  return options;
}

/// A change of one triangle into another one of the plane z = 0, each a base of length 2 and an
/// apex above its middle.
Decision DecideOn(double heightBefore, double heightAfter, double degrees)
{
  Surface before;
  before.Points = { { 0, 0, 0 }, { 2, 0, 0 }, { 1, heightBefore, 0 } };
  before.Triangles = { { 0, 1, 2 } };
  const HalfEdgeMesh mesh(before);
  SurfaceChange change;
  change.OldFaces = { 0 };
  change.NewFaces = { { 0, { 0, 1, 2 },
    { before.Points[0], before.Points[1], Vector3(1, heightAfter, 0) } } };
  EditFilter::Pending pending;
  ShapeLimits limits;
  limits.MaxCosine = CosineOfDegrees(degrees);
  return ShapeFilter(limits, mesh, 1).Screen(mesh, change, pending);
}
}

TEST(ShapeFilter, RejectsASmallerAngleThanTheLeast)
{
  // atan(0.3) is 16.7 degrees, atan(0.4) 21.8, atan(0.5) 26.6.
  EXPECT_TRUE(DecideOn(0.5, 0.4, 20.0).IsAccepted());
  EXPECT_TRUE(DecideOn(0.5, 0.3, 20.0).IsRejected());
  EXPECT_EQ(DecideOn(0.5, 0.3, 20.0).Reason(), Rejection::Shape);
}

TEST(ShapeFilter, AcceptsASmallAngleInsteadOfASmallerOne)
{
  EXPECT_TRUE(DecideOn(0.2, 0.3, 20.0).IsAccepted());
  EXPECT_TRUE(DecideOn(0.3, 0.2, 20.0).IsRejected());
}

TEST(RingShape, FindsThePositionOfTheLargestAngle)
{
  // A hexagon around the origin: 60 degrees everywhere if the vertex is in its middle.
  Surface surface;
  surface.Points = { { 0.5, -0.3, 0 } };
  for (int i = 0; i < 6; ++i)
  {
    const double turn = i * std::acos(0.5);
    surface.Points.emplace_back(std::cos(turn), std::sin(turn), 0.0);
    surface.Triangles.push_back({ 0, 1 + i, 1 + (i + 1) % 6 });
  }
  const HalfEdgeMesh mesh(surface);
  RingShape ring;
  ring.Gather(mesh, 0);
  const double before = ring.CosineAt(surface.Points[0]);
  double cosine = before;
  const Vector3 found = ring.Search(surface.Points[0], 0.5, cosine);
  EXPECT_LT(found.norm(), 0.1);
  EXPECT_LT(cosine, before);
  EXPECT_EQ(ring.CosineAt(found), cosine);
  // It ends where the angle is large enough.
  double atOnce = before;
  EXPECT_EQ(ring.Search(surface.Points[0], before, atOnce), surface.Points[0]);
}

TEST(MinimumAngle, HoldsInEveryMode)
{
  const Surface sphere = BumpySphere(3, 10.0, 0.05, 11);
  ASSERT_GT(SmallestAngleOf(sphere), 30.0);
  for (const Mode mode : ProvingModes())
  {
    SCOPED_TRACE(FindMode(mode).Name);
    for (Options options : { Error(0.4), Triangles(400) })
    {
      options.Mode = mode;
      EXPECT_LT(SmallestAngleOf(Decimate(sphere, options).Surface), 20.0);
      const Result result = Decimate(sphere, WithAngle(options, 28.0));
      EXPECT_GE(SmallestAngleOf(result.Surface), 28.0);
      EXPECT_EQ(result.Report.Angles.Below, 0);
      EXPECT_LT(result.Surface.Triangles.size(), sphere.Triangles.size() / 2);
      if (options.MaximumError > 0.0)
      {
        EXPECT_EQ(result.Report.Proof.Status, ProofStatus::Proved);
        EXPECT_LE(Certify(sphere, result.Surface).Upper(), options.MaximumError);
      }
      else
      {
        EXPECT_EQ(result.Surface.Triangles.size(), 400U);
      }
    }
  }
}

TEST(MinimumAngle, ImprovesTrianglesOfTheInput)
{
  Surface squeezed = BumpySphere(3, 10.0, 0.05, 5);
  for (Vector3& p : squeezed.Points)
  {
    p.z() *= 0.25; // triangles of 15 degrees
  }
  ASSERT_LT(SmallestAngleOf(squeezed), 18.0);
  Options options = WithAngle(Error(0.3), 22.0);
  options.Mode = Mode::Fast;
  const Result result = Decimate(squeezed, options);
  EXPECT_GE(SmallestAngleOf(result.Surface), 22.0);
  EXPECT_EQ(result.Report.Proof.Status, ProofStatus::Proved);
}

TEST(MinimumAngle, ALargerOneTakesMoreTriangles)
{
  const Surface sphere = BumpySphere(3, 10.0, 0.05, 11);
  Options options = Error(0.4);
  options.Mode = Mode::Fast;
  std::size_t before = 0;
  for (const double degrees : { 20.0, 38.0 })
  {
    const std::size_t now = Decimate(sphere, WithAngle(options, degrees)).Surface.Triangles.size();
    EXPECT_GT(now, before) << degrees;
    before = now;
  }
}

TEST(MinimumAngle, LeavesConstrainedTrianglesAndCountsThem)
{
  Surface sphere = BumpySphere(4, 10.0, 0.2, 5);
  std::vector<double> tolerances(sphere.Points.size(), -1.0);
  for (std::size_t i = 0; i < sphere.Points.size(); ++i)
  {
    Vector3& p = sphere.Points[i];
    tolerances[i] = p.z() > 4.0 ? 0.0 : -1.0;
    p.z() = p.z() > 3.0 ? 3.0 + 0.1 * (p.z() - 3.0) : p.z(); // flat triangles on top
  }
  RunInputs inputs;
  inputs.Tolerances = &tolerances;
  Options options = WithAngle(Error(0.4), 20.0);
  options.Mode = Mode::Fast;
  options.OutputPointsPrecision = PointsPrecision::Double;
  const Result result = Decimate(sphere, options, {}, inputs);
  EXPECT_GT(result.Report.Angles.Below, 0);
  EXPECT_GT(result.Report.Angles.Worst.z(), 2.9);
  EXPECT_EQ(result.Report.Proof.Status, ProofStatus::Proved);
}

TEST(MinimumAngle, GivesTheSameBytesWhateverTheThreads)
{
  const Surface sphere = BumpySphere(3, 10.0, 0.05, 11);
  Options options = WithAngle(Error(0.4), 25.0);
  const Surface one = Decimate(sphere, options).Surface;
  options.NumberOfThreads = 3;
  const Surface three = Decimate(sphere, options).Surface;
  EXPECT_EQ(one.Points, three.Points);
  EXPECT_EQ(one.Triangles, three.Triangles);
}

TEST(ShapeImprover, KeepsTheMeshValidAfterEveryEdit)
{
  Surface squeezed = BumpySphere(3, 10.0, 0.2, 5);
  for (Vector3& p : squeezed.Points)
  {
    p.z() *= 0.25;
  }
  const CleanSurface clean = Clean(squeezed, true);
  EditorSettings settings;
  settings.RecordsDistances = false;
  settings.Shape.MaxCosine = CosineOfDegrees(25.0);
  Editor editor(clean, settings);
  int edits = 0;
  double smallest = SmallestAngleOf(squeezed);
  editor.SetHook(
    [&](const Editor& changed, const Edit&)
    {
      ++edits;
      EXPECT_EQ(BrokenInvariant(changed.Mesh()), "");
      Surface now = { {}, {} };
      for (VertexId v = 0; v < changed.Mesh().NumberOfVertexSlots(); ++v)
      {
        now.Points.push_back(changed.Mesh().Position(v));
      }
      for (FaceId face = 0; face < changed.Mesh().NumberOfFaceSlots(); ++face)
      {
        if (changed.Mesh().IsAlive(face))
        {
          now.Triangles.push_back(changed.Mesh().Corners(face));
        }
      }
      const double angle = SmallestAngleOf(now);
      EXPECT_GE(angle, std::min(smallest, 25.0) - 1e-9);
      smallest = angle;
    });
  EXPECT_TRUE(ShapeImprover(editor, settings.Shape.MaxCosine).Mend([](double) { return true; }));
  EXPECT_GT(edits, 20);
  EXPECT_GT(smallest, 24.9);
}

TEST(ShapeImprover, StopsWhenTheMonitorRequestsIt)
{
  const CleanSurface clean = Clean(BumpySphere(3, 10.0, 0.2, 5), true);
  EditorSettings settings;
  settings.RecordsDistances = false;
  settings.Shape.MaxCosine = CosineOfDegrees(40.0);
  Editor editor(clean, settings);
  ShapeImprover improver(editor, settings.Shape.MaxCosine);
  EXPECT_FALSE(improver.Mend([](double) { return false; }));
  EXPECT_FALSE(improver.Collapse(0, [](double) { return false; }));
  EXPECT_EQ(BrokenInvariant(editor.Mesh()), "");
}
