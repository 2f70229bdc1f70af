// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoneSize.h
 * @brief The size of a surface, and whether it can be that of a bone in millimeters.
 */
#ifndef BoneDecimate_Core_Mesh_BoneSize_h
#define BoneDecimate_Core_Mesh_BoneSize_h

#include "Geometry/Surface.h"

#include <vector>

namespace bonedecimate
{
/// The diagonal of the bounding box of points, used or not, mm.
inline double DiagonalOf(const std::vector<Vector3>& points)
{
  Vector3 least = points.empty() ? Vector3(0.0, 0.0, 0.0) : points.front();
  Vector3 most = least;
  for (const Vector3& p : points)
  {
    least = least.cwiseMin(p);
    most = most.cwiseMax(p);
  }
  return (most - least).norm();
}

/// The largest ratio of an error to the diagonal of the bounding box; beyond it the unit is in
/// doubt.
constexpr double LargestErrorRatio = 0.25;

/// From 2 mm (an ossicle) to 3 m (a whole skeleton). @param diagonal Diagonal of the bounding box,
/// mm.
inline bool IsBoneSize(double diagonal)
{
  return diagonal >= 2.0 && diagonal <= 3000.0;
}
}

#endif
