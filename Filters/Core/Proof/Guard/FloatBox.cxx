// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FloatBox.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
/// Beyond the value by more than all rounding errors.
/// @param direction 1: above; -1: below.
float Beyond(double value, float direction)
{
  constexpr float relative = 1.2e-7F; // more than an epsilon
  constexpr float absolute = 1e-30F;
  const auto rounded = static_cast<float>(value);
  return rounded + direction * (std::abs(rounded) * relative + absolute);
}
}

FloatBox::FloatBox()
{
  this->Low.fill(FloatInfinity);
  this->High.fill(-FloatInfinity);
}

FloatBox::FloatBox(const TriangleCorners& corners, double reach)
{
  const Vector3 low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]).array() - reach;
  const Vector3 high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]).array() + reach;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto at = static_cast<Eigen::Index>(axis);
    this->Low[axis] = Beyond(low[at], -1.0F);
    this->High[axis] = Beyond(high[at], 1.0F);
  }
}

//------------------------------------------------------------------------------
void FloatBox::Add(const FloatBox& other)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Low[axis] = std::min(this->Low[axis], other.Low[axis]);
    this->High[axis] = std::max(this->High[axis], other.High[axis]);
  }
}

//------------------------------------------------------------------------------
FloatBox FloatBox::Grown(double reach) const
{
  FloatBox grown;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    grown.Low[axis] = Beyond(this->Low[axis] - reach, -1.0F);
    grown.High[axis] = Beyond(this->High[axis] + reach, 1.0F);
  }
  return grown;
}

//------------------------------------------------------------------------------
double FloatBox::Diagonal() const
{
  return Vector3(
    this->High[0] - this->Low[0], this->High[1] - this->Low[1], this->High[2] - this->Low[2])
    .norm();
}

//------------------------------------------------------------------------------
double FloatBox::DistanceTo(const FloatBox& other) const
{
  double squared = 0.0; // mm^2
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double below = static_cast<double>(other.Low[axis]) - this->High[axis]; // mm
    const double above = static_cast<double>(this->Low[axis]) - other.High[axis]; // mm
    const double apart = std::max({ 0.0, below, above });
    squared += apart * apart;
  }
  return std::sqrt(squared);
}
}
