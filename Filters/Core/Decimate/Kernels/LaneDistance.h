// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LaneDistance.h
 * @brief Distances of the origin to four segments or triangles at once; in an anonymous namespace,
 * see Lanes.h.
 */
#ifndef BoneDecimate_Core_Decimate_Kernels_LaneDistance_h
#define BoneDecimate_Core_Decimate_Kernels_LaneDistance_h

#include "Lanes.h"

namespace bonedecimate
{
namespace
{
/// Squared distances to segments from `a` along `d`.
inline Doubles SquaredDistanceToSegment(const Vectors<Doubles>& a, const Vectors<Doubles>& d)
{
  const Doubles zero = {};
  const Doubles squared = d.Dot(d);
  Doubles t = Select(squared > 0.0, (zero - a.Dot(d)) / squared, zero);
  t = Smaller(Larger(t, zero), zero + 1.0);
  const Vectors<Doubles> nearest = a + d * t;
  return nearest.Dot(nearest);
}

/// Squared distances to triangles a, b, c: to the plane over the face, or to the nearest side.
inline Doubles SquaredDistanceToTriangle(
  const Vectors<Doubles>& a, const Vectors<Doubles>& b, const Vectors<Doubles>& c)
{
  const Doubles zero = {};
  const Vectors<Doubles> n = (b - a).Cross(c - a);
  const Doubles u = n.Dot(b.Cross(c));
  const Doubles v = n.Dot(c.Cross(a));
  const Doubles w = n.Dot(a.Cross(b));
  const Doubles square = n.Dot(n);
  const DoubleMask over = (u >= zero) & (v >= zero) & (w >= zero) & (square > zero);
  const Doubles height = n.Dot(a);
  const Doubles sides = Smaller(SquaredDistanceToSegment(a, b - a),
    Smaller(SquaredDistanceToSegment(b, c - b), SquaredDistanceToSegment(c, a - c)));
  return Select(over, height * height / square, sides);
}

inline double MinOfDoubles(Doubles lanes)
{
  double result = lanes[0];
  for (int lane = 1; lane < NumberOfDoubles; ++lane)
  {
    result = lanes[lane] < result ? lanes[lane] : result;
  }
  return result;
}
}
}

#endif
