// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FilePath.h
 * @brief Paths of files from their names.
 */
#ifndef BoneDecimate_Applications_FilePath_h
#define BoneDecimate_Applications_FilePath_h

#include <filesystem>
#include <string>

namespace bonedecimate
{
/**
 * The path of a file.
 * @param name In UTF-8, as all names are in the program and as path::string() writes them. The
 * constructor of std::filesystem::path would take a name on Windows for one in another encoding.
 */
inline std::filesystem::path FilePath(const std::string& name)
{
  return std::filesystem::u8path(name);
}
}

#endif
