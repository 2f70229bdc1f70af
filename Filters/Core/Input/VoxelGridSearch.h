// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VoxelGridSearch.h
 * @brief Finds the voxel grid of a binary surface from its points alone.
 *
 * Marching cubes of a binary segmentation puts every point on the middle of a grid edge: counted in half voxels, exactly one
 * of its coordinates is odd.
 *
 *     values     distinct coordinates along each axis
 *     step       the least difference between two of them, then their whole extent over its multiples: half a voxel
 *     valid if   all values are multiples, and one of the eight parities makes every point the middle of an edge,
 *                and the corners of every triangle lie in one cell
 *
 * Points of a grey-level surface lie anywhere on their edges, and those of a simplified, smoothed or rotated surface anywhere:
 * no step has all values as multiples.
 */
#ifndef BoneDecimate_Core_Input_VoxelGridSearch_h
#define BoneDecimate_Core_Input_VoxelGridSearch_h

#include "LabelMap/VoxelGrid.h"
#include "Surface.h"

#include <optional>

namespace bonedecimate
{
/// With OfPoint for all points and without OfTriangle; the grid's axes are those of the points and its dimensions are not
/// known. Nothing if the surface is not binary, or if a point that a triangle uses is not finite.
std::optional<LabelMapSource> FindVoxelGrid(const Surface& surface);
}

#endif
