// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NearBoundaries.h
 * @brief Boundary points so near to another boundary point that both were probably meant to be one.
 */
#ifndef BoneDecimate_Core_Repair_Diagnostics_NearBoundaries_h
#define BoneDecimate_Core_Repair_Diagnostics_NearBoundaries_h

#include "Geometry/Surface.h"

#include <array>
#include <limits>
#include <vector>

namespace bonedecimate
{
struct NearBoundaries
{
  std::vector<Index> Points; ///< Ascending.
  /// mm, the distance within which merging joins all these points. NaN if there are none.
  double WeldingDistance = std::numeric_limits<double>::quiet_NaN();
};

/**
 * A point is reported if another boundary point that is not its neighbor is within 1 % of the mean
 * boundary edge length.
 * @param open Both ends of every open edge.
 */
NearBoundaries FindNearBoundaries(
  const std::vector<Vector3>& points, const std::vector<std::array<Index, 2>>& open);
}

#endif
