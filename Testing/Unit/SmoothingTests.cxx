// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Smoothing within a bound: what it keeps and what it depends on.
#include "Crossings.h"
#include "Geometry/TriangleGeometry.h"
#include "Mesh/SurfaceAssembly.h"
#include "Random.h"
#include "SmoothingRuns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
void ExpectWithin(
  const Surface& before, const std::vector<Vector3>& after, const std::vector<double>& radii)
{
  ASSERT_EQ(before.Points.size(), after.size());
  for (std::size_t p = 0; p < after.size(); ++p)
  {
    ASSERT_LE((after[p] - before.Points[p]).norm(), radii[p]) << p;
    if (radii[p] == 0.0)
    {
      ASSERT_TRUE(after[p] == before.Points[p]);
    }
  }
}
}

TEST(Smoothing, MovesNoPointFartherThanTheRadius)
{
  const BinarySurface ball = MarchedShape(Oblique(BallShape(6.0)), 7.0, Cubic);
  for (const double radius : { 0.01, 0.1, 0.25, 2.0 })
  {
    for (const bool isSingle : { false, true })
    {
      SmoothingSettings settings = Within(radius);
      settings.Rounding.ToSingle = isSingle;
      settings.Origin = Vector3(100.3, -77.1, 13.7);
      const SmoothedSurface smoothed = Smooth({ ball.Surface }, settings);
      ExpectWithin(
        ball.Surface, smoothed.Points, std::vector<double>(smoothed.Points.size(), radius));
      EXPECT_LE(smoothed.Figures.MaxDisplacement, radius);
      EXPECT_GT(smoothed.Figures.MaxDisplacement, 0.0);
    }
  }
}

TEST(Smoothing, WritesPointsInSinglePrecision)
{
  const BinarySurface ball = MarchedShape(Oblique(BallShape(4.0)), 5.0, Cubic);
  SmoothingSettings settings = Within(0.25);
  settings.Rounding.ToSingle = true;
  settings.Origin = Vector3(100.25, -77.5, 13.75);
  for (const Vector3& p : Smooth({ ball.Surface }, settings).Points)
  {
    const Vector3 written = p + settings.Origin;
    ASSERT_TRUE(written == RoundedToSingle(written));
  }
}

TEST(Smoothing, KeepsToTheLimitOfEachPointAndOfItsNeighbors)
{
  const BinarySurface ball = MarchedShape(Oblique(BallShape(6.0)), 7.0, Cubic);
  std::vector<double> limits;
  Random random(7);
  for (const Vector3& p : ball.Surface.Points)
  {
    limits.push_back(p[0] < -2.0 ? 0.0 : random.Between(0.01, 0.3));
  }
  std::vector<double> least = limits;
  for (const Triangle& c : ball.Surface.Triangles)
  {
    const double ofTriangle = std::min({ limits[c[0]], limits[c[1]], limits[c[2]] });
    for (const Index corner : c)
    {
      least[corner] = std::min(least[corner], ofTriangle);
    }
  }
  const SmoothedSurface smoothed = SmoothBinary(ball, Within(0.25), &limits);
  ExpectWithin(ball.Surface, smoothed.Points, least);
  EXPECT_GT(smoothed.Figures.MaxDisplacement, 0.05);
}

TEST(Smoothing, OfABoundaryGoesAlongIt)
{
  const Surface field = HeightField(12, 0.4, 3);
  SmoothingSettings settings = Within(0.4);
  settings.Strength = 5.0;
  const SmoothedSurface smoothed = Smooth({ field }, settings);
  for (std::size_t p = 0; p < field.Points.size(); ++p)
  {
    for (const int axis : { 0, 1 })
    {
      const double at = field.Points[p][axis];
      const bool isCorner = (field.Points[p][0] == 0.0 || field.Points[p][0] == 12.0) &&
        (field.Points[p][1] == 0.0 || field.Points[p][1] == 12.0);
      if ((at == 0.0 || at == 12.0) && !isCorner)
      {
        // The corners are rounded, and pull their neighbors a little.
        EXPECT_NEAR(smoothed.Points[p][axis], at, 0.2);
        EXPECT_NEAR(smoothed.Points[p][2], field.Points[p][2], 0.06);
      }
    }
  }
  EXPECT_LT(smoothed.Figures.AngleAfter, 0.5 * smoothed.Figures.AngleBefore);
}

