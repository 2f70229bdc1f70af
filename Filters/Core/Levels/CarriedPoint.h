// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CarriedPoint.h
 * @brief Transfers a point near a triangle of one surface to the same triangle of another one.
 *
 *     the nearest point of the triangle keeps its barycentric coordinates
 *     the vector from there to the point rotates with the triangle and scales with the
 *       square root of its area
 *
 * Exact for translation, rotation and uniform scaling of the surface.
 */
#ifndef BoneDecimate_Core_Levels_CarriedPoint_h
#define BoneDecimate_Core_Levels_CarriedPoint_h

#include "Geometry/TriangleGeometry.h"

namespace bonedecimate
{
/// @param p A point near the triangle `from`, mm.
Vector3 CarriedPoint(
  const Vector3& p, const std::array<Vector3, 3>& from, const std::array<Vector3, 3>& to);
}

#endif
