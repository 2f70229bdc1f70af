// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Tree/CommandTree.h"

#include "Arguments/HelpFormatter.h"
#include "Base/Text.h"
#include "Commands/CommandLine.h"
#include "Options/Profiles.h"
#include "Tree/FileKinds.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>

namespace bonedecimate
{
namespace
{
constexpr std::size_t MostOfSummary = 72; // beside a flag on a terminal

std::string InOneLine(std::string text)
{
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

/// "MM" and "LABELS" describe a value, "auto" and "Fast" are values.
bool IsValue(const std::string& word)
{
  return std::any_of(
    word.begin(), word.end(), [](unsigned char letter) { return std::islower(letter) != 0; });
}

std::vector<std::string> ChoicesOf(const std::string& valueName)
{
  std::vector<std::string> choices;
  if (valueName == "EXT")
  {
    return *ExtensionsOfValue("SURFACE");
  }
  if (valueName == "PROFILE")
  {
    return ProfileNames();
  }
  for (const std::string& word : SplitAt(valueName, '|'))
  {
    if (IsValue(word))
    {
      choices.push_back(word);
    }
  }
  return choices;
}

OptionEntry EntryOf(const CLI::Option& option)
{
  OptionEntry entry;
  for (const std::string& name : option.get_snames())
  {
    entry.Flags.push_back("-" + name);
  }
  for (const std::string& name : option.get_lnames())
  {
    entry.Flags.push_back("--" + name);
  }
  const bool takesValue = option.get_items_expected_max() > 0;
  entry.ValueName = option.get_positional() ? option.get_name(true)
    : takesValue                            ? option.get_type_name()
                                            : std::string();
  entry.Choices = ChoicesOf(entry.ValueName);
  entry.Extensions = ExtensionsOfValue(entry.ValueName);
  entry.Help = InOneLine(option.get_description());
  entry.IsRepeatable = option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
  return entry;
}

CommandEntry EntryOf(const CLI::App& command)
{
  CommandEntry entry;
  entry.Name = command.get_name();
  entry.IsDefault = entry.Name == DefaultCommand;
  entry.Usage = UsageOf(command);
  entry.Description = command.get_description();
  for (const CLI::Option* option : command.get_options())
  {
    if (option->get_positional())
    {
      entry.Files = EntryOf(*option);
    }
    else if (!option->get_group().empty())
    {
      entry.Options.push_back(EntryOf(*option));
    }
  }
  return entry;
}
}

std::string OptionEntry::Summary() const
{
  const std::size_t end = this->Help.find(". ");
  std::string sentence = this->Help.substr(0, end);
  if (!sentence.empty() && sentence.back() == '.')
  {
    sentence.pop_back();
  }
  const std::size_t cut = sentence.size() > MostOfSummary ? sentence.rfind(' ', MostOfSummary) : 0;
  return cut == 0 ? sentence : sentence.substr(0, cut) + " ...";
}

std::vector<CommandEntry> CommandTree(const CLI::App& program)
{
  std::vector<CommandEntry> entries;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
  {
    entries.push_back(EntryOf(*command));
  }
  std::stable_partition(
    entries.begin(), entries.end(), [](const CommandEntry& entry) { return entry.IsDefault; });
  return entries;
}

std::vector<std::string> NamesOfCommands(const std::vector<CommandEntry>& commands)
{
  std::vector<std::string> names(commands.size());
  std::transform(commands.begin(), commands.end(), names.begin(),
    [](const CommandEntry& command) { return command.Name; });
  return names;
}

std::string Joined(const std::vector<std::string>& parts, const std::string& joint)
{
  std::string text;
  for (const std::string& part : parts)
  {
    text += (text.empty() ? "" : joint) + part;
  }
  return text;
}

std::string Escaped(const std::string& text, const std::string& characters)
{
  std::string escaped;
  for (const char letter : text)
  {
    escaped += (characters.find(letter) != std::string::npos ? "\\" : "");
    escaped += letter;
  }
  return escaped;
}
}
