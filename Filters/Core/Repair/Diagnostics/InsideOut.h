// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InsideOut.h
 * @brief Closed components whose triangles are oriented inward although no other component
 * surrounds them.
 */
#ifndef BoneDecimate_Core_Repair_Diagnostics_InsideOut_h
#define BoneDecimate_Core_Repair_Diagnostics_InsideOut_h

#include "Geometry/Surface.h"

#include <vector>

namespace bonedecimate
{
/**
 * The first triangle of each such component, ascending. A component of negative volume in the box
 * of a larger one of positive volume is the surface of a cavity and not listed.
 * @param surface Its points lie near the origin.
 * @param isOpen For each point: whether it lies on an edge that does not have two triangles of one
 *   orientation.
 */
std::vector<Index> FindInsideOut(const Surface& surface, const std::vector<bool>& isOpen);
}

#endif
