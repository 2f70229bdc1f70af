// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SmallestAngle.h
 * @brief The smallest angle of a triangle, as its cosine: 0.5 for an equilateral triangle, 1 for
 * one without area.
 */
#ifndef BoneDecimate_Core_Geometry_SmallestAngle_h
#define BoneDecimate_Core_Geometry_SmallestAngle_h

#include "Surface.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bonedecimate
{
/// Squares of the sides, mm^2, ascending.
inline std::array<double, 3> SortedSquares(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const double sides[3] = { (b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm() };
  const double lower = std::min(sides[0], sides[1]);
  const double upper = std::max(sides[0], sides[1]);
  return { std::min(lower, sides[2]), std::max(lower, std::min(upper, sides[2])),
    std::max(upper, sides[2]) };
}

/// By the law of cosines: the smallest angle lies opposite the shortest side.
inline double CosineOfSmallestAngle(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const auto [shortest, middle, longest] = SortedSquares(a, b, c);
  return shortest > 0.0 ? (middle + longest - shortest) / (2.0 * std::sqrt(middle * longest)) : 1.0;
}

/// The cosine of an angle from 0 to 90 degrees, with the same bits on every system.
inline double CosineOfDegrees(double degrees)
{
  constexpr double radiansPerDegree = 0.017453292519943295;
  const double square = degrees * radiansPerDegree * degrees * radiansPerDegree;
  double sum = 1.0;
  for (int k = 20; k > 0; k -= 2)
  {
    sum = 1.0 - square * sum / (k * (k - 1));
  }
  return sum;
}
}

#endif
