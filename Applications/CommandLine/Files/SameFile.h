// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SameFile.h
 * @brief Files that are written must not be those that are read, nor each other.
 */
#ifndef BoneDecimate_Applications_SameFile_h
#define BoneDecimate_Applications_SameFile_h

#include <string>
#include <vector>

namespace bonedecimate
{
/// Whether both names are of one file, which need not be there yet.
bool IsSameFile(const std::string& a, const std::string& b);

/**
 * @param outputs Files that are written. Empty names are none, of the inputs, too.
 * @throws Failure(ExitCode::Usage) if an output is an input or replaces a file in a folder that is
 * one, such as a slice, or two outputs are one file.
 */
void RequireDistinct(
  const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);
}

#endif
