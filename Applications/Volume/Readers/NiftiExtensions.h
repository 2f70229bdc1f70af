// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NiftiExtensions.h
 * @brief What programs add to the header of a NIfTI file.
 */
#ifndef BoneDecimate_Applications_NiftiExtensions_h
#define BoneDecimate_Applications_NiftiExtensions_h

#include <string>
#include <vector>

namespace bonedecimate
{
/// The contents of the extensions between header and voxels, without the zeros at their ends; empty
/// of any other file.
std::vector<std::string> ReadNiftiExtensions(const std::string& path);
}

#endif
