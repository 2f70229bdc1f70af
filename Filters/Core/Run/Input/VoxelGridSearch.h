// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VoxelGridSearch.h
 * @brief Finds the voxel grid of a binary surface from its points alone.
 *
 * Marching cubes of a binary segmentation puts every point on the middle of a grid edge: counted in
 * half voxels, exactly one of its coordinates is odd.
 *
 *     axes       those of the coordinates, then those of GridDirection.h
 *     values     distinct coordinates along each axis
 *     step       the least difference between two of them, then their whole extent
 *                over its multiples: half a voxel
 *     valid if   all values are multiples, and for one of the eight parities
 *                FindGridPoints() finds every point
 *
 * Points of a grey-level surface lie anywhere on their edges, and those of a simplified or smoothed
 * surface anywhere: no step has all values as multiples.
 */
#ifndef BoneDecimate_Core_Run_Input_VoxelGridSearch_h
#define BoneDecimate_Core_Run_Input_VoxelGridSearch_h

#include "Geometry/Surface.h"
#include "Labels/LabelMap/VoxelGrid.h"

#include <optional>
#include <vector>

namespace bonedecimate
{
/// Where in the grid each point is. Nothing if one is not the middle of a grid edge, or if the
/// corners of a triangle do not lie in one cell: then the surface was not extracted from the labels
/// of that grid, or was changed since.
std::optional<std::vector<GridPoint>> FindGridPoints(const Surface& surface, const VoxelGrid& grid);

/// With OfPoint for all points and without OfTriangle; the grid's dimensions are not known. Nothing
/// if the surface is not binary, or if a point that a triangle uses is not finite.
std::optional<LabelMapSource> FindVoxelGrid(const Surface& surface);
}

#endif
