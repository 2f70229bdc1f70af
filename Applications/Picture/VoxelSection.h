// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VoxelSection.h
 * @brief The section of a page about the voxels of a label map.
 */
#ifndef BoneDecimate_Applications_VoxelSection_h
#define BoneDecimate_Applications_VoxelSection_h

#include "ReportFields.h"

#include <optional>
#include <string>

namespace bonedecimate
{
/// The section as HTML; empty if the voxels were not compared.
std::string VoxelSection(const ReportFields& report);

/// The largest error, in units of the smallest spacing of the voxels; nothing if there is none or
/// the grid is not known.
std::optional<double> BoundInVoxels(const ReportFields& report);

/// The ratio of the voxels that have a label in the map and keep it, without the background;
/// nothing if they were not compared.
std::optional<double> KeptVoxels(const ReportFields& report);

/// "3 (femur)", or "3" without a name.
std::string NameOfLabel(const ReportFields& report, const std::string& label);
}

#endif
