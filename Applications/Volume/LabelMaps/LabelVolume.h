// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelVolume.h
 * @brief A label map in, an image with its position in the patient out.
 */
#ifndef BoneDecimate_Applications_LabelVolume_h
#define BoneDecimate_Applications_LabelVolume_h

#include "SegmentSelection.h"
#include "Volume.h"
#include "VoxelSpacing.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <string>

namespace bonedecimate
{
struct LabelVolume
{
  /**
   * One label a voxel; origin, spacing and direction in mm (LPS). Of a segmentation it has the
   * field arrays LabelValues, LabelNames and LabelColors (red, green and blue, 0 to 1), as
   * vtkBoneSurfaces takes them. Null if rejected.
   */
  vtkSmartPointer<vtkImageData> Image;
  std::string Problem; ///< Why it was rejected; empty if it was not.
  std::string Note;    ///< What of the input was left aside, for the user; may be empty.
};

/// How far voxels move where axes are perpendicular only but for rounding; empty if they do not
/// move.
std::string LabelGridNote(
  const volume::VolumeGeometry& geometry, const std::array<std::int64_t, 3>& size);

/// Sets origin, spacing and direction: the nearest perpendicular one, or that of a sheared grid.
/// @param layers If their distance changes: they become the field array VoxelGridLayers, as
///   vtkBoneSurfaces takes it.
void SetLabelGrid(const volume::VolumeGeometry& geometry, const volume::LayerPositions& layers,
  vtkImageData* image);

/// Reads every format that ExtractBoneSurface() reads.
LabelVolume ReadLabelVolume(const std::string& path, const VoxelSpacing& spacing = {},
  const SegmentSelection& selection = {});
}

#endif
