// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Foot.h"

#include <algorithm>

namespace bonedecimate::certificate
{
namespace
{
/// Bounds that agree to this share of the distance to the farthest corner need no refinement.
constexpr double GoodEnough = 1e-10;
constexpr int MostRefinements = 4;

/// Weights of the second and the third corner.
struct Weights
{
  double B, C;
};

/// The same place or, if rounding left the triangle, one in it.
Weights Inside(Weights weights)
{
  weights.B = std::max(0.0, weights.B);
  weights.C = std::max(0.0, weights.C);
  const double sum = weights.B + weights.C;
  return sum > 1.0 ? Weights{ weights.B / sum, weights.C / sum } : weights;
}

/// A corner is met exactly.
Foot FootAt(const Vector3& p, const Corners& corners, const Weights& weights)
{
  Foot foot;
  foot.Place = weights.B == 1.0 ? corners[1]
    : weights.C == 1.0          ? corners[2]
                                : Vector3(corners[0] + weights.B * (corners[1] - corners[0]) +
                                    weights.C * (corners[2] - corners[0]));
  foot.Distance = (p - foot.Place).norm();
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

/// One more step towards the projection onto the plane, from where rounding ended; the residual is known exactly enough.
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
  const Vector3 rest = p - foot.Place;
  return Inside({ weights.B + normal.dot(rest.cross(ac)) / squared,
    weights.C + normal.dot(ab.cross(rest)) / squared });
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

bool IsNearest(const Vector3& p, const Corners& corners, const Foot& foot)
{
  const double reach = std::max(
    { (p - corners[0]).lpNorm<1>(), (p - corners[1]).lpNorm<1>(), (p - corners[2]).lpNorm<1>() });
  return DistanceFromBelow(p, corners, foot) >= foot.Distance - GoodEnough * reach;
}
}

Foot FindFoot(const Vector3& p, const Corners& corners)
{
  const TrianglePlace place = NearestOnTriangle(p, corners[0], corners[1], corners[2]);
  Weights weights = Inside({ place.Weights[1], place.Weights[2] });
  Foot foot = FootAt(p, corners, weights);
  if (!IsNearest(p, corners, foot))
  {
    TryEdges(p, corners, weights, foot);
    for (int i = 0; i < MostRefinements && !IsNearest(p, corners, foot); ++i)
    {
      Try(p, corners, Step(p, corners, weights, foot), weights, foot);
    }
  }
  return foot;
}

double DistanceFromBelow(const Vector3& p, const Corners& corners, const Foot& foot)
{
  const Vector3 rest = p - foot.Place;
  const double length = rest.norm();
  if (!(length > 0.0))
  {
    return 0.0;
  }
  double least = rest.dot(p - corners[0]);
  least = std::min(least, rest.dot(p - corners[1]));
  least = std::min(least, rest.dot(p - corners[2]));
  return std::max(0.0, least / length);
}
}