TEST(Smoothing, OfLabelsKeepsWallsJoinedWithoutIntersections)
{
  const auto labelOf = [](const std::array<Index, 3>& v)
  {
    const Vector3 p(v[0] - 4.2, v[1] - 4.4, v[2] - 4.6);
    return p.norm() > 4.5 ? 0 : p[2] > 0.3 ? 3 : p[0] + 0.5 * p[1] > 0.2 ? 2 : 1;
  };
  const BlockComplex blocks = BlocksOf({ 10, 10, 10 }, labelOf);
  const Topology before = CountTopology(blocks.Surface);
  ASSERT_GT(before.NonManifoldEdges, 20);
  LabelMapSource source;
  source.OfTriangle = blocks.Labels;
  SmoothingSettings settings = Within(0.5);
  const std::int64_t crossings = CountCrossings(blocks.Surface);
  const SmoothedSurface smoothed = Smooth({ blocks.Surface, nullptr, &source }, settings);
  const Surface after = WithPoints(blocks.Surface, smoothed.Points);
  EXPECT_TRUE(CountTopology(after) == before);
  EXPECT_LE(CountCrossings(after), crossings);
  EXPECT_EQ(smoothed.Figures.Strength, 3.0);
  EXPECT_LT(smoothed.Figures.AngleAfter, 0.6 * smoothed.Figures.AngleBefore);
}

TEST(Smoothing, OfTwoLabelsKeepsTheCurveBetweenThem)
{
  // A flat grid whose two labels meet along a staircase: only the staircase is smoothed.
  const Surface grid = Grid(12);
  LabelMapSource source;
  for (const Triangle& c : grid.Triangles)
  {
    const Vector3 middle = (grid.Points[c[0]] + grid.Points[c[1]] + grid.Points[c[2]]) / 3.0;
    const bool isFirst = std::floor(middle[0]) < std::floor(middle[1] / 2.0) + 3.0;
    source.OfTriangle.push_back(isFirst ? BoundaryLabels{ 1, 0 } : BoundaryLabels{ 2, 0 });
  }
  const auto curveLength = [&](const std::vector<Vector3>& points)
  {
    double length = 0.0;
    for (std::size_t t = 0; t < grid.Triangles.size(); ++t)
    {
      for (std::size_t u = 0; u < t; ++u)
      {
        std::vector<Index> common;
        for (const Index corner : grid.Triangles[t])
        {
          if (std::count(grid.Triangles[u].begin(), grid.Triangles[u].end(), corner) > 0)
          {
            common.push_back(corner);
          }
        }
        if (common.size() == 2 && source.OfTriangle[t] != source.OfTriangle[u])
        {
          length += (points[common[0]] - points[common[1]]).norm();
        }
      }
    }
    return length;
  };
  const std::vector<Vector3> smoothed = Smooth({ grid, nullptr, &source }, Within(0.4)).Points;
  EXPECT_LT(curveLength(smoothed), 0.9 * curveLength(grid.Points));
  EXPECT_GT(curveLength(Smooth({ grid }, Within(0.4)).Points), curveLength(smoothed));
}

TEST(Smoothing, TakesAnySurface)
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
      const SmoothedSurface smoothed = Smooth({ shape.Surface }, Within(0.1));
      ExpectWithin(
        shape.Surface, smoothed.Points, std::vector<double>(smoothed.Points.size(), 0.1));
    }
  }
}

TEST(Smoothing, GivesTheSameBytesForAnyNumberOfThreads)
{
  const BinarySurface torus = MarchedShape(Oblique(TorusShape(9.0, 4.0)), 14.0, Cubic);
  ASSERT_GT(torus.Surface.Points.size(), 8192U);
  const SmoothedSurface expected = SmoothBinary(torus, Within(0.25));
  for (const int threads : { 2, 3, 8 })
  {
    SmoothingSettings settings = Within(0.25);
    settings.Threads = threads;
    const SmoothedSurface smoothed = SmoothBinary(torus, settings);
    EXPECT_TRUE(smoothed.Points == expected.Points) << threads;
    EXPECT_EQ(smoothed.Figures.AngleAfter, expected.Figures.AngleAfter);
    EXPECT_EQ(smoothed.Figures.Strength, expected.Figures.Strength);
  }
}

