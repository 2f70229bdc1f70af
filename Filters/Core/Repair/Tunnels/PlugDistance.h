// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlugDistance.h
 * @brief The largest distance of triangles from a surface.
 */
#ifndef BoneDecimate_Core_Repair_Tunnels_PlugDistance_h
#define BoneDecimate_Core_Repair_Tunnels_PlugDistance_h

#include "Geometry/BoundingTree.h"

namespace bonedecimate
{
/**
 * Divides the triangles where their bound is largest. The distance at the centroid of a piece is
 * known; at its other points it is larger by at most the distance from the centroid.
 * @return mm, an upper bound of the largest distance, too large by at most 2 % and a hundredth of
 *   the largest triangle's radius. 0 without triangles.
 */
double MaxDistanceTo(const BoundingTree& surface, const Surface& triangles);
}

#endif
