// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "AccumulatedError.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
// With the order of additions of the vector kernels, which differs from Dot().
double DotFromLeft(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Squared distance of the origin to the segment from a along d.
double SquaredDistanceToSegment(const Vector3& a, const Vector3& d)
{
  const double squared = DotFromLeft(d, d);
  const double t = squared > 0.0 ? std::clamp((0.0 - DotFromLeft(a, d)) / squared, 0.0, 1.0) : 0.0;
  const Vector3 nearest = a + d * t;
  return DotFromLeft(nearest, nearest);
}

/// Squared distance of the origin to a triangle: to the plane over the face, or to the nearest
/// side.
double SquaredDistanceToTriangle(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const Vector3 n = (b - a).cross(c - a);
  const double square = DotFromLeft(n, n);
  const bool isOver = DotFromLeft(n, b.cross(c)) >= 0.0 && DotFromLeft(n, c.cross(a)) >= 0.0 &&
    DotFromLeft(n, a.cross(b)) >= 0.0;
  if (isOver && square > 0.0)
  {
    const double height = DotFromLeft(n, a);
    return height * height / square;
  }
  return std::min({ SquaredDistanceToSegment(a, b - a), SquaredDistanceToSegment(b, c - b),
    SquaredDistanceToSegment(c, a - c) });
}

double DistanceTo(const std::vector<CollapsedEdge::Corners>& triangles, const Vector3& p)
{
  double least = Infinity;
  for (const CollapsedEdge::Corners& t : triangles)
  {
    least = std::min(least, SquaredDistanceToTriangle(t[0] - p, t[1] - p, t[2] - p));
  }
  return std::sqrt(least);
}
}

double AccumulatedError(const CollapsedEdge& edge, double atStart, double atEnd)
{
  return std::max(
    { atStart + DistanceTo(edge.After, edge.Start), atEnd + DistanceTo(edge.After, edge.End),
      std::max(atStart, atEnd) + DistanceTo(edge.Before, edge.Merged) });
}
}
