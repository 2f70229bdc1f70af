// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Tree/ManPage.h"

#include "Arguments/HelpFormatter.h"
#include "ExitCode.h"
#include "Options/Profiles.h"
#include "Run/Report/Report.h"

#include <map>
#include <sstream>
#include <utility>

namespace bonedecimate
{
namespace
{
constexpr std::size_t LineWidth = 78;

/// Characters that roff would interpret are escaped.
std::string Roff(const std::string& text)
{
  static const std::map<char, const char*> names = { { '\\', "\\e" }, { '-', "\\-" },
    { '\'', "\\(aq" }, { '~', "\\(ti" }, { '^', "\\(ha" } };
  std::string escaped;
  for (const char letter : text)
  {
    const auto name = names.find(letter);
    escaped += name == names.end() ? std::string(1, letter) : name->second;
  }
  return escaped.compare(0, 1, ".") == 0 ? "\\&" + escaped : escaped;
}

/// A new line for each sentence, and where lines would be too long.
std::string Sentences(const std::string& text)
{
  std::istringstream words(text);
  std::string lines;
  std::size_t width = 0;
  bool hasEnded = false;
  for (std::string word; words >> word; hasEnded = word.back() == '.')
  {
    const std::string escaped = Roff(word);
    const bool breaks = width > 0 && (hasEnded || width + 1 + escaped.size() > LineWidth);
    lines += breaks ? "\n" : (width > 0 ? " " : "");
    width = (breaks ? 0 : width + (width > 0 ? 1 : 0)) + escaped.size();
    lines += escaped;
  }
  return lines + "\n";
}

std::string Bold(const std::string& text)
{
  return "\\fB" + Roff(text) + "\\fR";
}

std::string Italic(const std::string& text)
{
  return "\\fI" + Roff(text) + "\\fR";
}

std::string OptionText(const OptionEntry& option)
{
  std::string flags;
  for (const std::string& flag : option.Flags)
  {
    flags += (flags.empty() ? "" : ", ") + Bold(flag);
  }
  const std::string value = option.ValueName.empty() ? "" : " " + Italic(option.ValueName);
  return ".TP\n" + flags + value + "\n" + Sentences(option.Help);
}

std::string PathOf(const CommandEntry& command)
{
  return command.IsDefault ? "bonedecimate" : "bonedecimate " + command.Name;
}

std::string Synopsis(const std::vector<CommandEntry>& commands)
{
  std::string text = ".SH SYNOPSIS\n";
  const char* before = "";
  for (const CommandEntry& command : commands)
  {
    for (const std::string& form : command.Usage)
    {
      text += before + Bold(PathOf(command)) + " " + Roff(form) + "\n";
      before = ".br\n";
    }
  }
  return text;
}

std::string CommandText(const CommandEntry& command)
{
  std::string text = command.IsDefault
    ? ".SH OPTIONS\nOf a decimation:\n"
    : ".SS " + PathOf(command) + "\n" + Sentences(command.Description);
  text += ".TP\n" + Italic(command.IsDefault ? "INPUT ... OUTPUT" : command.Files.ValueName) +
    "\n" + Sentences(command.Files.Help);
  for (const OptionEntry& option : command.Options)
  {
    text += OptionText(option);
  }
  return text;
}

std::string Profiles()
{
  std::string text = ".SH PROFILES\n";
  for (const Profile& profile : ProfileTable())
  {
    text += ".TP\n" + Bold(profile.Name) + "\n" + Sentences(profile.Purpose);
    for (const ProfileOption& option : profile.Options)
    {
      text += ".br\n" + Bold("--" + std::string(option.Flag) + " " + option.Value) + ":\n" +
        Sentences(option.Reason + std::string("."));
    }
  }
  return text;
}

std::string ExitStatus()
{
  std::string text = ".SH EXIT STATUS\n";
  for (const auto& [code, meaning] : ExitCodeMeanings())
  {
    text +=
      ".TP\n" + Bold(std::to_string(static_cast<int>(code))) + "\n" + Sentences(meaning + ".");
  }
  return text;
}
}

std::string ManPage(const std::vector<CommandEntry>& commands)
{
  std::string text =
    ".\\\" Written by \"bonedecimate --man\".\n.TH BONEDECIMATE 1 \"" BONEDECIMATE_DATE
    "\" \"vtkBoneDecimate " +
    std::string(Version()) +
    "\"\n.SH NAME\nbonedecimate \\- bone surfaces with fewer triangles, and the "
    "proved error in mm\n" +
    Synopsis(commands) + ".SH DESCRIPTION\n" + Sentences(ProgramDescription()) + ".PP\n" +
    Sentences(FormatsText()) + ".PP\n" + Sentences(BatchText()) + CommandText(commands.front()) +
    ".SH COMMANDS\n";
  for (std::size_t i = 1; i < commands.size(); ++i)
  {
    text += CommandText(commands[i]);
  }
  return text + Profiles() + ExitStatus() + ".SH NOTES\nThis software is not a medical device.\n";
}
}
