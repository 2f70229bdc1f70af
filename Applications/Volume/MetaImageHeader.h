// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MetaImageHeader.h
 * @brief The header of .mha and .mhd files, directions included.
 *
 * VTK's own reader passes over TransformMatrix, and its library writes to the terminal.
 */
#ifndef BoneDecimate_Applications_MetaImageHeader_h
#define BoneDecimate_Applications_MetaImageHeader_h

#include "RawVoxels.h"

#include <string>

namespace bonedecimate::volume
{
/// As ITK reads it: LPS, the first three numbers of TransformMatrix are the direction of the first
/// axis.
VoxelLayout ReadMetaImageHeader(const std::string& path);
}

#endif
