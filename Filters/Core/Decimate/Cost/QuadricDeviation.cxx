// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "QuadricDeviation.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
float QuadricDeviation(const CollapseInput& input)
{
  const EdgeQuadric& quadric = input.Quadric;
  const float accumulatedError = input.AccumulatedError;
  const float s = quadric.M.Trace();
  const float least = s * quadric.Half.Dot(quadric.Half) * FlatRatio;
  const float q = std::max(0.0F, quadric.At(input.Position)) + least;
  const float deviation = std::sqrt(std::sqrt(s) * q * std::sqrt(q));
  const float accumulated =
    (0.5F * AccumulatedErrorWeight) * s * accumulatedError * std::sqrt(accumulatedError);
  return (deviation + accumulated) * input.Normalization;
}

//------------------------------------------------------------------------------
float CostNormalization(double length)
{
  return static_cast<float>(1.0 / (length * length * length * std::sqrt(length)));
}
}
