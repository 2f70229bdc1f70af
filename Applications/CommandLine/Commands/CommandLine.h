// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CommandLine.h
 * @brief The subcommands of the program and the parsing of a command line. A line without a
 * subcommand is a decimation.
 */
#ifndef BoneDecimate_Applications_CommandLine_h
#define BoneDecimate_Applications_CommandLine_h

#include "Arguments/CliForward.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/// The subcommand of a command line that names none.
extern const char* const DefaultCommand;

/// @param usage What follows the name of the command; further lines are other forms of the same
///   command.
CLI::App& AddCommand(CLI::App& program, const std::string& name,
  const std::vector<std::string>& usage, const std::string& description);

/// The command of that name; null if there is none.
const CLI::App* FindCommand(const CLI::App& program, const std::string& name);

/**
 * Parses and, by the callbacks of the subcommand, runs.
 * @param words Without the name of the program.
 * @throws Failure(ExitCode::Usage), and whatever a callback throws.
 */
void RunCommandLine(CLI::App& program, std::vector<std::string> words);

/**
 * Rejects a first word that is neither a command nor a file, and names the command that may be
 * meant. Words with a dot or a slash are names of files.
 * @throws Failure(ExitCode::Usage)
 */
void RequireCommandOrFile(const CLI::App& program, const std::string& word);
}

#endif
