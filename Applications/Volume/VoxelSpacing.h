// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VoxelSpacing.h
 * @brief The spacing of files that have none.
 */
#ifndef BoneDecimate_Applications_VoxelSpacing_h
#define BoneDecimate_Applications_VoxelSpacing_h

#include <array>
#include <optional>
#include <string>

namespace bonedecimate
{
/// mm along x, y and z, of volumes for which NeedsSpacing().
using VoxelSpacing = std::optional<std::array<double, 3>>;

/// True for a TIFF file of several pages, for a folder of TIFF slices, and for other volumes whose
/// header has no spacing.
bool NeedsSpacing(const std::string& path);
}

#endif
