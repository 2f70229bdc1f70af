// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Limits.h"

#include "Guarantee.h"

#include <cmath>
#include <limits>

namespace bonedecimate
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
/// Far more than the rounding of distances and of points between others needs: the certificate of the result then decides
/// as soon as its bounds are that near to each other.
constexpr double RelativeSlack = 2e-4;
/// Of the largest coordinate, for the same.
constexpr double AbsoluteSlack = 1e-14;

/// mm: for rounding, and for what points that never move are moved by when they are written.
double SlackOf(const HalfEdgeMesh& original, const Promise& promise)
{
  double size = 0.0;
  double rounding = 0.0;
  for (Index v = 0; v < original.NumberOfVertexSlots(); ++v)
  {
    const Vector3& p = original.Position(v);
    size = std::max(size, (p + promise.Origin).cwiseAbs().maxCoeff());
    rounding = std::max(rounding, (promise.Rounded(p) - p).norm());
  }
  return AbsoluteSlack * size + rounding;
}
}

Limits::Limits(const HalfEdgeMesh& original, const Promise& promise)
  : Original(original)
{
  const double slack = SlackOf(original, promise);
  const auto withoutSlack = [slack](double promised)
  { return std::max(0.0, promised * (1.0 - RelativeSlack) - slack); };
  this->Everywhere = withoutSlack(promise.Error);
  if (promise.Tolerances != nullptr)
  {
    this->Values.reserve(promise.Tolerances->size());
    for (const double tolerance : *promise.Tolerances)
    {
      this->Values.push_back(
        std::min(this->Everywhere, withoutSlack(tolerance >= 0.0 ? tolerance : Infinity)));
    }
  }
}

//------------------------------------------------------------------------------
double Limits::Between(double from, double to, double t)
{
  return std::isinf(from) || std::isinf(to) ? Infinity : from + t * (to - from);
}
}
