// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShapePenalty.h
 * @brief The penalty of badly shaped triangles: among edits that leave about the same distances,
 * the one with the better triangles is chosen.
 *
 *     penalty = weight r^2,   r = 1 / (q + 0.02),   q = 4 sqrt(3) area / sum of squared sides
 *
 * q is 1 for an equilateral triangle and 0 without area. For constant area, 1 / q is convex in the
 * corners. The square is steep for narrow triangles: compared with q = 1, it is 3 times as large
 * for q = 0.55 and 20 times for q = 0.2.
 */
#ifndef BoneDecimate_Core_Decimate_Cost_ShapePenalty_h
#define BoneDecimate_Core_Decimate_Cost_ShapePenalty_h

#include "Geometry/TriangleFrame.h"

#include <algorithm>
#include <limits>

namespace bonedecimate
{
class ShapePenalty
{
public:
  /// How the penalty changes with a step of a corner: it falls along Pull, and Stiffness times the
  /// step works against it.
  struct Slope
  {
    Vector3 Pull;     // half of the negative gradient, 1/mm
    double Stiffness; // half of the second derivative for constant area, 1/mm^2
  };

  explicit ShapePenalty(double weight)
    : Weight(weight)
  {
  }

  double Of(const TriangleFrame& frame) const
  {
    const double r = frame.SquaredSides() / Divisor(frame);
    return this->Weight * r * r;
  }

  /// The gradient at corner A of the frame.
  Slope At(const TriangleFrame& frame) const
  {
    const double divisor = Divisor(frame);
    const double r = frame.SquaredSides() / divisor;
    const Vector3 sides = -2.0 * (frame.SideToB() + frame.SideToC());
    const Vector3 area = 0.5 * frame.UnitNormal().cross(frame.SideToC() - frame.SideToB());
    const double half = this->Weight * r / divisor;
    return { half * (r * (OfArea * area + Bias * sides) - sides), 4.0 * half };
  }

private:
  static constexpr double OfArea = 6.928203230275509; // 4 sqrt(3)
  static constexpr double Bias = 0.02;

  static double Divisor(const TriangleFrame& frame) // mm^2
  {
    return std::max(OfArea * frame.SurfaceArea() + Bias * frame.SquaredSides(),
      std::numeric_limits<double>::min());
  }

  double Weight;
};
}

#endif
