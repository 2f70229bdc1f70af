// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Angle.h
 * @brief The angle between two directions, with the same bits on every system: no function of libm
 * is called except sqrt.
 */
#ifndef BoneDecimate_Core_Geometry_Angle_h
#define BoneDecimate_Core_Geometry_Angle_h

#include "Surface.h"

#include <cmath>

namespace bonedecimate
{
constexpr double DegreesPerRadian = 57.29577951308232;

/// Radians, 0 to pi; 0 if a vector has no length. The lengths of both must be of the same order of
/// magnitude.
inline double AngleBetween(const Vector3& a, const Vector3& b)
{
  const Vector3 u = a / std::sqrt(a.squaredNorm() > 0.0 ? a.squaredNorm() : 1.0);
  const Vector3 v = b / std::sqrt(b.squaredNorm() > 0.0 ? b.squaredNorm() : 1.0);
  // Sine and cosine of half the angle. Halving three more times brings the tangent below 0.2.
  double sine = 0.5 * std::sqrt((u - v).squaredNorm());
  double cosine = 0.5 * std::sqrt((u + v).squaredNorm());
  for (int i = 0; i < 3; ++i)
  {
    const double length = std::sqrt(sine * sine + cosine * cosine);
    cosine += length;
    const double half = std::sqrt(sine * sine + cosine * cosine);
    if (half == 0.0)
    {
      return 0.0;
    }
    sine /= half;
    cosine /= half;
  }
  const double t = sine / cosine;
  const double square = t * t;
  double sum = 0.0;
  for (int power = 21; power > 0; power -= 2)
  {
    sum = 1.0 / power - square * sum;
  }
  return 16.0 * t * sum;
}
}

#endif
