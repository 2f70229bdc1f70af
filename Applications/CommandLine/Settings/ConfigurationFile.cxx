// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Settings/ConfigurationFile.h"

#include "Arguments/NearestWord.h"
#include "Commands/CommandLine.h"
#include "ExitCode.h"
#include "FilePath.h"
#include "Files/FileNames.h"
#include "Formats/FileChecks.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace bonedecimate
{
namespace
{
const std::string ProfilesSection = "profiles";

/// Limits the parts of a name, because CLI11 copies all earlier parts for each; three are in use.
constexpr std::ptrdiff_t MaxParts = 8;

/// A failure about a file.
[[noreturn]] void Fail(const std::string& file, const std::string& sentence)
{
  throw Failure(ExitCode::Usage, "'" + BaseName(file) + "' " + sentence);
}

/// CLI11 takes a line without an equals sign for a switch that is on, and its points for sections.
void RequireKeysAndValues(const std::string& path, std::istream& stream)
{
  bool isInArray = false; // of several lines
  int number = 0;
  for (std::string line; std::getline(stream, line);)
  {
    ++number;
    const std::string whole = CLI::detail::trim_copy(line);
    const bool isComment = whole.rfind(';', 0) == 0;
    const std::string text =
      isComment ? "" : CLI::detail::trim_copy(whole.substr(0, whole.find('#')));
    const std::size_t equals = text.find('=');
    const bool isSection = !text.empty() && text.front() == '[' && text.back() == ']';
    const bool isPair = equals != std::string::npos && equals > 0;
    if (!isInArray && !text.empty() && !isSection && !isPair)
    {
      Fail(path,
        "has in line " + std::to_string(number) + " '" + PrintableText(text) +
          "', which is neither KEY = VALUE nor a [SECTION]");
    }
    const std::string name = isSection ? text : text.substr(0, isPair ? equals : 0);
    if (!isInArray && std::count(name.begin(), name.end(), '.') >= MaxParts)
    {
      Fail(path,
        "has in line " + std::to_string(number) + " a name of more than " +
          std::to_string(MaxParts) + " parts");
    }
    const std::string value =
      isPair && !isInArray ? CLI::detail::trim_copy(text.substr(equals + 1)) : text;
    const bool begins = !isInArray && isPair && value.size() > 1 && value.front() == '[';
    isInArray = (isInArray || begins) && (value.empty() || value.back() != ']');
  }
}

std::vector<CLI::ConfigItem> ItemsOf(const std::string& path)
{
  std::error_code error;
  std::ifstream stream(path, std::ios::binary);
  if (std::filesystem::is_directory(FilePath(path), error) || !stream)
  {
    Fail(path, "could not be read");
  }
  RequireKeysAndValues(path, stream);
  stream.clear();
  stream.seekg(0);
  std::vector<CLI::ConfigItem> items = CLI::ConfigTOML().from_config(stream);
  items.erase(std::remove_if(items.begin(), items.end(),
                [](const CLI::ConfigItem& item) { return item.name == "++" || item.name == "--"; }),
    items.end());
  return items;
}

/// The options that a file may set.
std::vector<std::string> KeysOf(const CLI::App& command)
{
  std::vector<std::string> keys;
  for (const CLI::Option* option : command.get_options())
  {
    if (option->nonpositional() && option->get_configurable() && !option->get_group().empty())
    {
      const std::vector<std::string>& names = option->get_lnames();
      keys.insert(keys.end(), names.begin(), names.end());
    }
  }
  return keys;
}

std::string SectionText(const CLI::ConfigItem& item)
{
  return item.parents.empty() ? "" : " of [" + CLI::detail::join(item.parents, ".") + "]";
}

/// Where the options of an item go.
struct Section
{
  std::string Profile; ///< Empty: none.
  std::string Command;
};

class Reader
{
public:
  Reader(const std::string& file, const CLI::App& program)
    : File(file)
    , Program(program)
  {
  }

  Section SectionOf(const CLI::ConfigItem& item) const
  {
    std::vector<std::string> parents = item.parents;
    Section section;
    if (!parents.empty() && parents.front() == ProfilesSection)
    {
      if (parents.size() < 2)
      {
        Fail(this->File, "has '" + item.name + "' in [profiles]; options go into [profiles.NAME]");
      }
      section.Profile = parents[1];
      parents.erase(parents.begin(), parents.begin() + 2);
    }
    section.Command = parents.empty() ? DefaultCommand : parents.front();
    if (parents.size() > 1 || FindCommand(this->Program, section.Command) == nullptr)
    {
      Fail(this->File,
        "has the section [" + CLI::detail::join(item.parents, ".") +
          "], which is neither a command nor profiles.NAME");
    }
    return section;
  }

  /// @return Nothing for a switch that is off.
  void Add(const CLI::ConfigItem& item, const CLI::App& command, SettingsList& list) const
  {
    const CLI::Option& option = this->OptionOf(item, command);
    const bool isTwice = std::any_of(
      list.begin(), list.end(), [&item](const auto& other) { return other.first == item.name; });
    if (isTwice)
    {
      Fail(this->File, "has '" + item.name + "'" + SectionText(item) + " twice");
    }
    if (option.get_items_expected_max() == 0)
    {
      if (item.inputs != std::vector<std::string>{ "true" } &&
        item.inputs != std::vector<std::string>{ "false" })
      {
        Fail(this->File,
          "has '" + item.name + "'" + SectionText(item) + ", which takes true or false");
      }
      if (item.inputs.front() == "true")
      {
        list.emplace_back(item.name, std::vector<std::string>());
      }
      return;
    }
    list.emplace_back(item.name, ValuesOf(item, option));
  }

private:
  const CLI::Option& OptionOf(const CLI::ConfigItem& item, const CLI::App& command) const
  {
    const std::vector<std::string> keys = KeysOf(command);
    if (std::find(keys.begin(), keys.end(), item.name) == keys.end())
    {
      const std::string nearest = NearestWord(item.name, keys);
      Fail(this->File,
        "has '" + item.name + "'" + SectionText(item) + ", which is no option of " +
          command.get_name() + " that a file can set" +
          (nearest.empty() ? "" : "; did you mean " + nearest + "?"));
    }
    return *command.get_option_no_throw("--" + item.name);
  }

  /// Lists are one value with commas, repeated options one value each. TOML's booleans are on and
  /// off.
  static std::vector<std::string> ValuesOf(const CLI::ConfigItem& item, const CLI::Option& option)
  {
    std::vector<std::string> values = item.inputs;
    if (option.get_type_name() == "on|off" && values.size() == 1)
    {
      values[0] = values[0] == "true" ? "on" : values[0] == "false" ? "off" : values[0];
    }
    const bool isRepeatable = option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
    return isRepeatable ? values : std::vector<std::string>{ CLI::detail::join(values, ",") };
  }

  const std::string& File;
  const CLI::App& Program;
};
}

ConfigurationFile::ConfigurationFile(const std::string& path, const CLI::App& program)
{
  const Reader reader(path, program);
  for (const CLI::ConfigItem& item : ItemsOf(path))
  {
    const Section section = reader.SectionOf(item);
    SettingsList& list = section.Profile.empty() ? this->Options[section.Command]
                                                 : this->Profiles[section.Profile][section.Command];
    reader.Add(item, *FindCommand(program, section.Command), list);
  }
}

SettingsList ConfigurationFile::OptionsOf(const std::string& command) const
{
  const auto found = this->Options.find(command);
  return found == this->Options.end() ? SettingsList() : found->second;
}

std::vector<std::string> ConfigurationFile::GetProfiles() const
{
  std::vector<std::string> names;
  std::transform(this->Profiles.begin(), this->Profiles.end(), std::back_inserter(names),
    [](const auto& profile) { return profile.first; });
  return names;
}

std::map<std::string, SettingsList> ConfigurationFile::OptionsOfProfile(
  const std::string& profile) const
{
  const auto found = this->Profiles.find(profile);
  return found == this->Profiles.end() ? std::map<std::string, SettingsList>() : found->second;
}
}
