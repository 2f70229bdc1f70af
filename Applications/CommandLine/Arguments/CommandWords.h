// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CommandWords.h
 * @brief What is wrong with the options of a command line, in our own sentences, before CLI11
 * parses it.
 */
#ifndef BoneDecimate_Applications_CommandWords_h
#define BoneDecimate_Applications_CommandWords_h

#include "CliForward.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/**
 * Rejects options that the command does not have, options without their value, and options that are
 * given twice and take one value.
 * @param words The name of the command, and what follows it.
 * @throws Failure(ExitCode::Usage)
 */
void RequireOptions(const CLI::App& command, const std::vector<std::string>& words);
}

#endif
