// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CompareShapes.h
 * @brief Compares the triangles of a result with the MinimumAngle and the edge lengths of its run.
 */
#ifndef BoneDecimate_Core_Run_Output_CompareShapes_h
#define BoneDecimate_Core_Run_Output_CompareShapes_h

#include "Mesh/ShapeLimits.h"
#include "Run/Report/Report.h"

namespace bonedecimate
{
/// @param origin mm, that the positions of the limits are relative to.
void CompareShapes(const Surface& surface, const Options& options, const ShapeLimits& limits,
  const Vector3& origin, Report& report);
}

#endif
