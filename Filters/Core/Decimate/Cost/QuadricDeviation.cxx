// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "QuadricDeviation.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
float QuadricDeviation(
  const EdgeQuadric& quadric, const Float3& x, float accumulatedError, float normalization)
{
  const float s = quadric.M.Trace();
  const float least = s * quadric.Half.Dot(quadric.Half) * FlatRatio;
  const float q = std::max(0.0F, quadric.At(x)) + least;
  const float deviation = std::sqrt(std::sqrt(s) * q * std::sqrt(q));
  const float accumulated =
    (0.5F * AccumulatedErrorWeight) * s * accumulatedError * std::sqrt(accumulatedError);
  return (deviation + accumulated) * normalization;
}

//------------------------------------------------------------------------------
float CostNormalization(double length)
{
  return static_cast<float>(1.0 / (length * length * length * std::sqrt(length)));
}
}
