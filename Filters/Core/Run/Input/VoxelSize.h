// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VoxelSize.h
 * @brief Estimates the voxel size of the scan from which a surface comes, and derives the
 * largest error of a preset from it.
 *
 * Marching cubes puts every vertex on an edge of the grid: two of its coordinates are those of grid
 * planes, the third is interpolated. Along each axis the planes are therefore the values that occur
 * most often:
 *
 *     values      equal coordinates, counted
 *     planes      values that occur at least an eighth as often as those of a tenth of the vertices
 *     spacing     median step between planes, then their whole extent over the number of steps
 *     valid if    nearly all steps are multiples of it, and enough vertices lie on planes
 *
 * Otherwise (smoothed, rotated or simplified surfaces) the estimate uses the median edge length.
 * W. E. Lorensen, H. E. Cline, Marching cubes, 1987.
 */
#ifndef BoneDecimate_Core_Run_Input_VoxelSize_h
#define BoneDecimate_Core_Run_Input_VoxelSize_h

#include "Figures/InputFigures.h"
#include "Geometry/Surface.h"
#include "Options/Options.h"

namespace bonedecimate
{
struct VoxelEstimate
{
  Vector3 Spacing = Vector3::Zero(); ///< mm, along each axis; 0 if there is no estimate.
  bool IsFromGrid = false;           ///< False: from edge lengths, the same along each axis.
  /// Relative uncertainty of the spacing, from uneven planes or varying edges.
  double RelativeError = 0.0;

  double Least() const { return this->Spacing.minCoeff(); } ///< mm
};

/// Points that are not finite are ignored.
VoxelEstimate EstimateVoxelSize(const Surface& surface);

/// Replaces the error preset of the options, if there is one, by a largest error.
/// @returns The figures for the report.
VoxelFigures ApplyPreset(const Surface& surface, Options& options);
}

#endif
