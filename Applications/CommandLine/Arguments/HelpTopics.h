// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HelpTopics.h
 * @brief The options by topic: for -h, which fits one screen, for --help and for the command help.
 */
#ifndef BoneDecimate_Applications_HelpTopics_h
#define BoneDecimate_Applications_HelpTopics_h

#include "CliForward.h"

#include <string>
#include <vector>

namespace bonedecimate
{
struct HelpTopic
{
  std::string Word; ///< What follows "bonedecimate help".
  std::string Title;
  std::vector<std::string> Flags;  ///< Without dashes.
  std::string (*Text)() = nullptr; ///< Below the options; null: none.
};

/// In the order of the help.
const std::vector<HelpTopic>& HelpTopics();

/// The help of -h: usage, commands, and the names of the options by topic.
std::string ShortHelp(const CLI::App& program);

/// "help --max-error" as "help max-error"; anything else as it is.
std::vector<std::string> WithOptionAsWord(std::vector<std::string> words);

/// Adds the command help, which explains a topic, a command or an option.
void AddHelpCommand(CLI::App& program);
}

#endif
