// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Words.h
 * @brief The words of a command line on their way to the parser.
 */
#ifndef BoneDecimate_Applications_Words_h
#define BoneDecimate_Applications_Words_h

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace bonedecimate
{
/// CLI11 takes its words in reverse, and "[a]" for a list: a folder of that name gets its own path
/// written out.
std::vector<std::string> WordsOf(int argc, char* argv[], int first);

/// False if a text was asked for, which is printed then.
/// @throws Failure(ExitCode::Usage)
bool ParseWords(CLI::App& app, std::vector<std::string> words);

/**
 * Refuses a first word that is neither a command nor a file, and names the command that may be meant. Words with a dot or a
 * slash are names of files.
 * @throws Failure(ExitCode::Usage)
 */
void RequireCommandOrFile(const std::string& word);
}

#endif
