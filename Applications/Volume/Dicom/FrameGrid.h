// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FrameGrid.h
 * @brief The grid of voxels on which the frames of a DICOM file lie.
 */
#ifndef BoneDecimate_Applications_FrameGrid_h
#define BoneDecimate_Applications_FrameGrid_h

#include "Volume.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace bonedecimate::volume
{
/// Where a frame lies, as its header says.
struct FramePlacement
{
  Vector3 Position{ { 0.0, 0.0, 0.0 } };    ///< mm, of the first pixel.
  Vector3 AlongRow{ { 0.0, 0.0, 0.0 } };    ///< Direction of growing column index.
  Vector3 AlongColumn{ { 0.0, 0.0, 0.0 } }; ///< Direction of growing row index.
  double RowDistance = 0.0;                 ///< mm, from a row to the next.
  double ColumnDistance = 0.0;
};

struct FrameGrid
{
  VolumeGeometry Geometry; ///< Right-handed, and perpendicular unless the gantry was tilted.
  LayerPositions Layers;   ///< Set if the distance of planes changes on purpose.
  std::int64_t Planes = 0; ///< Number of planes, also of those without a frame.
  std::vector<std::int64_t> PlaneOf; ///< Plane of each frame.
  std::int64_t PlanesWithoutFrames = 0;
  std::string Note;    ///< How the distances of planes change; empty if they do not.
  std::string Problem; ///< Why there is no grid; empty if there is one.
};

/**
 * Several frames may lie in a plane, and planes may have none. What rounding of the header shifts
 * by less than a fifth of a voxel is put onto the grid.
 * @param frames At least one.
 * @param planeDistance What the header says of it, mm. If that is 0 or more than 2 % off, planes
 * are where frames are if their distances change on purpose (SpacingRuns.h), or else the median of
 * their distances apart.
 * @param size Columns and rows.
 */
FrameGrid GridOfFrames(const std::vector<FramePlacement>& frames, double planeDistance,
  const std::array<std::int64_t, 2>& size);
}

#endif
