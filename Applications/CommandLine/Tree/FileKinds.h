// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FileKinds.h
 * @brief Which files the value of an option is, by its name in the help.
 */
#ifndef BoneDecimate_Applications_FileKinds_h
#define BoneDecimate_Applications_FileKinds_h

#include <optional>
#include <string>
#include <vector>

namespace bonedecimate
{
/**
 * The extensions of the files that a value of this name is, without dots; empty: files of any name.
 * Folders are always possible.
 * @param valueName As in the help: "SURFACE", "JSON", "FILES".
 * @return Nothing if the value is no file.
 */
std::optional<std::vector<std::string>> ExtensionsOfValue(const std::string& valueName);
}

#endif
