// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Foot.h"

#include <algorithm>

namespace bonedecimate::certificate
{
namespace
{
/// The foot is refined until the bounds agree to this fraction of the distance, or of the distance to the farthest corner.
constexpr double RelativeTolerance = 1e-8;
constexpr double ToleranceOfExtent = 1e-14;
constexpr int MaxRefinements = 4;

/// Weights of the second and the third corner.
struct Weights
{
  double B, C;
};

/// Moves a point that is outside of the triangle because of rounding into it.
Weights Inside(Weights weights)
{
  weights.B = std::max(0.0, weights.B);
  weights.C = std::max(0.0, weights.C);
  const double sum = weights.B + weights.C;
  return sum > 1.0 ? Weights{ weights.B / sum, weights.C / sum } : weights;
}

/// Returns the exact coordinates for the weights of a corner.
Foot FootAt(const Vector3& p, const Corners& corners, const Weights& weights)
{
  Foot foot;
  foot.Position = weights.B == 1.0 ? corners[1]
    : weights.C == 1.0             ? corners[2]
                                   : Vector3(corners[0] + weights.B * (corners[1] - corners[0]) +
                                       weights.C * (corners[2] - corners[0]));
  foot.Distance = (p - foot.Position).norm();
  return foot;
}

void Try(
  const Vector3& p, const Corners& corners, const Weights& weights, Weights& best, Foot& foot)
{
  const Foot other = FootAt(p, corners, weights);
  if (other.Distance < foot.Distance)
  {
    foot = other;
    best = weights;
  }
}

/// One step of iterative refinement towards the projection onto the plane. The residual is accurate enough for that.
Weights Step(const Vector3& p, const Corners& corners, const Weights& weights, const Foot& foot)
{
  const Vector3 ab = corners[1] - corners[0];
  const Vector3 ac = corners[2] - corners[0];
  const Vector3 normal = ab.cross(ac);
  const double squared = normal.squaredNorm();
  if (!(squared > 0.0))
  {
    return weights;
  }
  const Vector3 rest = p - foot.Position;
  return Inside({ weights.B + Dot(normal, rest.cross(ac)) / squared,
    weights.C + Dot(normal, ab.cross(rest)) / squared });
}

void TryEdges(const Vector3& p, const Corners& corners, Weights& best, Foot& foot)
{
  const double ab = NearestFraction(p, corners[0], corners[1]);
  const double ac = NearestFraction(p, corners[0], corners[2]);
  const double bc = NearestFraction(p, corners[1], corners[2]);
  Try(p, corners, { ab, 0.0 }, best, foot);
  Try(p, corners, { 0.0, ac }, best, foot);
  Try(p, corners, { 1.0 - bc, bc }, best, foot);
}

/// A lower bound: along any direction, no point of the triangle is nearer than the nearest corner.
double DistanceAlong(const Vector3& direction, const Vector3& p, const Corners& corners)
{
  const double length = direction.norm();
  if (!(length > 0.0))
  {
    return 0.0;
  }
  double least = Dot(direction, p - corners[0]);
  least = std::min(least, Dot(direction, p - corners[1]));
  least = std::min(least, Dot(direction, p - corners[2]));
  return least / length;
}

bool IsGood(double below, const Vector3& p, const Corners& corners, const Foot& foot)
{
  const double reach = std::max(
    { (p - corners[0]).lpNorm<1>(), (p - corners[1]).lpNorm<1>(), (p - corners[2]).lpNorm<1>() });
  return foot.Distance - below <=
    std::max(RelativeTolerance * foot.Distance, ToleranceOfExtent * reach);
}

bool IsNearest(const Vector3& p, const Corners& corners, const Foot& foot)
{
  return IsGood(DistanceFromBelow(p, corners, foot), p, corners, foot);
}
}

Foot FindFoot(const Vector3& p, const Corners& corners)
{
  const PointOnTriangle nearest = NearestOnTriangle(p, corners[0], corners[1], corners[2]);
  Weights weights = Inside({ nearest.Weights[1], nearest.Weights[2] });
  Foot foot = FootAt(p, corners, weights);
  if (!IsNearest(p, corners, foot))
  {
    TryEdges(p, corners, weights, foot);
    for (int i = 0; i < MaxRefinements && !IsNearest(p, corners, foot); ++i)
    {
      Try(p, corners, Step(p, corners, weights, foot), weights, foot);
    }
  }
  return foot;
}

/// Near the triangle the direction from the foot is mostly rounding error. Directions perpendicular to an edge or to the
/// plane are more accurate.
double DistanceFromBelow(const Vector3& p, const Corners& corners, const Foot& foot)
{
  const Vector3 rest = p - foot.Position;
  double below = std::max(0.0, DistanceAlong(rest, p, corners));
  if (IsGood(below, p, corners, foot))
  {
    return below;
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Vector3 edge = corners[(i + 1) % 3] - corners[i];
    const double squared = edge.squaredNorm();
    if (squared > 0.0)
    {
      Vector3 across = rest - (Dot(rest, edge) / squared) * edge;
      across -= (Dot(across, edge) / squared) * edge;
      below = std::max(below, DistanceAlong(across, p, corners));
    }
  }
  const Vector3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  return std::max({ below, DistanceAlong(normal, p, corners), DistanceAlong(-normal, p, corners) });
}
}
