// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FileNames.h
 * @brief Parts of the names of files.
 */
#ifndef BoneDecimate_Applications_FileNames_h
#define BoneDecimate_Applications_FileNames_h

#include <string>

namespace bonedecimate
{
/// The extension in lower case, without its dot; of "a.b/NAME.STL" it is "stl".
std::string ExtensionOf(const std::string& path);

/// The last part of a path: reports name files without their folders.
std::string BaseName(const std::string& path);
}

#endif
