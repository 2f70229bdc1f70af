// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorLimits.h"

#include "ErrorBound.h"

#include <cmath>

namespace bonedecimate
{
namespace
{
/// Relative slack, far more than the rounding of distances and of interpolated points needs, so
/// that the certificate of the result decides as soon as its bounds are that near to each other.
constexpr double RelativeSlack = 2e-4;
/// Slack for the same rounding, as a ratio of the largest coordinate.
constexpr double AbsoluteSlack = 1e-14;

/// Limits have so many bits, so that they are the same at another distance from the origin.
constexpr int BitsOfLimit = 16;

double RoundedDown(double value)
{
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return std::ldexp(std::floor(std::ldexp(fraction, BitsOfLimit)), exponent - BitsOfLimit);
}

/// mm: for rounding, and for what points that never move are moved by when they are written.
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
  : Original(original)
{
  this->Slack = SlackOf(original, settings);
  const auto withoutSlack = [this](double error)
  { return RoundedDown(std::max(0.0, error * (1.0 - RelativeSlack) - this->Slack)); };
  this->Everywhere = withoutSlack(settings.Error);
  if (settings.Tolerances != nullptr)
  {
    this->Values.reserve(settings.Tolerances->size());
    for (const double tolerance : *settings.Tolerances)
    {
      this->Values.push_back(
        std::min(this->Everywhere, withoutSlack(tolerance >= 0.0 ? tolerance : Infinity)));
    }
  }
}

//------------------------------------------------------------------------------
void ErrorLimits::Reduce(const std::vector<double>& distances, double part)
{
  const auto isNear = [](double distance) { return std::isfinite(distance); };
  if (!this->Differ() && std::any_of(distances.begin(), distances.end(), isNear))
  {
    this->Values.assign(distances.size(), this->Everywhere);
  }
  for (std::size_t v = 0; v < this->Values.size(); ++v)
  {
    if (isNear(distances[v]))
    {
      this->Values[v] =
        std::min(this->Values[v], RoundedDown(std::max(0.0, part * distances[v] - this->Slack)));
    }
  }
}

//------------------------------------------------------------------------------
double ErrorLimits::Between(double from, double to, double t)
{
  return std::isinf(from) || std::isinf(to) ? Infinity : from + t * (to - from);
}
}
