// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DeprecatedNames.h
 * @brief Names of 0.1 development versions that still work for one release. The next release deletes this file and its calls.
 */
#ifndef BoneDecimate_Applications_DeprecatedNames_h
#define BoneDecimate_Applications_DeprecatedNames_h

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace bonedecimate
{
/**
 * @param words The command line without the name of the program.
 * @returns The words with the current names of flags and commands. Prints one line on the standard error for each that changes.
 */
std::vector<std::string> WithCurrentNames(std::vector<std::string> words);

/// Adds the deprecated keys of a JSON report, with the values of the current ones, and lists them under "deprecated_keys".
void AddDeprecatedKeys(nlohmann::ordered_json& report);
}

#endif
