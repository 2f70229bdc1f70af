// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleShapes.h"

#include "Base/Parallel.h"
#include "Geometry/Angle.h"
#include "Geometry/SmallestAngle.h"
#include "Geometry/TriangleGeometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace bonedecimate
{
namespace
{
/// Cosines of 10, 20, ... 60 degrees, where the bins of the histogram end.
constexpr std::array<double, 6> EndsOfBins = { 0.984807753012208, 0.9396926207859084,
  0.8660254037844387, 0.766044443118978, 0.6427876096865394, 0.0 };

/// Holds cosines until all triangles have been read.
struct Shapes
{
  std::array<std::int64_t, 6> Bins{};
  double MaxCosine = -1.0;  // of smallest angles
  double MinCosine = 1.0;   // of largest angles
  double RadiusRatio = 0.0; // sums
  double AspectRatio = 0.0;
  double WorstRadiusRatio = 0.0;
  double WorstAspectRatio = 0.0;
  std::int64_t WithArea = 0;

  Shapes& operator+=(const Shapes& other)
  {
    for (std::size_t i = 0; i < this->Bins.size(); ++i)
    {
      this->Bins[i] += other.Bins[i];
    }
    this->MaxCosine = std::max(this->MaxCosine, other.MaxCosine);
    this->MinCosine = std::min(this->MinCosine, other.MinCosine);
    this->RadiusRatio += other.RadiusRatio;
    this->AspectRatio += other.AspectRatio;
    this->WorstRadiusRatio = std::max(this->WorstRadiusRatio, other.WorstRadiusRatio);
    this->WorstAspectRatio = std::max(this->WorstAspectRatio, other.WorstAspectRatio);
    this->WithArea += other.WithArea;
    return *this;
  }
};

void Add(const Vector3& a, const Vector3& b, const Vector3& c, Shapes& shapes)
{
  const double cosine = CosineOfSmallestAngle(a, b, c);
  std::size_t bin = 0; // without branches, which would be mispredicted
  for (std::size_t i = 0; i + 1 < EndsOfBins.size(); ++i)
  {
    bin += cosine > EndsOfBins[i] ? 0 : 1;
  }
  ++shapes.Bins[bin];
  shapes.MaxCosine = std::max(shapes.MaxCosine, cosine);
  const double area = AreaVector(a, b, c).norm();
  if (!(area > 0.0))
  {
    return;
  }
  const std::array<double, 3> squares = SortedSquares(a, b, c);
  const double shortest = std::sqrt(squares[0]);
  const double middle = std::sqrt(squares[1]);
  const double longest = std::sqrt(squares[2]);
  shapes.MinCosine =
    std::min(shapes.MinCosine, (squares[0] + squares[1] - squares[2]) / (2.0 * shortest * middle));
  const double perimeter = shortest + middle + longest;
  const double radiusRatio = shortest * middle * longest * perimeter / (16.0 * area * area);
  const double aspectRatio = longest * perimeter / (4.0 * std::sqrt(3.0) * area);
  shapes.RadiusRatio += radiusRatio;
  shapes.AspectRatio += aspectRatio;
  shapes.WorstRadiusRatio = std::max(shapes.WorstRadiusRatio, radiusRatio);
  shapes.WorstAspectRatio = std::max(shapes.WorstAspectRatio, aspectRatio);
  ++shapes.WithArea;
}

double Degrees(double cosine)
{
  const double clamped = std::clamp(cosine, -1.0, 1.0);
  const Vector3 direction(clamped, std::sqrt(1.0 - clamped * clamped), 0.0);
  return DegreesPerRadian * AngleBetween(Vector3::UnitX(), direction);
}

std::int64_t CountOf(const ShapeStatistics& shapes)
{
  std::int64_t count = 0;
  for (const std::int64_t bin : shapes.MinAngles)
  {
    count += bin;
  }
  return count;
}

/// Each edge once, the lower end first.
std::vector<std::pair<Index, Index>> EdgesOf(const Surface& surface)
{
  std::vector<std::pair<Index, Index>> edges;
  for (const Triangle& v : surface.Triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      edges.push_back(std::minmax(v[k], v[(k + 1) % 3]));
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}
}

ShapeStatistics DescribeShapes(const Surface& surface, int threads)
{
  const Shapes shapes = SumOverBlocks(surface.Triangles.size(), threads,
    [&](std::size_t first, std::size_t last)
    {
      Shapes part;
      for (std::size_t t = first; t < last; ++t)
      {
        const Triangle& v = surface.Triangles[t];
        Add(surface.Points[v[0]], surface.Points[v[1]], surface.Points[v[2]], part);
      }
      return part;
    });
  ShapeStatistics statistics;
  statistics.MinAngles = shapes.Bins;
  if (shapes.WithArea > 0)
  {
    const double count = static_cast<double>(shapes.WithArea);
    statistics.SmallestAngle = Degrees(shapes.MaxCosine);
    statistics.MaxAngle = Degrees(shapes.MinCosine);
    statistics.MeanRadiusRatio = shapes.RadiusRatio / count;
    statistics.MaxRadiusRatio = shapes.WorstRadiusRatio;
    statistics.MeanAspectRatio = shapes.AspectRatio / count;
    statistics.MaxAspectRatio = shapes.WorstAspectRatio;
  }
  return statistics;
}

//------------------------------------------------------------------------------
void AddShapes(const ShapeStatistics& other, ShapeStatistics& sum)
{
  const double before = static_cast<double>(CountOf(sum));
  const double added = static_cast<double>(CountOf(other));
  if (added == 0.0 || before == 0.0)
  {
    sum = added > 0.0 ? other : sum;
    return;
  }
  const auto mean = [&](double a, double b) { return (before * a + added * b) / (before + added); };
  sum.SmallestAngle = std::min(sum.SmallestAngle, other.SmallestAngle);
  sum.MaxAngle = std::max(sum.MaxAngle, other.MaxAngle);
  sum.MeanRadiusRatio = mean(sum.MeanRadiusRatio, other.MeanRadiusRatio);
  sum.MaxRadiusRatio = std::max(sum.MaxRadiusRatio, other.MaxRadiusRatio);
  sum.MeanAspectRatio = mean(sum.MeanAspectRatio, other.MeanAspectRatio);
  sum.MaxAspectRatio = std::max(sum.MaxAspectRatio, other.MaxAspectRatio);
  for (std::size_t i = 0; i < sum.MinAngles.size(); ++i)
  {
    sum.MinAngles[i] += other.MinAngles[i];
  }
}

//------------------------------------------------------------------------------
AngleFigures FindBelowAngle(const Surface& surface, double degrees)
{
  AngleFigures found;
  double worst = CosineOfDegrees(degrees);
  const double limit = worst;
  for (const Triangle& v : surface.Triangles)
  {
    const Vector3& a = surface.Points[v[0]];
    const Vector3& b = surface.Points[v[1]];
    const Vector3& c = surface.Points[v[2]];
    const double cosine = CosineOfSmallestAngle(a, b, c);
    found.Below += cosine > limit ? 1 : 0;
    if (cosine > worst)
    {
      worst = cosine;
      found.Worst = (a + b + c) / 3.0;
    }
  }
  return found;
}

//------------------------------------------------------------------------------
EdgeFigures FindEdges(const Surface& surface, const ShapeLimits& limits, const Vector3& origin)
{
  constexpr double rounding = 1e-6; // of a length: the output may round positions
  const std::vector<std::pair<Index, Index>> edges = EdgesOf(surface);
  EdgeFigures found;
  double sum = 0.0;     // mm
  double longest = 0.0; // mm
  double worst = 0.0;   // of the length requested
  for (const auto& [from, to] : edges)
  {
    const Vector3& a = surface.Points[from];
    const Vector3& b = surface.Points[to];
    const double length = (b - a).norm();
    sum += length;
    const double requested = limits.RequestedLength(a - origin, b - origin);
    const bool isLonger = length > ShapeLimits::SplitRatio * requested * (1.0 + rounding);
    found.Longer += isLonger ? 1 : 0;
    found.Shorter += length < ShapeLimits::CollapseRatio * requested * (1.0 - rounding) ? 1 : 0;
    longest = std::max(longest, length);
    if (isLonger && length / requested > worst)
    {
      worst = length / requested;
      found.Worst = 0.5 * (a + b);
    }
  }
  if (!edges.empty())
  {
    found.Mean = sum / static_cast<double>(edges.size());
    found.Longest = longest;
    found.MinRequested = limits.MinSplitLength() / ShapeLimits::SplitRatio;
  }
  return found;
}
}
