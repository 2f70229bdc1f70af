// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Edges that smoothing keeps by their angle.
#include "Geometry/TriangleGeometry.h"
#include "Proof/Certificate/Certificate.h"
#include "Runs.h"
#include "Smoothing/SharpEdges.h"
#include "Smoothing/SmoothingGraph.h"
#include "SmoothingRuns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
constexpr double Half = 3.5; // mm, of the cube

/// What Oblique() turns and shifts.
Vector3 ToShape(const Vector3& p)
{
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.5, Vector3(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  return turn * (p - Vector3(0.13, 0.21, 0.37));
}

const BinarySurface& Cube()
{
  static const BinarySurface cube =
    MarchedShape(Oblique(BoxShape({ Half, Half, Half })), 6.5, Cubic);
  return cube;
}

/// Half of a long block, cut so that the normals of the cut and of one side differ by the angle,
/// degrees.
BinarySurface Wedge(double angle)
{
  const double radians = angle / 57.29577951308232;
  const Vector3 cut(std::sin(radians), std::cos(radians), 0.0);
  return MarchedShape(Oblique(
                        [cut](const Vector3& p)
                        {
                          return p[1] <= 0.0 && cut.dot(p) <= 0.0 && p[1] >= -5.0 &&
                            std::abs(p[0]) <= 5.0 && std::abs(p[2]) <= 4.0;
                        }),
    8.0, Cubic);
}

SmoothingSettings Keeping(double angle)
{
  SmoothingSettings settings = Within(0.25);
  settings.FeatureAngle = angle;
  return settings;
}

/// mm
double DistanceToEdges(const Vector3& p)
{
  Vector3 beside = (ToShape(p).cwiseAbs() - Vector3::Constant(Half)).cwiseAbs();
  std::sort(beside.data(), beside.data() + 3);
  return std::hypot(beside[0], beside[1]);
}

struct Accuracy
{
  double Distance = 0.0; // RMS, mm
  double Angle = 0.0;    // mean of 1 - cosine
};

/// Accuracy of the triangles near the edges of the cube, weighted by area.
Accuracy NearEdges(const Surface& surface)
{
  Accuracy sum;
  double area = 0.0;
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.5, Vector3(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  for (const Triangle& c : surface.Triangles)
  {
    const Vector3& a = surface.Points[c[0]];
    const Vector3& b = surface.Points[c[1]];
    const Vector3& d = surface.Points[c[2]];
    const Vector3 middle = (a + b + d) / 3.0;
    if (DistanceToEdges(middle) < 0.75)
    {
      const Vector3 p = ToShape(middle);
      const Vector3 normal = turn * AreaVector(a, b, d);
      Index axis = 0;
      p.cwiseAbs().maxCoeff(&axis);
      const double out = std::abs(p[axis]) - Half;
      sum.Distance += normal.norm() * out * out;
      sum.Angle += normal.norm() - std::copysign(1.0, p[axis]) * normal[axis];
      area += normal.norm();
    }
  }
  return { std::sqrt(sum.Distance / area), sum.Angle / area };
}

/// The points on sharp edges of a smoothed surface.
std::vector<Vector3> SharpPoints(const Surface& surface, double angle)
{
  const SmoothingGraph graph(surface, {}, Eigen::Matrix3d::Identity(), 1);
  const SharpEdges found = FindSharpEdges(surface.Points, surface.Triangles, graph.SmoothEdges(),
    { angle, 2.3 * graph.MedianLength(), Eigen::Matrix3d::Identity(), 1 });
  std::vector<Vector3> points;
  for (std::size_t e = 0; e < found.IsSharp.size(); ++e)
  {
    const Triangle& other = surface.Triangles[graph.SmoothEdges()[e][1]];
    for (const Index corner : surface.Triangles[graph.SmoothEdges()[e][0]])
    {
      if (found.IsSharp[e] != 0 && std::find(other.begin(), other.end(), corner) != other.end())
      {
        points.push_back(surface.Points[corner]);
      }
    }
  }
  return points;
}
}

TEST(SharpEdges, OfACubeAreItsEdges)
{
  const std::vector<Vector3> points =
    SharpPoints(WithPoints(Cube().Surface, SmoothBinary(Cube(), Within(0.25)).Points), 45.0);
  ASSERT_FALSE(points.empty());
  for (const Vector3& p : points)
  {
    EXPECT_LT(DistanceToEdges(p), 1.0);
  }
  // Along each of the twelve edges, beside its ends.
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const auto& [u, v] :
      { std::pair(-1, -1), std::pair(-1, 1), std::pair(1, -1), std::pair(1, 1) })
    {
      for (const double along : { -2.0, -1.0, 0.0, 1.0, 2.0 })
      {
        Vector3 at;
        at[axis] = along;
        at[(axis + 1) % 3] = u * Half;
        at[(axis + 2) % 3] = v * Half;
        EXPECT_TRUE(std::any_of(points.begin(), points.end(),
          [&](const Vector3& p) { return (ToShape(p) - at).norm() < 1.0; }))
          << at.transpose();
      }
    }
  }
}

