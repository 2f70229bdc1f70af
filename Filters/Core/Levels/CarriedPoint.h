// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CarriedPoint.h
 * @brief A point over a triangle of one surface, put over the same triangle of another one.
 *
 *     the nearest place on the triangle keeps its barycentric coordinates
 *     the way from there to the point turns with the triangle and grows with the root of its area
 *
 * Exact for surfaces that are moved, turned and scaled as a whole.
 */
#ifndef BoneDecimate_Core_Levels_CarriedPoint_h
#define BoneDecimate_Core_Levels_CarriedPoint_h

#include "Geometry/TriangleGeometry.h"

namespace bonedecimate
{
/// @param p Over the triangle `from`, mm.
Vector3 CarriedPoint(
  const Vector3& p, const std::array<Vector3, 3>& from, const std::array<Vector3, 3>& to);
}

#endif
