// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TriangleFrame.h
 * @brief A triangle prepared for many nearest-point queries.
 *
 * If a point projects outside of the triangle, its nearest point lies on an edge opposite a
 * negative barycentric coordinate, so only these edges are evaluated. NearestOnTriangle() computes
 * the same more slowly, and more accurately for needles.
 */
#ifndef BoneDecimate_Core_Geometry_TriangleFrame_h
#define BoneDecimate_Core_Geometry_TriangleFrame_h

#include "Surface.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bonedecimate
{
class TriangleFrame
{
public:
  /// A point of the triangle with corners a, b, c: a + B (b - a) + C (c - a).
  struct Point
  {
    double SquaredDistance = Infinity; // mm^2
    double B = 0.0;
    double C = 0.0;
    /// Bit 0, 1, 2: the weight of corner a, b, c is zero because the point lies on the opposite
    /// edge.
    int Clamped = 0;
  };

  TriangleFrame() = default;
  TriangleFrame(const Vector3& a, const Vector3& b, const Vector3& c)
    : A(a)
    , AB(b - a)
    , AC(c - a)
    , Normal(this->AB.cross(this->AC))
    , Bb(this->AB.squaredNorm())
    , Bc(Dot(this->AB, this->AC))
    , Cc(this->AC.squaredNorm())
  {
    const double twiceArea = this->Normal.norm();
    this->Area = 0.5 * twiceArea;
    // The plane of a triangle narrower than 1e-9 of its length is rounding error: then the edges
    // alone are used.
    if (twiceArea * twiceArea > 1e-18 * this->Bb * this->Cc)
    {
      this->Normal /= twiceArea;
      this->Inverse = 1.0 / (twiceArea * twiceArea);
    }
    else
    {
      this->Normal.setZero();
    }
  }

  const Vector3& UnitNormal() const { return this->Normal; } ///< Zero if there is no plane.
  double SurfaceArea() const { return this->Area; }          ///< mm^2
  const Vector3& SideToB() const { return this->AB; }
  const Vector3& SideToC() const { return this->AC; }
  /// Sum of the squared sides, mm^2.
  double SquaredSides() const { return 2.0 * (this->Bb + this->Cc - this->Bc); }
  bool HasPlane() const { return this->Inverse > 0.0; }

  /// The weights of b and c at the projection of p onto the plane, which may be outside of the
  /// triangle; zero without a plane.
  std::array<double, 2> Coordinates(const Vector3& p) const
  {
    const Vector3 ap = p - this->A;
    const double pb = Dot(this->AB, ap);
    const double pc = Dot(this->AC, ap);
    return { (this->Cc * pb - this->Bc * pc) * this->Inverse,
      (this->Bb * pc - this->Bc * pb) * this->Inverse };
  }

  /// Squared distance, mm^2, to the nearest point up to rounding. It is too small by the rounding
  /// of one subtraction at most.
  double SquaredReach(const Vector3& p) const
  {
    return (p - this->At(this->Nearest(p))).squaredNorm();
  }

  Vector3 At(const Point& point) const { return this->A + point.B * this->AB + point.C * this->AC; }

  Point Nearest(const Vector3& p) const
  {
    const Vector3 ap = p - this->A;
    const double pb = Dot(this->AB, ap);
    const double pc = Dot(this->AC, ap);
    const double b = (this->Cc * pb - this->Bc * pc) * this->Inverse;
    const double c = (this->Bb * pc - this->Bc * pb) * this->Inverse;
    if (b > 0.0 && c > 0.0 && b + c < 1.0)
    {
      const double height = Dot(this->Normal, ap);
      return { height * height, b, c, 0 };
    }
    return this->NearestOnEdges(ap, pb, pc, b, c);
  }

  /**
   * For a point inside the triangle: bit 0, 1, 2 is set if the edge opposite a, b, c is so near
   * that the triangle across it may be nearer to the query. Across other edges, this takes a
   * dihedral angle below 30 degrees.
   */
  int EdgesNearby(const Point& point) const
  {
    const double reach = 4.0 * point.SquaredDistance * this->Inverse; // (2 d / twice the area)^2
    const double a = 1.0 - point.B - point.C;
    const double oppositeA = this->Bb + this->Cc - 2.0 * this->Bc;
    return (a * a < reach * oppositeA ? 1 : 0) | (point.B * point.B < reach * this->Cc ? 2 : 0) |
      (point.C * point.C < reach * this->Bb ? 4 : 0);
  }

private:
  Point NearestOnEdges(const Vector3& ap, double pb, double pc, double b, double c) const
  {
    const bool all = !this->HasPlane();
    Point best;
    if (all || c <= 0.0)
    {
      const double t = Fraction(pb, this->Bb);
      best = { (ap - t * this->AB).squaredNorm(), t, 0.0, 4 | EndBits(t, 2, 1) };
    }
    if (all || b <= 0.0)
    {
      const double t = Fraction(pc, this->Cc);
      const double squared = (ap - t * this->AC).squaredNorm();
      if (squared < best.SquaredDistance)
      {
        best = { squared, 0.0, t, 2 | EndBits(t, 4, 1) };
      }
    }
    if (all || b + c >= 1.0)
    {
      const double t =
        Fraction(pc - pb + this->Bb - this->Bc, this->Bb + this->Cc - 2.0 * this->Bc);
      const double squared = (ap - (1.0 - t) * this->AB - t * this->AC).squaredNorm();
      if (squared < best.SquaredDistance)
      {
        best = { squared, 1.0 - t, t, 1 | EndBits(t, 4, 2) };
      }
    }
    return best;
  }

  static double Fraction(double along, double squaredLength)
  {
    return squaredLength > 0.0 ? std::clamp(along / squaredLength, 0.0, 1.0) : 0.0;
  }
  static int EndBits(double t, int atStart, int atEnd)
  {
    return t <= 0.0 ? atStart : t >= 1.0 ? atEnd : 0;
  }

  Vector3 A, AB, AC, Normal;
  double Bb = 0.0, Bc = 0.0, Cc = 0.0; // mm^2
  double Inverse = 0.0;                // mm^-4; 0: no plane
  double Area = 0.0;
};
}

#endif
