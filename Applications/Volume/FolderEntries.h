// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FolderEntries.h
 * @brief What is in a folder.
 */
#ifndef BoneDecimate_Applications_FolderEntries_h
#define BoneDecimate_Applications_FolderEntries_h

#include <filesystem>
#include <system_error>
#include <vector>

namespace bonedecimate
{
/**
 * What is in a folder, in the order of its names: the system lists it in any order.
 * @param error Receives why the folder, or the rest of it, could not be read.
 */
std::vector<std::filesystem::path> FolderEntries(
  const std::filesystem::path& folder, std::error_code& error);
}

#endif
