// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Foot.h
 * @brief The distance from a point to a triangle between two bounds that hold in any triangle, needles included.
 *
 * From above: the distance to a place that lies in the triangle whatever rounding did to its weights, because they are
 * forced to be at least 0 and to sum up to at most 1. From below: no point of the triangle is nearer than the nearest
 * corner is along the direction from that place, which is true of every direction; where the place is the nearest one
 * both bounds agree. Each may be wrong by the rounding of its evaluation alone; see Slack().
 */
#ifndef BoneDecimate_Core_Certificate_Foot_h
#define BoneDecimate_Core_Certificate_Foot_h

#include "Geometry/TriangleGeometry.h"
#include "Surface.h"

#include <array>

namespace bonedecimate::certificate
{
/// The corners of a triangle, mm; equal ones make a segment or a point.
using Corners = std::array<Vector3, 3>;

struct Foot
{
  Vector3 Place = Vector3::Zero(); ///< mm, in the triangle
  double Distance =
    0.0; ///< mm, from the point asked for: an upper bound, and nearly always the distance
};

/// The place of the triangle nearest to p, refined where the triangle is a needle.
Foot FindFoot(const Vector3& p, const Corners& corners);

/// A lower bound of the distance from p to the triangle, mm: equal to the foot's if it is the nearest place.
double DistanceFromBelow(const Vector3& p, const Corners& corners, const Foot& foot);

/**
 * How wrong a bound may be by rounding, mm, if no coordinate and no tolerance is larger than the extent (mm).
 *
 * With u = 2^-53, in u of the extent and a coordinate: a new corner from the corners of a piece, 8 each time, DeepestCut
 * times at most; a place from its weights, 8; weights whose sum exceeds 1 by rounding, 4; the difference of two places,
 * its length or a projection of it, 16; the size of a piece, 8. Together less than 1250, and less than 2200 u of the
 * extent in length. Tolerances in between: 3 u each time, 450 u. We take 4096 u.
 */
constexpr double Slack(double extent)
{
  return 0x1p-41 * extent + 1e-150; // squares below 1e-300 are lost
}
constexpr int DeepestCut = 150;
}

#endif
