// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleGeometry.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
using Corners = std::array<const Vector3*, 3>;

/// The normal of a triangle narrower than 1e-12 of its length is rounding error: then the edges
/// alone are used.
constexpr double MinSquaredSine = 1e-24;

PointOnTriangle PointAt(
  const Vector3& p, const Corners& corners, const std::array<double, 3>& weights)
{
  PointOnTriangle point;
  point.Weights = weights;
  point.Position = weights[0] * *corners[0] + weights[1] * *corners[1] + weights[2] * *corners[2];
  point.SquaredDistance = (p - point.Position).squaredNorm();
  return point;
}

/// The nearest point on the edge from corner i to the next one.
PointOnTriangle PositionOnEdge(const Vector3& p, const Corners& corners, std::size_t i)
{
  const std::size_t j = (i + 1) % 3;
  std::array<double, 3> weights = { 0.0, 0.0, 0.0 };
  weights[j] = NearestFraction(p, *corners[i], *corners[j]);
  weights[i] = 1.0 - weights[j];
  return PointAt(p, corners, weights);
}

/// For triangles without a plane: the nearest point of the three edges.
PointOnTriangle PointOnBoundary(const Vector3& p, const Corners& corners)
{
  PointOnTriangle best = PositionOnEdge(p, corners, 0);
  for (std::size_t i = 1; i < 3; ++i)
  {
    const PointOnTriangle point = PositionOnEdge(p, corners, i);
    if (point.SquaredDistance < best.SquaredDistance)
    {
      best = point;
    }
  }
  return best;
}
}

std::vector<Vector3> AreaNormals(
  const std::vector<Vector3>& points, const std::vector<Triangle>& triangles)
{
  std::vector<Vector3> normals(points.size(), Vector3::Zero());
  for (const Triangle& c : triangles)
  {
    const Vector3 area = AreaVector(points[c[0]], points[c[1]], points[c[2]]);
    for (const Index corner : c)
    {
      normals[corner] += area;
    }
  }
  return normals;
}

double NearestFraction(const Vector3& p, const Vector3& a, const Vector3& b)
{
  const Vector3 edge = b - a;
  const double squaredLength = edge.squaredNorm();
  return squaredLength > 0.0 ? std::clamp(Dot(edge, p - a) / squaredLength, 0.0, 1.0) : 0.0;
}

PointOnTriangle NearestOnTriangle(
  const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c)
{
  const Corners corners = { &a, &b, &c };
  const Vector3 ab = b - a;
  const Vector3 ac = c - a;
  const Vector3 ap = p - a;
  const double d1 = Dot(ab, ap);
  const double d2 = Dot(ac, ap);
  if (d1 <= 0.0 && d2 <= 0.0)
  {
    return PointAt(p, corners, { 1.0, 0.0, 0.0 });
  }
  const Vector3 bp = p - b;
  const double d3 = Dot(ab, bp);
  const double d4 = Dot(ac, bp);
  if (d3 >= 0.0 && d4 <= d3)
  {
    return PointAt(p, corners, { 0.0, 1.0, 0.0 });
  }
  const Vector3 cp = p - c;
  const double d5 = Dot(ab, cp);
  const double d6 = Dot(ac, cp);
  if (d6 >= 0.0 && d5 <= d6)
  {
    return PointAt(p, corners, { 0.0, 0.0, 1.0 });
  }
  // Cross products: differences of products of dot products lose twice as many digits in a needle.
  const Vector3 normal = ab.cross(ac);
  const double overC = Dot(normal, ab.cross(ap));
  const double overB = Dot(normal, ap.cross(ac));
  const double overA = Dot(normal, bp.cross(cp));
  const double sum = normal.squaredNorm();
  const bool hasPlane = sum > MinSquaredSine * ab.squaredNorm() * ac.squaredNorm();
  if (hasPlane && overA > 0.0 && overB > 0.0 && overC > 0.0)
  {
    return PointAt(p, corners, { 1.0 - (overB + overC) / sum, overB / sum, overC / sum });
  }
  return PointOnBoundary(p, corners);
}
}
