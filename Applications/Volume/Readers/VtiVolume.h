// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VtiVolume.h
 * @brief VTK's own image files.
 */
#ifndef BoneDecimate_Applications_VtiVolume_h
#define BoneDecimate_Applications_VtiVolume_h

#include "Volume.h"

#include <string>

namespace bonedecimate::volume
{
/// May end the process on damaged files: to be called by an IsolatedReader.
Volume ReadVti(const std::string& path);

/// Whether the file says how far voxels are apart; VTK takes 1 if not.
bool VtiHasSpacing(const std::string& path);
}

#endif
