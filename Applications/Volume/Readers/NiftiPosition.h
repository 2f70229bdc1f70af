// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NiftiPosition.h
 * @brief Where the voxels of a NIfTI file lie: its header may say it twice, or not at all.
 */
#ifndef BoneDecimate_Applications_NiftiPosition_h
#define BoneDecimate_Applications_NiftiPosition_h

#include "ItkImage.h"
#include "NiftiHeader.h"

#include <array>
#include <cstdint>
#include <string>

namespace bonedecimate::volume
{
/// Why the header gives no position; empty if it gives one.
std::string PositionProblem(const NiftiHeader& header, const ItkHeader& read);

/**
 * Position by the sform, also if it is sheared, if it is that of the scanner or the only one;
 * otherwise by the qform. mm, LPS.
 * @param read What ITK makes of the header.
 */
VolumeGeometry PositionOf(const NiftiHeader& header, const ItkHeader& read);

/// Tells the user that there is no position, or that there are two.
std::string PositionNote(const NiftiHeader& header, const VolumeGeometry& position,
  const std::array<std::int64_t, 3>& size);
}

#endif
