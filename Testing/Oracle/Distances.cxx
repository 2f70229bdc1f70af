// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Uses CGAL's AABB tree (GPL-3.0-or-later), which makes the program built from it GPL: a tool of
// the tests, never installed.
#include "Distances.h"

#include <CGAL/AABB_tree.h>
#include <CGAL/version.h>
// CGAL 6 has new names for what is in space.
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <thread>

namespace
{
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Facets = std::vector<Kernel::Triangle_3>;
#if CGAL_VERSION_NR >= 1060000000
using Primitive = CGAL::AABB_triangle_primitive_3<Kernel, Facets::const_iterator>;
using Traits = CGAL::AABB_traits_3<Kernel, Primitive>;
#else
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Facets::const_iterator>;
using Traits = CGAL::AABB_traits<Kernel, Primitive>;
#endif
using Tree = CGAL::AABB_tree<Traits>;

Point ToPoint(const std::array<double, 3>& x)
{
  return { x[0], x[1], x[2] };
}

Facets ToFacets(const Triangles& triangles)
{
  Facets facets;
  for (const auto& corners : triangles.Corners)
  {
    facets.emplace_back(ToPoint(triangles.Points[static_cast<std::size_t>(corners[0])]),
      ToPoint(triangles.Points[static_cast<std::size_t>(corners[1])]),
      ToPoint(triangles.Points[static_cast<std::size_t>(corners[2])]));
  }
  return facets;
}

/// From 0 to 1, the same on every system (splitmix64 of the number).
double Uniform(std::uint64_t number)
{
  std::uint64_t z = (number + 1) * 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
  return static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1.0p-53;
}

Point PointIn(const Kernel::Triangle_3& facet, double p, double q)
{
  if (p + q > 1.0)
  {
    p = 1.0 - p;
    q = 1.0 - q;
  }
  return facet.vertex(0) + p * (facet.vertex(1) - facet.vertex(0)) +
    q * (facet.vertex(2) - facet.vertex(0));
}

std::vector<Point> AreaSamples(const Facets& facets, std::size_t samples)
{
  std::vector<double> areaUpTo;
  double area = 0.0;
  for (const auto& facet : facets)
  {
    area += std::sqrt(facet.squared_area());
    areaUpTo.push_back(area);
  }
  std::vector<Point> points;
  std::size_t facet = 0;
  for (std::size_t i = 0; i < samples; ++i)
  {
    const double at =
      (static_cast<double>(i) + Uniform(3 * i)) / static_cast<double>(samples) * area;
    while (facet + 1 < facets.size() && areaUpTo[facet] < at)
    {
      ++facet;
    }
    points.push_back(PointIn(facets[facet], Uniform(3 * i + 1), Uniform(3 * i + 2)));
  }
  return points;
}

std::vector<Point> UsedPoints(const Triangles& triangles)
{
  std::vector<char> isUsed(triangles.Points.size(), 0);
  for (const auto& corners : triangles.Corners)
  {
    for (const std::int32_t corner : corners)
    {
      isUsed[static_cast<std::size_t>(corner)] = 1;
    }
  }
  std::vector<Point> points;
  for (std::size_t p = 0; p < isUsed.size(); ++p)
  {
    if (isUsed[p] != 0)
    {
      points.push_back(ToPoint(triangles.Points[p]));
    }
  }
  return points;
}

std::vector<double> DistancesTo(
  const Tree& tree, const std::vector<Point>& points, unsigned threads)
{
  std::vector<double> distances(points.size());
  const auto work = [&](std::size_t first)
  {
    for (std::size_t i = first; i < points.size(); i += threads)
    {
      distances[i] = std::sqrt(tree.squared_distance(points[i]));
    }
  };
  std::vector<std::thread> others;
  for (unsigned t = 1; t < threads; ++t)
  {
    others.emplace_back(work, t);
  }
  work(0);
  for (auto& other : others)
  {
    other.join();
  }
  return distances;
}

void Average(const std::vector<double>& values, double& average, double& rootMeanSquare)
{
  double sum = 0.0;
  double squares = 0.0;
  for (const double value : values)
  {
    sum += value;
    squares += value * value;
  }
  const auto count = static_cast<double>(values.size());
  average = sum / count;
  rootMeanSquare = std::sqrt(squares / count);
}
}

Distances MeasureDistances(
  const Triangles& from, const Triangles& to, std::size_t samples, unsigned threads)
{
  Distances result;
  const Facets there = ToFacets(to);
  const Facets here = ToFacets(from);
  if (there.empty() || here.empty())
  {
    return result;
  }
  Tree tree(there.begin(), there.end());
  tree.accelerate_distance_queries();
  std::vector<double> points = DistancesTo(tree, UsedPoints(from), threads);
  std::vector<double> area = DistancesTo(tree, AreaSamples(here, samples), threads);
  Average(points, result.PointAverage, result.PointRootMeanSquare);
  Average(area, result.Average, result.RootMeanSquare);
  std::sort(points.begin(), points.end());
  std::sort(area.begin(), area.end());
  result.PointMaximum = points.back();
  result.PointSecond = points[points.size() - std::min<std::size_t>(2, points.size())];
  result.Maximum = std::max(points.back(), area.back());
  for (std::size_t percent = 0; percent <= 100; ++percent)
  {
    result.Percentiles.push_back(area[percent * (area.size() - 1) / 100]);
  }
  return result;
}
