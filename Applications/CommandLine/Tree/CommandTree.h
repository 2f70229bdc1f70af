// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CommandTree.h
 * @brief The commands and options of the program as plain data, for whatever describes them:
 * completions of shells, the manual page.
 */
#ifndef BoneDecimate_Applications_CommandTree_h
#define BoneDecimate_Applications_CommandTree_h

#include "Arguments/CliForward.h"

#include <optional>
#include <string>
#include <vector>

namespace bonedecimate
{
struct OptionEntry
{
  std::vector<std::string> Flags;   ///< With dashes; of positional files empty.
  std::string ValueName;            ///< As in the help: "MM|auto"; empty: a switch.
  std::vector<std::string> Choices; ///< Words that the value can be; there may be other values.
  /// If the value is a file: see ExtensionsOfValue().
  std::optional<std::vector<std::string>> Extensions;
  std::string Help; ///< In one line.
  bool IsRepeatable = false;

  /// The first sentence of the help or its beginning, without its period.
  std::string Summary() const;
};

struct CommandEntry
{
  std::string Name;
  bool IsDefault = false;         ///< What a command line without a command is.
  std::vector<std::string> Usage; ///< What follows the name of the command, one form each.
  std::string Description;
  OptionEntry Files; ///< The positional files.
  std::vector<OptionEntry> Options;
};

/// The default command first, the others in the order of the help.
std::vector<CommandEntry> CommandTree(const CLI::App& program);

/// The names of the commands that are written out.
std::vector<std::string> NamesOfCommands(const std::vector<CommandEntry>& commands);

/// The parts with the joint in between.
std::string Joined(const std::vector<std::string>& parts, const std::string& joint);

/// The text with a backslash before each of the characters.
std::string Escaped(const std::string& text, const std::string& characters);
}

#endif
