// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AlternatePositions.h
 * @brief Positions to try for a merged vertex if the best position cannot be proved, in this order.
 *
 *     m = (v + w) / 2         the middle of the edge from v to w
 *     x                       the best position (VolumePreserving.h)
 *     x(a, b) = m + a (x - m) + b (v - m)
 */
#ifndef BoneDecimate_Core_Decimate_Placement_AlternatePositions_h
#define BoneDecimate_Core_Decimate_Placement_AlternatePositions_h

#include "Geometry/Surface.h"

#include <array>

namespace bonedecimate
{
/// The best position and all alternates.
constexpr int MaximumPositions = 13;

struct AlternatePosition
{
  double TowardsBest;  ///< a
  double TowardsStart; ///< b; -1: the other end of the edge.

  Vector3 Of(const Vector3& best, const Vector3& start, const Vector3& end) const
  {
    const Vector3 middle = 0.5 * (start + end);
    return middle + this->TowardsBest * (best - middle) + this->TowardsStart * (start - middle);
  }
};

/// Ordered by gain per cost: the middle and the ends are rejected early.
constexpr std::array<AlternatePosition, MaximumPositions - 1> AlternatePositions = { { { 0.0, 0.0 },
  { 0.0, 1.0 }, { 0.0, -1.0 }, { 1.0, 0.3 }, { 1.0, -0.3 }, { 0.5, 0.0 }, { 1.5, 0.0 },
  { 2.0, 0.0 }, { 0.5, 0.3 }, { 0.5, -0.3 }, { 1.5, 0.3 }, { 1.5, -0.3 } } };
}

#endif
