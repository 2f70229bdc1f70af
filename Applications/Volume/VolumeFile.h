// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VolumeFile.h
 * @brief A volume from a file of any format that is read, or from a folder of DICOM files or TIFF
 * slices; whole or layer by layer.
 */
#ifndef BoneDecimate_Applications_VolumeFile_h
#define BoneDecimate_Applications_VolumeFile_h

#include "IsolatedReader.h"
#include "LabelMaps/SegmentSelection.h"
#include "Volume.h"
#include "VoxelSpacing.h"

#include <memory>
#include <string>

namespace bonedecimate::volume
{
/// Opens a volume; the extension decides on the reader.
/// @param spacing Spacing of files without one.
/// @param selection Selection of segments that overlap.
std::unique_ptr<IsolatedReader> OpenVolume(const std::string& path,
  const VoxelSpacing& spacing = {}, const SegmentSelection& selection = {});

/// All voxels.
Volume ReadVolume(const std::string& path, const VoxelSpacing& spacing = {},
  const SegmentSelection& selection = {});
}

#endif
