// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleGeometry.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
using Corners = std::array<const Vector3*, 3>;

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
  // Twice the signed areas of p's projection with the edges: negative means outside of that edge.
  const double overC = d1 * d4 - d3 * d2;
  const double overB = d5 * d2 - d1 * d6;
  const double overA = d3 * d6 - d5 * d4;
  const double sum = overA + overB + overC;
  if (overA > 0.0 && overB > 0.0 && overC > 0.0 && sum > 0.0)
  {
    return PlaceAt(p, corners, { 1.0 - (overB + overC) / sum, overB / sum, overC / sum });
  }
  return PlaceOnBoundary(p, corners);
}
}
