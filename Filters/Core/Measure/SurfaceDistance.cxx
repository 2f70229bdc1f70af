// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceDistance.h"

#include "Parallel.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
// 1/g and 1/g^2 of the plastic number g = 1.3247..., the root of g^3 = g + 1.
constexpr double FirstStep = 0.7548776662466927;
constexpr double SecondStep = 0.5698402909980532;

struct Sum
{
  double Distance = 0.0;        // mm
  double SquaredDistance = 0.0; // mm^2
  double Maximum = 0.0;         // mm

  void Add(double squaredDistance)
  {
    const double distance = std::sqrt(squaredDistance);
    this->Distance += distance;
    this->SquaredDistance += squaredDistance;
    this->Maximum = std::max(this->Maximum, distance);
  }
  void Add(const Sum& other)
  {
    this->Distance += other.Distance;
    this->SquaredDistance += other.SquaredDistance;
    this->Maximum = std::max(this->Maximum, other.Maximum);
  }
};

double Fraction(double value)
{
  return value - std::floor(value);
}

Vector3 SampleIn(const Surface& surface, const Triangle& corners, double number)
{
  double u = Fraction(0.5 + number * FirstStep);
  double v = Fraction(0.5 + number * SecondStep);
  if (u + v > 1.0)
  {
    u = 1.0 - u;
    v = 1.0 - v;
  }
  const Vector3& a = surface.Points[corners[0]];
  return a + u * (surface.Points[corners[1]] - a) + v * (surface.Points[corners[2]] - a);
}

/// Area up to and including each triangle, mm^2.
std::vector<double> RunningAreas(const Surface& surface)
{
  std::vector<double> areas;
  areas.reserve(surface.Triangles.size());
  double sum = 0.0;
  for (const Triangle& c : surface.Triangles)
  {
    sum += AreaVector(surface.Points[c[0]], surface.Points[c[1]], surface.Points[c[2]]).norm();
    areas.push_back(sum);
  }
  return areas;
}

void DescribePoints(const std::vector<double>& distances, DistanceStatistics& statistics)
{
  double sum = 0.0;
  double squares = 0.0;
  for (const double distance : distances)
  {
    sum += distance;
    squares += distance * distance;
    if (distance > statistics.PointMaximum)
    {
      statistics.Second = statistics.PointMaximum;
      statistics.PointMaximum = distance;
    }
    else
    {
      statistics.Second = std::max(statistics.Second, distance);
    }
  }
  const double count = static_cast<double>(std::max<std::size_t>(1, distances.size()));
  statistics.PointMean = sum / count;
  statistics.PointRootMeanSquare = std::sqrt(squares / count);
  statistics.Maximum = statistics.PointMaximum;
}
}

std::int64_t NumberOfSamples(std::size_t triangles)
{
  return std::clamp<std::int64_t>(2 * static_cast<std::int64_t>(triangles), 200000, 1000000);
}

std::vector<double> PointDistances(
  const std::vector<Vector3>& points, const BoundingTree& to, int threads, const Monitor& monitor)
{
  std::vector<double> distances(points.size(), 0.0);
  const bool done = ForEachChunk(points.size(), threads, monitor,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      Index hint = None;
      for (std::size_t p = first; p < last; ++p)
      {
        const BoundingTree::Nearest nearest = to.FindNearest(points[p], hint);
        distances[p] = std::sqrt(nearest.Point.SquaredDistance);
        hint = nearest.Triangle;
      }
    });
  return done ? distances : std::vector<double>();
}

DistanceStatistics MeasureDistance(const Surface& from, const std::vector<double>& pointDistances,
  const BoundingTree& to, std::int64_t samples, int threads, const Monitor& monitor)
{
  DistanceStatistics statistics;
  DescribePoints(pointDistances, statistics);
  const std::vector<double> areas = RunningAreas(from);
  const double area = areas.empty() ? 0.0 : areas.back();
  const std::size_t count = area > 0.0 ? static_cast<std::size_t>(samples) : 0;
  std::vector<Sum> sums(NumberOfChunks(count));
  const bool done = ForEachChunk(count, threads, monitor,
    [&](std::size_t chunk, std::size_t first, std::size_t last)
    {
      const auto areaOf = [&](std::size_t i)
      { return (static_cast<double>(i) + 0.5) / static_cast<double>(count) * area; };
      auto at = std::lower_bound(areas.begin(), areas.end(), areaOf(first));
      Index hint = None;
      for (std::size_t i = first; i < last; ++i)
      {
        at = std::find_if(at, areas.end() - 1, [&](double passed) { return passed >= areaOf(i); });
        const Triangle& corners = from.Triangles[static_cast<std::size_t>(at - areas.begin())];
        const BoundingTree::Nearest nearest =
          to.FindNearest(SampleIn(from, corners, static_cast<double>(i)), hint);
        sums[chunk].Add(nearest.Point.SquaredDistance);
        hint = nearest.Triangle;
      }
    });
  if (!done || count == 0)
  {
    return statistics;
  }
  Sum sum;
  for (const Sum& part : sums)
  {
    sum.Add(part);
  }
  statistics.Samples = static_cast<std::int64_t>(count);
  statistics.SamplesPerSquareMillimeter = static_cast<double>(count) / area;
  statistics.Mean = sum.Distance / static_cast<double>(count);
  statistics.RootMeanSquare = std::sqrt(sum.SquaredDistance / static_cast<double>(count));
  statistics.Maximum = std::max(statistics.Maximum, sum.Maximum);
  return statistics;
}
}
