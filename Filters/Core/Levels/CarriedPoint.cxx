// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CarriedPoint.h"

#include <cmath>

namespace bonedecimate
{
namespace
{
using Corners = std::array<Vector3, 3>;

/// An orthonormal right-handed frame: along the first edge, in the plane, along the normal. Zero
/// without area.
Eigen::Matrix3d FrameOf(const Corners& c)
{
  const Vector3 normal = AreaVector(c[0], c[1], c[2]).normalized();
  const Vector3 along = (c[1] - c[0]).normalized();
  Eigen::Matrix3d frame;
  frame << along, normal.cross(along), normal;
  return frame;
}

double AreaOf(const Corners& c)
{
  return AreaVector(c[0], c[1], c[2]).norm(); // mm^2
}
}

Vector3 CarriedPoint(const Vector3& p, const Corners& from, const Corners& to)
{
  const PointOnTriangle nearest = NearestOnTriangle(p, from[0], from[1], from[2]);
  const Vector3 foot =
    nearest.Weights[0] * to[0] + nearest.Weights[1] * to[1] + nearest.Weights[2] * to[2];
  const Vector3 away = p - nearest.Position;
  const double areaBefore = AreaOf(from);
  const double areaAfter = AreaOf(to);
  if (!(areaBefore > 0.0 && areaAfter > 0.0))
  {
    return foot + away;
  }
  const double growth = std::sqrt(areaAfter / areaBefore);
  return foot + growth * (FrameOf(to) * (FrameOf(from).transpose() * away));
}
}
