// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Foot.h
 * @brief Lower and upper bounds of the distance from a point to a triangle, valid for any triangle,
 * needles included.
 *
 * Upper bound: the distance to a point of the triangle. It lies in the triangle whatever the
 * rounding error of its weights, because they are clamped to be at least 0 with a sum of at most 1.
 *
 * Lower bound: along the direction from that point, no point of the triangle is nearer than the
 * nearest corner; this holds for every direction.
 *
 * Both bounds agree if the point is the nearest one. Each is wrong only by the rounding of its own
 * evaluation; see Slack().
 */
#ifndef BoneDecimate_Core_Proof_Certificate_Foot_h
#define BoneDecimate_Core_Proof_Certificate_Foot_h

#include "Geometry/Surface.h"
#include "Geometry/TriangleGeometry.h"

#include <array>

namespace bonedecimate::certificate
{
/// The corners of a triangle, mm; equal corners describe a segment or a point.
using Corners = std::array<Vector3, 3>;

struct Foot
{
  Vector3 Position = Vector3::Zero(); ///< mm, in the triangle
  /// mm, to the query point: an upper bound, and nearly always the exact distance
  double Distance = 0.0;
};

/// The point of the triangle nearest to p, refined if the triangle is a needle.
Foot FindFoot(const Vector3& p, const Corners& corners);

/// A lower bound of the distance from p to the triangle, mm; equal to the distance of the foot if
/// that is the nearest point.
double DistanceFromBelow(const Vector3& p, const Corners& corners, const Foot& foot);

/**
 * Largest rounding error of a bound, mm, if no coordinate and no tolerance is larger than the
 * extent (mm).
 *
 * With u = 2^-53, in u of the extent and for each coordinate: a new corner from the corners of a
 * piece, 8 each time, at most DeepestCut times; a point from its weights, 8; weights whose sum
 * exceeds 1 by rounding, 4; the difference of two points, its length or a projection of it, 16; the
 * size of a piece, 8. The sum is less than 1250, and less than 2200 u of the extent in length.
 * Interpolated tolerances: 3 u each time, 450 u. 4096 u is used.
 */
constexpr double Slack(double extent)
{
  return 0x1p-41 * extent + 1e-150; // squares below 1e-300 underflow
}
constexpr int DeepestCut = 150;
}

#endif
