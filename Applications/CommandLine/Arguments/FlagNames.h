// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FlagNames.h
 * @brief Sentences of the core and the filters, which name options as properties, in the words of
 * the command line.
 */
#ifndef BoneDecimate_Applications_FlagNames_h
#define BoneDecimate_Applications_FlagNames_h

#include <string>

namespace bonedecimate
{
/// The sentence with a flag in place of each property that has one: "--smooth" for "Smoothing".
/// Only whole words count, and no parts of file names.
std::string WithFlags(const std::string& sentence);
}

#endif
