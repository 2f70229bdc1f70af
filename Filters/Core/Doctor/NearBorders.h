// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NearBorders.h
 * @brief Points of open borders that another point of a border is so near to that they were one, most likely.
 */
#ifndef BoneDecimate_Core_Doctor_NearBorders_h
#define BoneDecimate_Core_Doctor_NearBorders_h

#include "Surface.h"

#include <array>
#include <limits>
#include <vector>

namespace bonedecimate
{
struct NearBorders
{
  std::vector<Index> Points; ///< Ascending.
  /// mm, the largest distance to their partners: merging over it would weld them all. Not a number if there are none.
  double WeldingDistance = std::numeric_limits<double>::quiet_NaN();
};

/**
 * A point is near if another point of a border, no neighbour along its own, is within a hundredth of the mean border edge.
 * @param open Both ends of every open edge.
 */
NearBorders FindNearBorders(
  const std::vector<Vector3>& points, const std::vector<std::array<Index, 2>>& open);
}

#endif
