// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointPosition.h
 * @brief A point of a surface as a value.
 */
#ifndef BoneDecimate_Applications_PointPosition_h
#define BoneDecimate_Applications_PointPosition_h

#include "vtkPolyData.h"

#include <array>

namespace bonedecimate
{
inline std::array<double, 3> PositionOf(vtkPolyData* surface, vtkIdType point)
{
  std::array<double, 3> position = {};
  surface->GetPoint(point, position.data());
  return position;
}
}

#endif
