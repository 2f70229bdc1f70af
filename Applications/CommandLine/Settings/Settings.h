// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Settings.h
 * @brief --profile and --config: options that are not typed. They become words of the command line
 * before it is parsed.
 */
#ifndef BoneDecimate_Applications_Settings_h
#define BoneDecimate_Applications_Settings_h

#include "Arguments/CliForward.h"
#include "Settings/SettingsRecord.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/// Adds --profile and --config to a command. @param record Gets what they added.
void AddSettings(CLI::App& command, SettingsRecord& record);

/// The words that hand a record to a child process, whose command line has the options already.
std::vector<std::string> WordsOfSettings(const SettingsRecord& record);

struct SettledWords
{
  std::vector<std::string> Words;
  SettingsRecord Added;
};

/**
 * The words with the options of the profile and of the file that they name. What the command line
 * sets, in this or another way (AlternativesTo()), stays; the profile takes precedence over the
 * rest of the file.
 * @param words With the name of the command first.
 * @throws Failure(ExitCode::Usage)
 */
SettledWords WithSettings(const CLI::App& program, const std::vector<std::string>& words);
}

#endif
