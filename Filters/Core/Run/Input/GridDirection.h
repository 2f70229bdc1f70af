// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GridDirection.h
 * @brief Directions in which the voxel grid of a binary surface may lie, from its edges alone.
 *
 * The corners of a triangle of marching cubes are middles of grid edges of one cell, so there are
 * few different edges, whatever the size of the surface: at most 27 up to their sign. Flat parts of
 * the staircase have edges along the axes of the grid.
 *
 *     edges       equal ones are grouped; their mean has little of the rounding of single precision
 *     directions  three groups that are perpendicular to each other, the frequent ones first
 *
 * A surface with more different edges is no binary one. VoxelGridSearch.h decides whether a
 * direction is that of the grid.
 */
#ifndef BoneDecimate_Core_Run_Input_GridDirection_h
#define BoneDecimate_Core_Run_Input_GridDirection_h

#include "Geometry/Surface.h"

#include <vector>

namespace bonedecimate
{
/// Rotations whose columns are the axes of the grid. @param surface With valid indices.
std::vector<Eigen::Matrix3d> FindGridDirections(const Surface& surface);
}

#endif