TEST(Smoothing, ScalesWithTheUnitAndMovesWithTheOrigin)
{
  const BinarySurface ball = MarchedShape(Oblique(BallShape(5.0)), 6.0, Cubic);
  const std::vector<Vector3> expected = SmoothBinary(ball, Within(0.25)).Points;
  BinarySurface other = ball;
  other.Surface = Moved(Scaled(ball.Surface, 1024.0), { 65536.0, -4096.0, 8192.0 });
  other.Source.Grid.Spacing *= 1024.0;
  other.Source.Grid.Origin = 1024.0 * ball.Source.Grid.Origin + Vector3(65536.0, -4096.0, 8192.0);
  const std::vector<Vector3> scaled = SmoothBinary(other, Within(256.0)).Points;
  for (std::size_t p = 0; p < expected.size(); ++p)
  {
    const Vector3 back = (scaled[p] - Vector3(65536.0, -4096.0, 8192.0)) / 1024.0;
    ASSERT_LT((back - expected[p]).norm(), 1e-11);
  }
}

TEST(Smoothing, IsStrongerWithMoreStrengthAndFartherWithMoreRadius)
{
  const BinarySurface ball = MarchedShape(Oblique(BallShape(6.0)), 7.0, Cubic);
  double angle = 1e9;
  for (const double strength : { 0.3, 1.0, 4.0, 15.0 })
  {
    SmoothingSettings settings = Within(10.0);
    settings.Strength = strength;
    const SmoothedSurface smoothed = Smooth({ ball.Surface }, settings);
    EXPECT_EQ(smoothed.Figures.Strength, strength);
    EXPECT_LT(smoothed.Figures.AngleAfter, angle);
    angle = smoothed.Figures.AngleAfter;
  }
  double farthest = 0.0;
  for (const double radius : { 0.02, 0.06, 0.12 })
  {
    const SmoothedSurface smoothed = Smooth({ ball.Surface }, Within(radius));
    EXPECT_GT(smoothed.Figures.MaxDisplacement, farthest);
    EXPECT_GT(smoothed.Figures.MaxDisplacement, 0.9 * radius);
    farthest = smoothed.Figures.MaxDisplacement;
  }
}

TEST(Smoothing, ReachesTheMinimum)
{
  // Without limits the minimum solves (1 + lambda L^T L) d = -lambda L^T L x0: compare with ten times the iterations.
  const BinarySurface ball = MarchedShape(Oblique(BallShape(4.0)), 5.0, Cubic);
  SmoothingSettings settings = Within(10.0);
  settings.Strength = 5.0;
  const std::vector<Vector3> once = Smooth({ ball.Surface }, settings).Points;
  const std::size_t n = once.size();
  Eigen::MatrixXd laplacian = Eigen::MatrixXd::Identity(n, n);
  std::vector<double> lengths;
  std::vector<std::pair<Index, Index>> edges;
  for (const Triangle& c : ball.Surface.Triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      edges.emplace_back(
        c[i], c[(i + 1) % 3]); // closed and oriented: every edge once in each direction
      lengths.push_back((ball.Surface.Points[c[i]] - ball.Surface.Points[c[(i + 1) % 3]]).norm());
    }
  }
  std::vector<double> sorted = lengths;
  std::sort(sorted.begin(), sorted.end());
  const double shortest = 0.6 * sorted[sorted.size() / 2];
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    weights(edges[e].first, edges[e].second) = 1.0 / std::pow(std::max(lengths[e], shortest), 2.0);
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    laplacian.row(i) -= weights.row(i) / weights.row(i).sum();
  }
  Eigen::MatrixXd points(n, 3);
  for (std::size_t i = 0; i < n; ++i)
  {
    points.row(i) = ball.Surface.Points[i].transpose();
  }
  const Eigen::MatrixXd system =
    Eigen::MatrixXd::Identity(n, n) + 5.0 * laplacian.transpose() * laplacian;
  const Eigen::MatrixXd exact = system.ldlt().solve(points);
  for (std::size_t i = 0; i < n; ++i)
  {
    ASSERT_LT((exact.row(i).transpose() - once[i]).norm(), 0.005);
  }
}

