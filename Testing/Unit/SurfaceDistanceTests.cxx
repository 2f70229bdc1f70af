// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Parallel.h"
#include "BruteForce.h"
#include "Mesh/Cleaning.h"
#include "Proof/Measure/SurfaceDistance.h"
#include "Random.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
bool GoOn(double)
{
  return true;
}

DistanceStatistics Measure(
  const Surface& from, const Surface& to, std::int64_t samples = 20000, int threads = 1)
{
  const BoundingTree tree(to);
  return MeasureDistance(
    from, PointDistances(from.Points, tree, threads, GoOn), tree, samples, threads, GoOn);
}

/// A rectangle of 10 x 1 mm in strips that get wider, so that triangles differ in area by a hundred
/// times.
Surface UnevenStrip()
{
  Surface strip = Grid(10);
  for (Vector3& p : strip.Points)
  {
    p = { p.x() * p.x() / 10.0, p.y() / 10.0, 0.0 };
  }
  return strip;
}
}

TEST(SurfaceDistance, ParallelPlatesHalfAMillimeterApart)
{
  const DistanceStatistics found = Measure(Grid(10), Moved(Grid(10), { 0, 0, 0.5 }));
  for (const double value : { found.Maximum, found.Second, found.Mean, found.RootMeanSquare,
         found.PointMaximum, found.PointMean, found.PointRootMeanSquare })
  {
    EXPECT_NEAR(value, 0.5, 1e-14);
  }
  EXPECT_EQ(found.Samples, 20000);
  EXPECT_NEAR(found.SamplesPerSquareMillimeter, 200.0, 1e-9);
}

TEST(SurfaceDistance, ConcentricSpheresAreTheirRadiiApart)
{
  const DistanceStatistics found = Measure(Icosphere(4, 10.0), Icosphere(4, 12.0));
  EXPECT_NEAR(found.Mean, 2.0, 0.02);
  EXPECT_NEAR(found.RootMeanSquare, 2.0, 0.02);
  EXPECT_NEAR(found.Maximum, 2.0, 0.04);
}

TEST(SurfaceDistance, OfASurfaceToItselfIsNothing)
{
  for (const NamedSurface& shape : AllShapes())
  {
    const Surface surface = Clean(shape.Surface, true).Surface; // without unused points
    const DistanceStatistics found = Measure(surface, surface, 500);
    EXPECT_LT(found.PointMaximum, 1e-12) << shape.Name;
    EXPECT_LT(found.Maximum, 1e-11) << shape.Name;
  }
}

TEST(SurfaceDistance, MeanIsTakenOverAreaAndNotOverTrianglesOrPoints)
{
  // Over the strip the distance to the plane z = x / 10, seen vertically from below, is x /
  // sqrt(101) for x from 0 to 10: mean 5 / sqrt(101), RMS 10 / sqrt(3 * 101).
  Surface slope = { { { -50, -50, -5 }, { 50, -50, 5 }, { 50, 50, 5 }, { -50, 50, -5 } },
    { { 0, 1, 2 }, { 0, 2, 3 } } };
  const DistanceStatistics found = Measure(UnevenStrip(), slope, 50000);
  EXPECT_NEAR(found.Mean, 5.0 / std::sqrt(101.0), 1e-3);
  EXPECT_NEAR(found.RootMeanSquare, 10.0 / std::sqrt(303.0), 1e-3);
  EXPECT_NEAR(found.PointMaximum, 10.0 / std::sqrt(101.0), 1e-12);
  EXPECT_LT(found.PointMean, 0.8 * found.Mean) << "there are more points where the strip is near";
}

TEST(SurfaceDistance, PointDistancesVsBruteForce)
{
  Random random(1);
  const Surface to = BumpySphere(2, 5.0, 0.2, 3);
  const BoundingTree tree(to);
  std::vector<Vector3> points;
  for (int i = 0; i < 500; ++i)
  {
    points.push_back(random.InCube(9));
  }
  const std::vector<double> found = PointDistances(points, tree, 2, GoOn);
  ASSERT_EQ(found.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_NEAR(found[i], BruteNearest(to, points[i]).Distance, 1e-13 * 10.0);
  }
}

