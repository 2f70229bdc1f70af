// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RawVoxels.h
 * @brief Voxels that lie in a file one after the other, as they are or deflated.
 */
#ifndef BoneDecimate_Applications_RawVoxels_h
#define BoneDecimate_Applications_RawVoxels_h

#include "Volume.h"

#include <array>
#include <cstdint>
#include <string>

namespace bonedecimate::volume
{
/// What a header says about its voxels.
struct VoxelLayout
{
  std::array<std::int64_t, 3> Size{ { 0, 0, 0 } }; ///< The first axis runs fastest.
  int ScalarType = VTK_VOID;                       ///< VTK_SHORT and so on.
  bool IsBigEndian = false;
  bool IsCompressed = false;    ///< By zlib or gzip.
  std::string DataFile;         ///< Where the voxels lie.
  std::int64_t BytesBefore = 0; ///< In DataFile; negative: the voxels are the end of the file.
  VolumeGeometry Geometry;
  bool IsSegmentation = false; ///< The header says that values are labels.
  std::string Problem;         ///< Why the header is rejected; empty if it is not.
};

VoxelLayout RejectedLayout(const std::string& problem);

Volume ReadVoxels(const VoxelLayout& layout);
}

#endif
