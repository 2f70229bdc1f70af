// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HelpFormatter.h"

#include "Commands/CommandLine.h"
#include "ExitCode.h"
#include "FlagNames.h"
#include "Formats/SurfaceFormat.h"
#include "HelpTopics.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <set>
#include <sstream>
#include <utility>

namespace bonedecimate
{
namespace
{
constexpr std::size_t FlagColumn = 32;
constexpr std::size_t TextWidth = 68;

constexpr const char* Indentation = "       "; // below "Usage: "

void AddUsage(const CLI::App& command, std::vector<std::string>& lines)
{
  for (const std::string& form : UsageOf(command))
  {
    lines.push_back(CommandPath(command) + " " + form + "\n");
  }
}

/// A name with its text beside it, which begins on the next line if the name is too long.
std::string Entry(const std::string& name, const std::string& text)
{
  const std::string margin(FlagColumn, ' ');
  std::string entry = "  " + name;
  if (entry.size() < FlagColumn)
  {
    entry.resize(FlagColumn, ' ');
  }
  else
  {
    entry += "\n" + margin;
  }
  for (const char character : text)
  {
    entry += character;
    entry += character == '\n' ? margin : "";
  }
  return entry + "\n";
}

std::string EntryOf(const CLI::Option& option)
{
  const CLI::Formatter formatter;
  return Entry(formatter.make_option_name(&option, option.get_positional()) +
      formatter.make_option_opts(&option),
    option.get_description());
}

template <typename Predicate>
std::string EntriesThat(const CLI::App& command, const Predicate& isListed)
{
  std::string entries;
  for (const CLI::Option* option : command.get_options())
  {
    if (!option->get_group().empty() && std::invoke(isListed, option))
    {
      entries += EntryOf(*option);
    }
  }
  return entries;
}

/// Empty without entries.
std::string Section(const std::string& title, const std::string& entries)
{
  return entries.empty() ? entries : "\n" + title + ":\n" + entries;
}

bool IsInTopic(const CLI::Option* option)
{
  const std::vector<HelpTopic>& topics = HelpTopics();
  return std::any_of(topics.begin(), topics.end(),
    [option](const HelpTopic& topic)
    {
      return std::any_of(topic.Flags.begin(), topic.Flags.end(),
        [option](const std::string& flag) { return option->check_lname(flag); });
    });
}

/// Those of the command alone first, then by topic.
std::string OptionSections(const CLI::App& command)
{
  std::string sections = Section("Options",
    EntriesThat(command,
      [](const CLI::Option* option) { return !option->get_positional() && !IsInTopic(option); }));
  for (const HelpTopic& topic : HelpTopics())
  {
    sections += Section(topic.Title, OptionEntries(command, topic.Flags));
  }
  return sections;
}
}

std::string OptionEntries(const CLI::App& command, const std::vector<std::string>& flags)
{
  std::string entries;
  std::set<const CLI::Option*> listed; // some have two of the names
  for (const std::string& flag : flags)
  {
    const CLI::Option* const option = command.get_option_no_throw("--" + flag);
    if (option != nullptr && !option->get_group().empty() && listed.insert(option).second)
    {
      entries += EntryOf(*option);
    }
  }
  return entries;
}

HelpFormatter::HelpFormatter(std::vector<std::string> usage)
  : Usage(std::move(usage))
{
}

std::string HelpFormatter::make_help(
  const CLI::App* app, std::string name, CLI::AppFormatMode /*mode*/) const
{
  return app->get_description() + "\n" + this->make_usage(app, std::move(name)) +
    Section("Positionals", EntriesThat(*app, &CLI::Option::get_positional)) + OptionSections(*app) +
    "\n" + app->get_footer() + "\n";
}

std::string HelpFormatter::make_usage(const CLI::App* app, std::string) const
{
  std::vector<std::string> lines;
  AddUsage(*app, lines);
  if (app->get_name() == DefaultCommand && app->get_parent() != nullptr)
  {
    for (const CLI::App* other :
      app->get_parent()->get_subcommands([app](const CLI::App* one) { return one != app; }))
    {
      AddUsage(*other, lines);
    }
  }
  std::string text;
  for (const std::string& line : lines)
  {
    text += (text.empty() ? "Usage: " : Indentation) + line;
  }
  return text;
}

std::vector<std::string> UsageOf(const CLI::App& command)
{
  const auto formatter = std::dynamic_pointer_cast<HelpFormatter>(command.get_formatter());
  return formatter ? formatter->GetUsage() : std::vector<std::string>();
}

std::string CommandPath(const CLI::App& command)
{
  const std::string program = "bonedecimate";
  return command.get_name() == DefaultCommand ? program : program + " " + command.get_name();
}

std::string ProgramDescription()
{
  return "Makes a bone surface from CT smaller, keeps every fragment and says in millimeters what "
         "that cost.";
}

std::string FormatsText()
{
  return "Surfaces are read and written by extension: " + SurfaceExtensions() +
    ".\n"
    "Of them " +
    ExtensionsThat(&SurfaceFormat::HoldsArrays) +
    " hold arrays. Every file is written whole or not at all.\n"
    "Lengths are millimeters.";
}

std::string BatchText()
{
  return "Many bones: the output folder gets NAME.EXT and NAME.json for each, of a label map a "
         "folder\n"
         "NAME, and summary.csv.\n"
         "NAME is the input's, with its extension, its folder or a number added where two inputs\n"
         "would get the same. One that fails does not stop the others. Files of a folder that are\n"
         "no surfaces or volumes are skipped, each with a row in summary.csv. Run again, a bone "
         "is\n"
         "done if its report names the same version, options, input size and time of change, and\n"
         "its output has the size it was written with; results of other options need --force or\n"
         "another folder. The program ends with the highest\n"
         "code of those that failed; a bone whose process died counts as 5. It ends with 8 if "
         "none\n"
         "failed and volumes of a folder were left out for want of --iso and --segments.";
}

std::string HelpFooter()
{
  return FormatsText() + "\n\n" + BatchText() + "\n\n" + ExitCodesText() +
    "\nThis software is not a medical device.\n";
}

std::string OptionValueName(const OptionInfo& info)
{
  if (!info.Choices.empty())
  {
    std::string names;
    for (const std::string& choice : info.Choices)
    {
      names += (names.empty() ? "" : "|") + choice;
    }
    return names;
  }
  const OptionValue value = GetOption(Options{}, info);
  if (std::holds_alternative<bool>(value))
  {
    return "on|off";
  }
  if (info.Unit == "mm")
  {
    return "MM";
  }
  return std::holds_alternative<int>(value)      ? "N"
    : std::holds_alternative<std::string>(value) ? "NAME"
                                                 : "NUMBER";
}

std::string OptionHelp(const OptionInfo& info)
{
  const std::string byDefault = OptionText(Options{}, info);
  return WrappedHelp(WithFlags(info.Sentence) + " Takes " + ValuesText(info) + "; default " +
    (byDefault.empty() ? "none" : byDefault) + ".");
}

std::string WrappedHelp(const std::string& text)
{
  std::istringstream words(text);
  std::string wrapped;
  std::size_t width = 0;
  for (std::string word; words >> word; width += word.size())
  {
    const bool breaks = width > 0 && width + 1 + word.size() > TextWidth;
    wrapped += breaks ? "\n" : (width > 0 ? " " : "");
    width = breaks ? 0 : width + (width > 0 ? 1 : 0);
    wrapped += word;
  }
  return wrapped;
}
}