TEST(SharpEdges, AreNoneOnCurvedSurfaces)
{
  for (const BinarySurface& shape : { MarchedShape(Oblique(BallShape(1.5)), 3.0, Cubic),
         MarchedShape(Oblique(BallShape(6.0)), 7.0, Cubic),
         MarchedShape(Oblique(TorusShape(6.0, 2.5)), 9.5, Cubic) })
  {
    const SmoothedSurface kept = SmoothBinary(shape, Keeping(45.0));
    EXPECT_EQ(kept.Figures.SharpPoints, 0);
    EXPECT_TRUE(kept.Points == SmoothBinary(shape, Within(0.25)).Points);
  }
}

TEST(SharpEdges, AreNoneWhereOnlyOrientationsContradict)
{
  BinarySurface ball = MarchedShape(Oblique(BallShape(6.0)), 7.0, Cubic);
  for (Triangle& c : ball.Surface.Triangles)
  {
    if (ball.Surface.Points[c[0]][0] > 0.3)
    {
      std::swap(c[1], c[2]);
    }
  }
  EXPECT_EQ(Smooth({ ball.Surface }, Keeping(45.0)).Figures.SharpPoints, 0);
}

TEST(SharpEdges, AreNearerToTheTruthWhenTheyAreKept)
{
  const Accuracy rounded =
    NearEdges(WithPoints(Cube().Surface, SmoothBinary(Cube(), Within(0.25)).Points));
  const Accuracy kept =
    NearEdges(WithPoints(Cube().Surface, SmoothBinary(Cube(), Keeping(45.0)).Points));
  EXPECT_LT(kept.Distance, 0.9 * rounded.Distance);
  EXPECT_LT(kept.Angle, 0.8 * rounded.Angle);
}

TEST(SharpEdges, AreThoseAboveTheAngle)
{
  const auto count = [](const BinarySurface& shape, double angle)
  { return SmoothBinary(shape, Keeping(angle)).Figures.SharpPoints; };
  EXPECT_GT(count(Cube(), 45.0), 150);
  EXPECT_GT(count(Cube(), 75.0), 100);
  EXPECT_EQ(count(Cube(), 120.0), 0);
  EXPECT_EQ(count(Cube(), 180.0), 0);
  // Beside edges of 90 degrees those of the cut.
  const BinarySurface blunt = Wedge(60.0);
  EXPECT_GT(count(blunt, 40.0), count(blunt, 75.0) + 10);
  const BinarySurface acute = Wedge(120.0);
  EXPECT_GT(count(acute, 100.0), 10);
}

TEST(SharpEdges, AreFoundWithoutAGrid)
{
  const SmoothedSurface kept = Smooth({ Cube().Surface }, Keeping(45.0));
  EXPECT_GT(kept.Figures.SharpPoints, 120);
  EXPECT_LT(NearEdges(WithPoints(Cube().Surface, kept.Points)).Angle,
    0.9 *
      NearEdges(WithPoints(Cube().Surface, Smooth({ Cube().Surface }, Within(0.25)).Points)).Angle);
}

TEST(SharpEdges, KeepBoundsAndVoxels)
{
  std::vector<double> limits;
  for (const Vector3& p : Cube().Surface.Points)
  {
    limits.push_back(p[0] < 0.0 ? 0.0 : 0.2);
  }
  for (const std::vector<double>* given : { static_cast<const std::vector<double>*>(nullptr),
         static_cast<const std::vector<double>*>(&limits) })
  {
    const SmoothedSurface kept = SmoothBinary(Cube(), Keeping(45.0), given);
    EXPECT_GT(kept.Figures.SharpPoints, 0);
    EXPECT_EQ(CountChangedVoxels(Cube(), WithPoints(Cube().Surface, kept.Points)), 0);
    for (std::size_t p = 0; p < kept.Points.size(); ++p)
    {
      ASSERT_LE((kept.Points[p] - Cube().Surface.Points[p]).norm(), given ? limits[p] : 0.25);
    }
  }
}

TEST(SharpEdges, GiveTheSameBytesForAnyNumberOfThreads)
{
  const BinarySurface block = MarchedShape(Oblique(BoxShape({ 9.5, 7.5, 7.5 })), 13.5, Cubic);
  ASSERT_GT(block.Surface.Points.size(), 8192U);
  const SmoothedSurface expected = SmoothBinary(block, Keeping(45.0));
  for (const int threads : { 2, 5 })
  {
    SmoothingSettings settings = Keeping(45.0);
    settings.Threads = threads;
    EXPECT_TRUE(SmoothBinary(block, settings).Points == expected.Points) << threads;
  }
}

