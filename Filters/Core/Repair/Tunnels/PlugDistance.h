// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlugDistance.h
 * @brief How far triangles lie from a surface.
 */
#ifndef BoneDecimate_Core_Repair_Tunnels_PlugDistance_h
#define BoneDecimate_Core_Repair_Tunnels_PlugDistance_h

#include "Geometry/BoundingTree.h"

namespace bonedecimate
{
/**
 * The triangles are divided where their bound is largest: at the centroid of a piece the distance
 * is known, and at its other points it is larger by at most the distance from there.
 * @return mm, an upper bound of the largest distance of a point of the triangles to the surface;
 *   too large by at most 2 % and a hundredth of the largest triangle's radius. 0 without triangles.
 */
double MaxDistanceTo(const BoundingTree& surface, const Surface& triangles);
}

#endif
