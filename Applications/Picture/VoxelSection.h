// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VoxelSection.h
 * @brief The section of a page about the voxels of a label map.
 */
#ifndef BoneDecimate_Applications_VoxelSection_h
#define BoneDecimate_Applications_VoxelSection_h

#include "ReportFields.h"

#include <string>

namespace bonedecimate
{
/// As HTML; empty if the voxels were not compared.
std::string VoxelSection(const ReportFields& report);
}

#endif