TEST(SharpEdges, DependNeitherOnUnitNorOnOriginNorOnTheAxes)
{
  const SmoothedSurface expected = SmoothBinary(Cube(), Keeping(45.0));
  const Vector3 shift(65536.0, -4096.0, 8192.0);
  BinarySurface other = Cube();
  for (Vector3& p : other.Surface.Points)
  {
    p = 1024.0 * Vector3(p[1], p[2], p[0]) + shift;
  }
  for (GridPoint& at : other.Source.OfPoint)
  {
    at = { at[1], at[2], at[0] };
  }
  const Vector3 origin = Cube().Source.Grid.Origin;
  other.Source.Grid.Origin = 1024.0 * Vector3(origin[1], origin[2], origin[0]) + shift;
  other.Source.Grid.Spacing *= 1024.0;
  SmoothingSettings settings = Keeping(45.0);
  settings.Radius *= 1024.0;
  const SmoothedSurface kept = SmoothBinary(other, settings);
  EXPECT_EQ(kept.Figures.SharpPoints, expected.Figures.SharpPoints);
  for (std::size_t p = 0; p < kept.Points.size(); ++p)
  {
    const Vector3 back = (kept.Points[p] - shift) / 1024.0;
    ASSERT_LT((Vector3(back[2], back[0], back[1]) - expected.Points[p]).norm(), 1e-9);
  }
}

TEST(SharpEdges, EndOnOpenBoundaries)
{
  // The cube without what lies below: its edges end on the boundary.
  BinarySurface open = Cube();
  std::vector<Triangle> upper;
  for (const Triangle& c : Cube().Surface.Triangles)
  {
    if (Cube().Surface.Points[c[0]][2] > -1.0)
    {
      upper.push_back(c);
    }
  }
  open.Surface.Triangles = upper;
  const SmoothedSurface kept = SmoothBinary(open, Keeping(45.0));
  EXPECT_GT(kept.Figures.SharpPoints, 80);
  EXPECT_LT(kept.Figures.SharpPoints, SmoothBinary(Cube(), Keeping(45.0)).Figures.SharpPoints);
  for (std::size_t p = 0; p < kept.Points.size(); ++p)
  {
    ASSERT_LE((kept.Points[p] - open.Surface.Points[p]).norm(), 0.25);
  }
}

TEST(SharpEdges, TakeAnySurface)
{
  for (const NamedSurface& shape : AllShapes())
  {
    bool isValid = !shape.Surface.Triangles.empty();
    for (const Triangle& c : shape.Surface.Triangles)
    {
      isValid = isValid && c[0] != c[1] && c[1] != c[2] && c[2] != c[0];
    }
    if (isValid)
    {
      SmoothingSettings settings = Within(0.1);
      settings.FeatureAngle = 20.0;
      const SmoothedSurface kept = Smooth({ shape.Surface }, settings);
      for (std::size_t p = 0; p < kept.Points.size(); ++p)
      {
        ASSERT_LE((kept.Points[p] - shape.Surface.Points[p]).norm(), 0.1) << shape.Name;
      }
    }
  }
}

TEST(SharpEdges, AreKeptInRunsOfAllModesWithinTheErrorThatIsProved)
{
  for (const Mode mode : AllModes())
  {
    Options options = InMode(mode, Reduction(0.5));
    options.MaximumError = FindMode(mode).ProvesError() ? 0.3 : 0.0;
    options.Smoothing = 0.2;
    options.FeatureAngle = 45.0;
    options.MeasureDistances = false;
    const Result result = Decimate(Cube().Surface, options);
    ASSERT_EQ(result.Report.Status, InputStatus::Good);
    EXPECT_GT(result.Report.Smoothing.SharpPoints, 100);
    if (FindMode(mode).ProvesError())
    {
      EXPECT_EQ(result.Report.Proof.Status, ProofStatus::Proved);
    }
  }
}

TEST(SharpEdges, AreKeptInsideOfEveryLabel)
{
  // Two labels side by side in the cube: the curve between them is kept as before, and so are the
  // edges of both.
  LabelMapSource source;
  for (const Triangle& c : Cube().Surface.Triangles)
  {
    const bool isLow = Cube().Surface.Points[c[0]][2] < 0.0;
    source.OfTriangle.push_back(isLow ? BoundaryLabels{ 0, 2 } : BoundaryLabels{ 1, 2 });
  }
  const SmoothedSurface kept = Smooth({ Cube().Surface, nullptr, &source }, Keeping(45.0));
  EXPECT_GT(kept.Figures.SharpPoints, 120);
  EXPECT_LT(NearEdges(WithPoints(Cube().Surface, kept.Points)).Angle,
    NearEdges(
      WithPoints(Cube().Surface, Smooth({ Cube().Surface, nullptr, &source }, Within(0.25)).Points))
      .Angle);
}
