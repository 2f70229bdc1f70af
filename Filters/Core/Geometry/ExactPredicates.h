// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ExactPredicates.h
 * @brief Exact signs of orientation determinants for points as they are stored.
 *
 *     filter:  the determinant in double precision, if it exceeds the bound of its rounding error
 *     exact:   otherwise, the sum of all products as an expansion (Expansion.h)
 *
 * Requires double precision, rounding to nearest, and no contraction. The signs are exact for
 * coordinates that are 0 or between 1e-70 and 1e90 in magnitude: their products neither overflow
 * nor underflow.
 *
 * J. R. Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric
 * predicates, 1997: expansions, and the bounds of the filters.
 */
#ifndef BoneDecimate_Core_Geometry_ExactPredicates_h
#define BoneDecimate_Core_Geometry_ExactPredicates_h

#include "Surface.h"

#include <cmath>

namespace bonedecimate
{
/// The plane through three points, counter-clockwise as seen from its positive side.
class OrientedPlane
{
public:
  OrientedPlane() = default;
  OrientedPlane(const Vector3& a, const Vector3& b, const Vector3& c)
    : A(a)
    , B(b)
    , C(c)
  {
    const Vector3 u = b - a;
    const Vector3 v = c - a;
    const Vector3 first(u[1] * v[2], u[2] * v[0], u[0] * v[1]);
    const Vector3 second(u[2] * v[1], u[0] * v[2], u[1] * v[0]);
    this->Normal = first - second;
    this->Magnitude = FilterBound * (first.cwiseAbs() + second.cwiseAbs());
  }

  /// The sign of (b - a) x (c - a) . (p - a): 1 on the positive side, -1 on the other, 0 in the
  /// plane. 0 for every p if the three points lie on a line.
  int SideOf(const Vector3& p) const
  {
    const Vector3 w = p - this->A;
    const double height = this->Normal[0] * w[0] + this->Normal[1] * w[1] + this->Normal[2] * w[2];
    const double bound = this->Magnitude[0] * std::abs(w[0]) + this->Magnitude[1] * std::abs(w[1]) +
      this->Magnitude[2] * std::abs(w[2]);
    return height > bound ? 1 : height < -bound ? -1 : bound == 0.0 ? 0 : this->ExactSideOf(p);
  }

private:
  /// Shewchuk's (7 + 56 u) u with u = 2^-53, enlarged for the rounding of the bound itself.
  static constexpr double FilterBound = 8.0e-16;

  int ExactSideOf(const Vector3& p) const;

  Vector3 A = Vector3::Zero(), B = Vector3::Zero(), C = Vector3::Zero(); // mm
  Vector3 Normal = Vector3::Zero();                                      // mm^2, rounded
  Vector3 Magnitude = Vector3::Zero(); // mm^2, rounding error per mm along an axis
};

/// The sign of (b - a) x (c - a) . (d - a).
inline int Orientation(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  return OrientedPlane(a, b, c).SideOf(d);
}

/// The sign of the area of the triangle a b c after projection along an axis: the sign of that
/// coordinate of (b - a) x (c - a).
/// @param axis 0, 1 or 2.
int ProjectedOrientation(const Vector3& a, const Vector3& b, const Vector3& c, Eigen::Index axis);
}

#endif
