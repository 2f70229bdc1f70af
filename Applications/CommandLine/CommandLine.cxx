// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CommandLine.h"

#include "ExitCode.h"
#include "HelpFormatter.h"
#include "Options/Text.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <memory>
#include <numeric>
#include <system_error>

namespace bonedecimate
{
namespace
{
/// Letters to insert, remove or replace: V. Levenshtein, 1966.
std::size_t EditDistance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({ replaced, row[j] + 1, diagonal + 1 });
    }
  }
  return row.back();
}

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

/// Our validators continue the name of the flag: "--threads takes a number". CLI11 puts a colon in between.
std::string Sentence(const CLI::ParseError& error)
{
  std::string text = error.what();
  const std::size_t colon = text.find(": takes ");
  return colon == std::string::npos ? text : text.erase(colon, 1);
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
  try
  {
    Parse(program, words);
  }
  catch (const CLI::ParseError& error)
  {
    if (error.get_exit_code() != 0)
    {
      const CLI::App& command = *program.get_subcommand(words.front());
      throw Failure(ExitCode::Usage, Sentence(error) + "; see " + CommandPath(command) + " --help");
    }
    program.exit(error, std::cout, std::cerr);
  }
}

void RequireCommandOrFile(const CLI::App& program, const std::string& word)
{
  constexpr std::size_t mostEdits = 2;
  std::error_code error;
  const bool isFileName = word.find_first_of("./") != std::string::npos;
  if (word.empty() || word[0] == '-' || isFileName || std::filesystem::exists(word, error))
  {
    return;
  }
  std::string names;
  for (const std::string& command : CommandNames(program))
  {
    names.append(names.empty() ? "" : ", ").append(command);
    if (EditDistance(LowerCase(word), command) <= mostEdits)
    {
      std::string message = "'" + word + "' is neither a command nor a file; did you mean ";
      message.append(command).append("?");
      throw Failure(ExitCode::Usage, message);
    }
  }
  throw Failure(
    ExitCode::Usage, "'" + word + "' is neither a command nor a file; the commands are " + names);
}

void RequireNotInput(const std::string& file, const std::vector<std::string>& inputs)
{
  for (const std::string& input : inputs)
  {
    std::error_code error;
    if (std::filesystem::equivalent(file, input, error))
    {
      throw Failure(ExitCode::Usage, "'" + file + "' is an input; it is not overwritten");
    }
  }
}
}
