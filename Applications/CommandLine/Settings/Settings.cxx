// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Settings/Settings.h"

#include "Arguments/HelpFormatter.h"
#include "Arguments/NearestWord.h"
#include "Base/Text.h"
#include "Commands/CommandLine.h"
#include "ExitCode.h"
#include "Files/FileNames.h"
#include "Options/Profiles.h"
#include "Settings/ConfigurationFile.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <map>
#include <optional>

namespace bonedecimate
{
namespace
{
constexpr const char* RecordFlag = "--settings-record";

/// The options that words set: flag without dashes, and value.
using TypedOptions = std::map<std::string, std::string>;

TypedOptions TypedOptionsOf(const CLI::App& command, const std::vector<std::string>& words)
{
  TypedOptions typed;
  for (std::size_t i = 1; i < words.size() && words[i] != "--"; ++i)
  {
    const std::size_t equals = words[i].find('=');
    const CLI::Option* const option = words[i].compare(0, 2, "--") == 0
      ? command.get_option_no_throw(words[i].substr(0, equals))
      : nullptr;
    if (option == nullptr)
    {
      continue;
    }
    std::string value = equals == std::string::npos ? "" : words[i].substr(equals + 1);
    if (equals == std::string::npos && option->get_items_expected_max() > 0 && i + 1 < words.size())
    {
      value = words[++i];
    }
    for (const std::string& name : option->get_lnames())
    {
      typed[name] = value;
    }
  }
  return typed;
}

SettingsList BuiltIn(const Profile& profile, const std::string& command)
{
  SettingsList list;
  for (const ProfileOption& option : profile.Options)
  {
    if (command == DefaultCommand || (command == "levels" && option.IsForLevels))
    {
      list.push_back({ option.Flag, { option.Value } });
    }
  }
  return list;
}

[[noreturn]] void RejectName(const std::string& name, const std::optional<ConfigurationFile>& file)
{
  std::vector<std::string> names = ProfileNames();
  const std::vector<std::string> own = file ? file->GetProfiles() : std::vector<std::string>();
  names.insert(names.end(), own.begin(), own.end());
  const std::string nearest = NearestWord(name, names);
  throw Failure(ExitCode::Usage,
    "--profile '" + name + "' is none of " + CLI::detail::join(names, ", ") +
      (nearest.empty() ? "" : "; did you mean " + nearest + "?"));
}

/// @param name In the file, or built in.
SettingsList OptionsOfProfile(
  const std::string& name, const std::string& command, const std::optional<ConfigurationFile>& file)
{
  std::map<std::string, SettingsList> byCommand;
  const Profile* const profile = FindProfile(name);
  if (file)
  {
    byCommand = file->OptionsOfProfile(name);
  }
  if (byCommand.empty() && profile == nullptr)
  {
    RejectName(name, file);
  }
  if (byCommand.empty())
  {
    byCommand = { { DefaultCommand, BuiltIn(*profile, DefaultCommand) },
      { "levels", BuiltIn(*profile, "levels") } };
  }
  if (byCommand.count(command) == 0)
  {
    std::vector<std::string> commands;
    std::transform(byCommand.begin(), byCommand.end(), std::back_inserter(commands),
      [](const auto& one) { return one.first; });
    throw Failure(ExitCode::Usage,
      "--profile " + name + " sets nothing for " + command + "; it is for " +
        CLI::detail::join(commands, " and "));
  }
  return byCommand[command];
}

bool IsSet(const std::string& flag, const TypedOptions& options)
{
  const std::vector<std::string> alternatives = AlternativesTo(flag);
  return std::any_of(alternatives.begin(), alternatives.end(),
    [&options](const std::string& one) { return options.count(one) > 0; });
}

/// Adds what is not set yet.
void Add(const SettingsList& list, const TypedOptions& typed, SettledWords& settled)
{
  const TypedOptions before = settled.Added.Options;
  for (const auto& [flag, values] : list)
  {
    if (IsSet(flag, typed))
    {
      settled.Added.Overridden.push_back(flag);
    }
    else if (!IsSet(flag, before))
    {
      for (const std::string& value : values)
      {
        std::string word = "--" + flag;
        word.append("=").append(value);
        settled.Words.insert(settled.Words.begin() + 1, word);
      }
      if (values.empty())
      {
        settled.Words.insert(settled.Words.begin() + 1, "--" + flag);
      }
      settled.Added.Options[flag] = CLI::detail::join(values, ";");
    }
  }
}
}

void AddSettings(CLI::App& command, SettingsRecord& record)
{
  const auto ignore = [](const std::string&) {};
  command
    .add_option_function<std::string>("--profile", ignore,
      WrappedHelp(
        "Set the options of this profile that the command line does not set: built in are " +
        CLI::detail::join(ProfileNames(), ", ") +
        ", for decimate and levels; others are in the file of --config."))
    ->type_name("PROFILE")
    ->configurable(false);
  command
    .add_option_function<std::string>("--config", ignore,
      WrappedHelp("Set the options that this file has, outside of its profiles, and that neither "
                  "the command line nor the "
                  "profile sets."))
    ->type_name("TOML")
    ->configurable(false);
  command
    .add_option_function<std::string>(RecordFlag,
      [&command, &record](const std::string& text)
      {
        record = ReadSettings(text);
        if (command.count("--quiet") == 0)
        {
          std::cout << SettingsSentence(record) << "\n";
        }
      })
    ->group("")
    ->configurable(false);
}

std::vector<std::string> WordsOfSettings(const SettingsRecord& record)
{
  return record.IsEmpty() ? std::vector<std::string>()
                          : std::vector<std::string>{ RecordFlag, SettingsText(record) };
}

SettledWords WithSettings(const CLI::App& program, const std::vector<std::string>& words)
{
  SettledWords settled = { words, {} };
  const CLI::App& command = *program.get_subcommand(words.front());
  const TypedOptions typed = TypedOptionsOf(command, words);
  const auto profile = typed.find("profile");
  const auto config = typed.find("config");
  if (profile == typed.end() && config == typed.end())
  {
    return settled;
  }
  std::optional<ConfigurationFile> file;
  if (config != typed.end())
  {
    settled.Added.File = BaseName(config->second);
    file.emplace(config->second, program);
  }
  if (profile != typed.end())
  {
    const SettingsList list = OptionsOfProfile(profile->second, command.get_name(), file);
    const Profile* const builtIn = FindProfile(profile->second);
    const bool isOfFile = file && !file->OptionsOfProfile(profile->second).empty();
    settled.Added.Profile = isOfFile || builtIn == nullptr ? profile->second : builtIn->Name;
    Add(list, typed, settled);
  }
  if (file)
  {
    Add(file->OptionsOf(command.get_name()), typed, settled);
  }
  const std::vector<std::string> record = WordsOfSettings(settled.Added);
  settled.Words.insert(settled.Words.begin() + 1, record.begin(), record.end());
  return settled;
}
}
