// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorLimits.h"

#include "ErrorBound.h"

#include <cmath>

namespace bonedecimate
{
namespace
{
/// Relative slack. It is far more than rounding needs: the certificate of the result decides as
/// soon as its bounds are that near to each other.
constexpr double RelativeSlack = 2e-4;
/// Slack for rounding, as a ratio of the largest coordinate.
constexpr double AbsoluteSlack = 1e-14;

/// Limits are rounded down to this number of bits, so they do not depend on the distance from the
/// origin.
constexpr int BitsOfLimit = 16;

double RoundedDown(double value)
{
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return std::ldexp(std::floor(std::ldexp(fraction, BitsOfLimit)), exponent - BitsOfLimit);
}

/// mm, for rounding errors and for the rounding of points that never move when they are written.
double SlackOf(const HalfEdgeMesh& original, const ErrorBoundSettings& settings)
{
  double size = 0.0;
  double rounding = 0.0;
  for (VertexId v = 0; v < original.NumberOfVertexSlots(); ++v)
  {
    const Vector3& p = original.Position(v);
    size = std::max(size, (p + settings.Origin).cwiseAbs().maxCoeff());
    rounding = std::max(rounding, (settings.Rounded(p) - p).norm());
  }
  return AbsoluteSlack * size + rounding;
}
}

ErrorLimits::ErrorLimits(const HalfEdgeMesh& original, const ErrorBoundSettings& settings)
  : OriginalMesh(original)
{
  this->RoundingMargin = SlackOf(original, settings);
  const auto withoutSlack = [this](double error)
  { return RoundedDown(std::max(0.0, error * (1.0 - RelativeSlack) - this->RoundingMargin)); };
  this->MaxLimit = withoutSlack(settings.Error);
  if (settings.Tolerances != nullptr)
  {
    this->VertexLimits.reserve(settings.Tolerances->size());
    for (const double tolerance : *settings.Tolerances)
    {
      this->VertexLimits.push_back(
        std::min(this->MaxLimit, withoutSlack(tolerance >= 0.0 ? tolerance : Infinity)));
    }
  }
}

//------------------------------------------------------------------------------
void ErrorLimits::Reduce(const std::vector<double>& distances, double part)
{
  const auto isNear = [](double distance) { return std::isfinite(distance); };
  if (this->IsUniform() && std::any_of(distances.begin(), distances.end(), isNear))
  {
    this->VertexLimits.assign(distances.size(), this->MaxLimit);
  }
  for (std::size_t v = 0; v < this->VertexLimits.size(); ++v)
  {
    if (isNear(distances[v]))
    {
      this->VertexLimits[v] = std::min(this->VertexLimits[v],
        RoundedDown(std::max(0.0, part * distances[v] - this->RoundingMargin)));
    }
  }
}

//------------------------------------------------------------------------------
double ErrorLimits::Interpolate(double from, double to, double t)
{
  return std::isinf(from) || std::isinf(to) ? Infinity : from + t * (to - from);
}
}
