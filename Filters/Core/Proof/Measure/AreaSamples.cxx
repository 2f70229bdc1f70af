// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "AreaSamples.h"

#include "Geometry/TriangleGeometry.h"

#include <cmath>

namespace bonedecimate
{
namespace
{
// 1/g and 1/g^2 of the plastic number g = 1.3247..., the root of g^3 = g + 1.
constexpr double FirstStep = 0.7548776662466927;
constexpr double SecondStep = 0.5698402909980532;

double Fraction(double value)
{
  return value - std::floor(value);
}
}

AreaSamples::AreaSamples(
  const std::vector<Vector3>& points, const std::vector<Triangle>& triangles, std::size_t count)
  : Points(points)
  , Triangles(triangles)
{
  this->Areas.reserve(triangles.size());
  double sum = 0.0;
  for (const Triangle& c : triangles)
  {
    sum += AreaVector(points[c[0]], points[c[1]], points[c[2]]).norm();
    this->Areas.push_back(sum);
  }
  this->Number = sum > 0.0 ? count : 0;
}

Vector3 AreaSamples::PositionIn(const Triangle& corners, double number) const
{
  double u = Fraction(0.5 + number * FirstStep);
  double v = Fraction(0.5 + number * SecondStep);
  if (u + v > 1.0)
  {
    u = 1.0 - u;
    v = 1.0 - v;
  }
  const Vector3& a = this->Points[corners[0]];
  return a + u * (this->Points[corners[1]] - a) + v * (this->Points[corners[2]] - a);
}
}
