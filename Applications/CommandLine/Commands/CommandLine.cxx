// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CommandLine.h"

#include "Arguments/CommandWords.h"
#include "Arguments/HelpFormatter.h"
#include "Arguments/HelpTopics.h"
#include "Arguments/NearestWord.h"
#include "ExitCode.h"
#include "FilePath.h"
#include "Settings/Settings.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <memory>
#include <system_error>

namespace bonedecimate
{
namespace
{
/// In the order of the alphabet.
std::vector<std::string> CommandNames(const CLI::App& program)
{
  const auto commands = program.get_subcommands([](const CLI::App*) { return true; });
  std::vector<std::string> names;
  std::transform(commands.begin(), commands.end(), std::back_inserter(names),
    [](const CLI::App* command) { return command->get_name(); });
  std::sort(names.begin(), names.end());
  return names;
}

/// CLI11 takes "[a]" for a list: a folder of that name gets its own path written out.
std::string WithoutList(const std::string& word)
{
  const bool isList = word.size() > 1 && word.front() == '[' && word.back() == ']';
  return isList ? "./" + word : word;
}

/// Our validators continue the name of the flag: "--threads takes a number". CLI11 puts a colon in
/// between.
std::string Sentence(const CLI::ParseError& error)
{
  std::string text = error.what();
  const std::size_t colon = text.find(": takes ");
  return colon == std::string::npos ? text : text.erase(colon, 1);
}

bool RequestsShortHelp(const std::vector<std::string>& words)
{
  const auto end = std::find(words.begin(), words.end(), "--");
  return std::find(words.begin(), end, "-h") != end;
}

void Parse(CLI::App& program, const std::vector<std::string>& words)
{
  std::vector<std::string> reversed; // as CLI11 takes them
  std::transform(words.rbegin(), words.rend(), std::back_inserter(reversed), WithoutList);
  program.parse(std::move(reversed));
}
}

const char* const DefaultCommand = "decimate";

CLI::App& AddCommand(CLI::App& program, const std::string& name,
  const std::vector<std::string>& usage, const std::string& description)
{
  CLI::App* const command = program.add_subcommand(name, description);
  command->formatter(std::make_shared<HelpFormatter>(usage));
  command->footer(ExitCodesText());
  return *command;
}

const CLI::App* FindCommand(const CLI::App& program, const std::string& name)
{
  const auto found =
    program.get_subcommands([&name](const CLI::App* one) { return one->get_name() == name; });
  return found.empty() ? nullptr : found.front();
}

void RunCommandLine(CLI::App& program, std::vector<std::string> words)
{
  const std::vector<std::string> names = CommandNames(program);
  if (words.empty() || std::find(names.begin(), names.end(), words.front()) == names.end())
  {
    if (!words.empty())
    {
      RequireCommandOrFile(program, words.front());
    }
    words.insert(words.begin(), DefaultCommand);
  }
  RequireOptions(*program.get_subcommand(words.front()), words);
  if (words.front() == DefaultCommand && RequestsShortHelp(words))
  {
    std::cout << ShortHelp(program);
    return;
  }
  const SettledWords settled = WithSettings(program, words);
  try
  {
    Parse(program, settled.Words);
  }
  catch (const CLI::ParseError& error)
  {
    if (error.get_exit_code() != 0)
    {
      const CLI::App& command = *program.get_subcommand(words.front());
      throw Failure(ExitCode::Usage,
        WithOrigin(Sentence(error), settled.Added) + "; see " + CommandPath(command) + " -h");
    }
    program.exit(error, std::cout, std::cerr);
  }
  catch (const Failure& failure)
  {
    throw Failure(failure.Code, WithOrigin(failure.what(), settled.Added));
  }
}

void RequireCommandOrFile(const CLI::App& program, const std::string& word)
{
  std::error_code error;
  const bool isFileName = word.find_first_of("./") != std::string::npos;
  if (word.empty() || word[0] == '-' || isFileName ||
    std::filesystem::exists(FilePath(word), error))
  {
    return;
  }
  const std::vector<std::string> commands = CommandNames(program);
  const std::string nearest = NearestWord(word, commands);
  throw Failure(ExitCode::Usage,
    "'" + word + "' is neither a command nor a file; " +
      (nearest.empty() ? "the commands are " + CLI::detail::join(commands, ", ")
                       : "did you mean " + nearest + "?"));
}
}
