// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NrrdHeader.h
 * @brief The header of .nrrd and .nhdr files, space and directions included.
 *
 * VTK's own reader passes over the directions and over the difference of RAS and LPS.
 */
#ifndef BoneDecimate_Applications_NrrdHeader_h
#define BoneDecimate_Applications_NrrdHeader_h

#include "RawVoxels.h"

#include <string>

namespace bonedecimate::volume
{
/// RAS and LAS are turned into LPS; a file that names no anatomical space is taken as it is.
VoxelLayout ReadNrrdHeader(const std::string& path);
}

#endif
