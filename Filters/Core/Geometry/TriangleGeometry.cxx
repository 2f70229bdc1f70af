// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleGeometry.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
using Corners = std::array<const Vector3*, 3>;

/// Narrower than 1e-12 of its length, a triangle's normal is rounding and its boundary is near
/// enough.
constexpr double LeastSquaredSine = 1e-24;

TrianglePlace PlaceAt(
  const Vector3& p, const Corners& corners, const std::array<double, 3>& weights)
{
  TrianglePlace place;
  place.Weights = weights;
  place.Position = weights[0] * *corners[0] + weights[1] * *corners[1] + weights[2] * *corners[2];
  place.SquaredDistance = (p - place.Position).squaredNorm();
  return place;
}

/// On the edge from corner i to the next one.
TrianglePlace PlaceOnEdge(const Vector3& p, const Corners& corners, std::size_t i)
{
  const std::size_t j = (i + 1) % 3;
  std::array<double, 3> weights = { 0.0, 0.0, 0.0 };
  weights[j] = NearestFraction(p, *corners[i], *corners[j]);
  weights[i] = 1.0 - weights[j];
  return PlaceAt(p, corners, weights);
}

/// For triangles without a plane: the best of the three edges.
TrianglePlace PlaceOnBoundary(const Vector3& p, const Corners& corners)
{
  TrianglePlace best = PlaceOnEdge(p, corners, 0);
  for (std::size_t i = 1; i < 3; ++i)
  {
    const TrianglePlace place = PlaceOnEdge(p, corners, i);
    if (place.SquaredDistance < best.SquaredDistance)
    {
      best = place;
    }
  }
  return best;
}
}

double NearestFraction(const Vector3& p, const Vector3& a, const Vector3& b)
{
  const Vector3 edge = b - a;
  const double squaredLength = edge.squaredNorm();
  return squaredLength > 0.0 ? std::clamp(edge.dot(p - a) / squaredLength, 0.0, 1.0) : 0.0;
}

TrianglePlace NearestOnTriangle(
  const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c)
{
  const Corners corners = { &a, &b, &c };
  const Vector3 ab = b - a;
  const Vector3 ac = c - a;
  const Vector3 ap = p - a;
  const double d1 = ab.dot(ap);
  const double d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0)
  {
    return PlaceAt(p, corners, { 1.0, 0.0, 0.0 });
  }
  const Vector3 bp = p - b;
  const double d3 = ab.dot(bp);
  const double d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3)
  {
    return PlaceAt(p, corners, { 0.0, 1.0, 0.0 });
  }
  const Vector3 cp = p - c;
  const double d5 = ab.dot(cp);
  const double d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6)
  {
    return PlaceAt(p, corners, { 0.0, 0.0, 1.0 });
  }
  // By cross products, since differences of products of dot products lose twice as many digits in a
  // needle.
  const Vector3 normal = ab.cross(ac);
  const double overC = normal.dot(ab.cross(ap));
  const double overB = normal.dot(ap.cross(ac));
  const double overA = normal.dot(bp.cross(cp));
  const double sum = normal.squaredNorm();
  const bool hasPlane = sum > LeastSquaredSine * ab.squaredNorm() * ac.squaredNorm();
  if (hasPlane && overA > 0.0 && overB > 0.0 && overC > 0.0)
  {
    return PlaceAt(p, corners, { 1.0 - (overB + overC) / sum, overB / sum, overC / sum });
  }
  return PlaceOnBoundary(p, corners);
}
}