namespace
{
/// Every triangle in four.
Surface Refined(const Surface& surface)
{
  Surface fine = { surface.Points, {} };
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middle = [&](Index a, Index b)
  {
    const auto [entry, isNew] =
      middles.emplace(std::minmax(a, b), static_cast<Index>(fine.Points.size()));
    if (isNew)
    {
      fine.Points.push_back(0.5 * (surface.Points[a] + surface.Points[b]));
    }
    return entry->second;
  };
  for (const Triangle& c : surface.Triangles)
  {
    const Index a = middle(c[0], c[1]);
    const Index b = middle(c[1], c[2]);
    const Index d = middle(c[2], c[0]);
    fine.Triangles.insert(
      fine.Triangles.end(), { { c[0], a, d }, { a, c[1], b }, { d, b, c[2] }, { a, b, d } });
  }
  return fine;
}
}

TEST(Smoothing, MakesNoIntersections)
{
  // A fine and a coarse surface lie close to each other: smoothing flattens the coarse one more.
  const Surface coarse = HeightField(8, 0.5, 11);
  const Surface both = Together(coarse, Moved(Refined(coarse), { 0.0, 0.0, 0.05 }));
  ASSERT_EQ(CountCrossings(both), 0);
  SmoothingSettings settings = Within(0.3);
  settings.Strength = 5.0;
  const SmoothedSurface smoothed = Smooth({ both }, settings);
  EXPECT_GT(smoothed.Figures.Rounds, 0);
  EXPECT_GT(smoothed.Figures.LimitedPoints, 0);
  EXPECT_EQ(CountCrossings(WithPoints(both, smoothed.Points)), 0);
  EXPECT_GT(smoothed.Figures.MaxDisplacement, 0.05);
  // The pair alone intersects.
  const std::vector<Vector3> one = Smooth({ coarse }, settings).Points;
  Surface apart = Together(WithPoints(coarse, one),
    Moved(
      WithPoints(Refined(coarse), Smooth({ Refined(coarse) }, settings).Points), { 0, 0, 0.05 }));
  EXPECT_GT(CountCrossings(apart), 0);
}

TEST(Smoothing, TurnsNoTriangleOver)
{
  const Surface needles = Needles(12);
  const Surface spikes = HeightField(10, 3.0, 5);
  for (const Surface& surface : { needles, spikes, BumpySphere(3, 10.0, 0.5, 9) })
  {
    SmoothingSettings settings = Within(5.0);
    settings.Strength = 10.0;
    const std::vector<Vector3> after = Smooth({ surface }, settings).Points;
    for (const Triangle& c : surface.Triangles)
    {
      const Vector3 before =
        AreaVector(surface.Points[c[0]], surface.Points[c[1]], surface.Points[c[2]]);
      ASSERT_GT(before.dot(AreaVector(after[c[0]], after[c[1]], after[c[2]])), 0.0);
    }
  }
}

TEST(Smoothing, LeavesTheSurfaceAsItWasAfterAnAbort)
{
  const BinarySurface ball = MarchedShape(Oblique(BallShape(6.0)), 7.0, Cubic);
  for (const int calls : { 0, 1, 5, 20 })
  {
    int left = calls;
    const SmoothedSurface smoothed = Smooth(
      { ball.Surface, nullptr, &ball.Source }, Within(0.25), [&](double) { return left-- > 0; });
    EXPECT_TRUE(smoothed.IsAborted);
    EXPECT_TRUE(smoothed.Points == ball.Surface.Points);
  }
  double last = 0.0;
  const SmoothedSurface whole = Smooth({ ball.Surface, nullptr, &ball.Source }, Within(0.25),
    [&](double done)
    {
      EXPECT_GE(done, last - 1e-12);
      last = done;
      return true;
    });
  EXPECT_FALSE(whole.IsAborted);
  EXPECT_LE(last, 1.0);
}
