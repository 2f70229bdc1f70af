// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VoxelSize.h
 * @brief The voxels of the scan a surface comes from, and what share of one may be given away.
 *
 * Marching cubes puts every vertex on an edge of the grid: two of its coordinates are those of grid planes, the third is
 * interpolated. Along each axis the planes are therefore the values that occur again and again:
 *
 *     values      equal coordinates, counted
 *     planes      values that occur at least an eighth as often as those of a tenth of the vertices
 *     spacing     median step between planes, then their whole extent over the number of steps
 *     is found    nearly all steps are whole multiples of it, and enough of the vertices lie on planes
 *
 * Where that is not so (smoothed, turned or already simplified surfaces) the median edge length has to do.
 * W. E. Lorensen, H. E. Cline, Marching cubes, 1987.
 */
#ifndef BoneDecimate_Core_VoxelSize_h
#define BoneDecimate_Core_VoxelSize_h

#include "Report.h"
#include "Surface.h"

namespace bonedecimate
{
struct VoxelEstimate
{
  Vector3 Spacing = Vector3::Zero(); ///< mm, along each axis; 0 if nothing could be estimated.
  bool IsFromGrid = false;           ///< Else from the edges: the same along each axis.
  double RelativeError =
    0.0; ///< Of the spacing, as far as the planes are uneven, or as edges vary.

  double Least() const { return this->Spacing.minCoeff(); } ///< mm
};

/// Points that are not finite do not count.
VoxelEstimate EstimateVoxelSize(const Surface& surface);

/// Makes a largest error of the preset, if there is one, which is gone then.
/// @returns What to report of it.
VoxelFigures ApplyPreset(const Surface& surface, Options& options);
}

#endif
