// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LeastAreaContour.h
 * @brief Triangulates a contour in space with least area, preferring short edges among
 * triangulations of about equal area.
 *
 * G. Barequet, M. Sharir, Filling gaps in the boundary of a polyhedron, 1995: dynamic programming
 * over the polygon.
 */
#ifndef BoneDecimate_Core_Repair_Caps_LeastAreaContour_h
#define BoneDecimate_Core_Repair_Caps_LeastAreaContour_h

#include "Geometry/Surface.h"

#include <functional>
#include <vector>

namespace bonedecimate
{
/// Time grows with the third power of the number of points.
constexpr std::size_t MaxPointsOfLeastArea = 512;

/**
 * @param contour mm, in the direction of the triangles; need not lie in a plane.
 * @param isAllowed Whether a triangle may have the edge between two points that are not neighbors
 *   on the contour.
 * @return Two triangles fewer than the contour has points. None if no triangulation is allowed, or
 *   if the contour has fewer than 3 points or more than MaxPointsOfLeastArea.
 */
std::vector<Triangle> FillByLeastArea(
  const std::vector<Vector3>& contour, const std::function<bool(Index, Index)>& isAllowed);
}

#endif
