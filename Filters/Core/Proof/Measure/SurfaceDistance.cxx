// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceDistance.h"

#include "AreaSamples.h"
#include "Base/Parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bonedecimate
{
namespace
{
std::array<double, 3> ToArray(const Vector3& p)
{
  return { p.x(), p.y(), p.z() };
}

struct Sum
{
  double Distance = 0.0;        // mm
  double SquaredDistance = 0.0; // mm^2
  double Maximum = 0.0;         // mm
  Vector3 At = Vector3::Zero(); // of the first sample with this distance

  void Add(double squaredDistance, const Vector3& sample)
  {
    const double distance = std::sqrt(squaredDistance);
    this->Distance += distance;
    this->SquaredDistance += squaredDistance;
    this->TakeMaximum(distance, sample);
  }
  void Add(const Sum& other)
  {
    this->Distance += other.Distance;
    this->SquaredDistance += other.SquaredDistance;
    this->TakeMaximum(other.Maximum, other.At);
  }
  void TakeMaximum(double distance, const Vector3& at)
  {
    if (distance > this->Maximum)
    {
      this->Maximum = distance;
      this->At = at;
    }
  }
};

void DescribePoints(const std::vector<Vector3>& points, const std::vector<double>& distances,
  DistanceStatistics& statistics)
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
  if (!distances.empty())
  {
    const auto largest = std::max_element(distances.begin(), distances.end());
    statistics.MaximumAt = ToArray(points[static_cast<std::size_t>(largest - distances.begin())]);
  }
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
  DescribePoints(from.Points, pointDistances, statistics);
  const AreaSamples placed(from.Points, from.Triangles, static_cast<std::size_t>(samples));
  const std::size_t count = placed.Count();
  std::vector<Sum> sums(NumberOfChunks(count));
  const bool done = ForEachChunk(count, threads, monitor,
    [&](std::size_t chunk, std::size_t first, std::size_t last)
    {
      Index hint = None;
      placed.Visit(first, last,
        [&](std::size_t, std::size_t, const Vector3& sample)
        {
          const BoundingTree::Nearest nearest = to.FindNearest(sample, hint);
          sums[chunk].Add(nearest.Point.SquaredDistance, sample);
          hint = nearest.Triangle;
        });
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
  statistics.SamplesPerSquareMillimeter = static_cast<double>(count) / placed.Area();
  statistics.Mean = sum.Distance / static_cast<double>(count);
  statistics.RootMeanSquare = std::sqrt(sum.SquaredDistance / static_cast<double>(count));
  if (sum.Maximum > statistics.Maximum)
  {
    statistics.Maximum = sum.Maximum;
    statistics.MaximumAt = ToArray(sum.At);
  }
  return statistics;
}
}