TEST(SurfaceDistance, StatisticsVsBruteForceSamples)
{
  const Surface from = BumpySphere(1, 5.0, 0.3, 3);
  const Surface to = Torus(16, 8);
  Random random(2);
  double sum = 0.0;
  double squares = 0.0;
  double weight = 0.0;
  double greatest = 0.0;
  for (const Triangle& t : from.Triangles)
  {
    const Vector3& a = from.Points[t[0]];
    const Vector3 ab = from.Points[t[1]] - a;
    const Vector3 ac = from.Points[t[2]] - a;
    for (int i = 0; i < 100; ++i)
    {
      const double root = std::sqrt(random.Uniform());
      const double v = random.Uniform();
      const double distance = BruteNearest(to, a + root * (1.0 - v) * ab + root * v * ac).Distance;
      sum += distance * ab.cross(ac).norm();
      squares += distance * distance * ab.cross(ac).norm();
      weight += ab.cross(ac).norm();
      greatest = std::max(greatest, distance);
    }
  }
  const DistanceStatistics found = Measure(from, to);
  EXPECT_NEAR(found.Mean, sum / weight, 0.01 * found.Mean);
  EXPECT_NEAR(found.RootMeanSquare, std::sqrt(squares / weight), 0.01 * found.RootMeanSquare);
  EXPECT_NEAR(found.Maximum, greatest, 0.05 * greatest);
  EXPECT_GE(found.Maximum, found.PointMaximum);
}

TEST(SurfaceDistance, SecondIsTheLargestButOneOfThePoints)
{
  Surface spikes = Grid(4);
  spikes.Points[6].z() = 3.0;
  spikes.Points[12].z() = -2.0;
  spikes.Points[18].z() = 1.0;
  const DistanceStatistics found = Measure(spikes, Grid(4));
  EXPECT_EQ(found.PointMaximum, 3.0);
  EXPECT_EQ(found.Second, 2.0);
  spikes.Points[12].z() = 3.0;
  EXPECT_EQ(Measure(spikes, Grid(4)).Second, 3.0) << "two equal ones are first and second";
}

TEST(SurfaceDistance, IsTheSameWhateverTheThreads)
{
  const Surface from = BumpySphere(3, 5.0, 0.2, 3);
  const Surface to = Icosphere(2, 5.0);
  const DistanceStatistics one = Measure(from, to, 30000, 1);
  for (const int threads : { 2, 4, 7 })
  {
    const DistanceStatistics many = Measure(from, to, 30000, threads);
    EXPECT_EQ(many.Mean, one.Mean);
    EXPECT_EQ(many.RootMeanSquare, one.RootMeanSquare);
    EXPECT_EQ(many.Maximum, one.Maximum);
    EXPECT_EQ(many.PointRootMeanSquare, one.PointRootMeanSquare);
  }
}

TEST(SurfaceDistance, StopsOnAbort)
{
  const Surface surface = Icosphere(3, 5.0);
  const BoundingTree tree(surface);
  const Monitor stop = [](double) { return false; };
  EXPECT_TRUE(PointDistances(surface.Points, tree, 1, stop).empty());
  const std::vector<double> zeros(surface.Points.size(), 0.0);
  EXPECT_EQ(MeasureDistance(surface, zeros, tree, 20000, 1, stop).Samples, 0);
}

TEST(SurfaceDistance, SurfacesWithoutAreaHaveNoSamples)
{
  const Surface flat = { { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } }, { { 0, 1, 2 } } };
  const DistanceStatistics found = Measure(flat, Moved(Grid(3), { 0, 0, 1 }));
  EXPECT_EQ(found.Samples, 0);
  EXPECT_NEAR(found.Maximum, 1.0, 1e-15);
  EXPECT_EQ(found.Mean, 0.0);
}

TEST(SurfaceDistance, NumberOfSamplesGrowsWithTheSurfaceWithinItsBounds)
{
  EXPECT_EQ(NumberOfSamples(0), 200000);
  EXPECT_EQ(NumberOfSamples(300000), 600000);
  EXPECT_EQ(NumberOfSamples(700000000), 1000000);
}

TEST(Parallel, EveryPieceIsDoneExactlyOnce)
{
  for (const std::size_t count : { 0, 1, 511, 512, 100003, 1000000 })
  {
    for (const int threads : { 0, 1, 2, 5 })
    {
      std::vector<int> done(count, 0);
      double fraction = 0.0;
      const auto record = [&fraction](double now)
      {
        EXPECT_GE(now, fraction);
        fraction = now;
        return true;
      };
      EXPECT_TRUE(ForEachChunk(count, threads, record,
        [&](std::size_t chunk, std::size_t first, std::size_t last)
        {
          EXPECT_EQ(first, chunk * ChunkSize(count));
          for (std::size_t i = first; i < last; ++i)
          {
            ++done[i];
          }
        }));
      EXPECT_EQ(done, std::vector<int>(count, 1));
      EXPECT_EQ(fraction, count > 0 ? 1.0 : 0.0); // also if a helper thread took the last chunk
    }
  }
}

TEST(Parallel, AnExceptionOfAnyThreadArrives)
{
  for (const int threads : { 1, 4 })
  {
    const auto work = [](std::size_t chunk, std::size_t, std::size_t)
    {
      if (chunk == 7)
      {
        throw std::runtime_error("chunk 7");
      }
    };
    EXPECT_THROW(ForEachChunk(5000, threads, GoOn, work), std::runtime_error);
  }
}
