// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Tree/Completion.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
constexpr const char* Beginning =
  R"(# Completion of bonedecimate for bash; written by "bonedecimate --completion bash".

# Folders, and files with one of the extensions, which have bars in between; all files without any.
_bonedecimate_files()
{
  local name
  compopt -o filenames 2>/dev/null
  while IFS= read -r name; do
    if [[ -d $name || -z $1 || ${name,,} =~ \.($1)$ ]]; then
      COMPREPLY+=("$name")
    fi
  done < <(compgen -f -- "$current")
}

_bonedecimate_words()
{
  local IFS=$' \t\n'
  COMPREPLY+=($(compgen -W "$1" -- "$current"))
}

_bonedecimate()
{
  local current=${COMP_WORDS[COMP_CWORD]} option=${COMP_WORDS[COMP_CWORD-1]} command= word
  COMPREPLY=()
  if [[ $current == = ]]; then
    current=
  elif [[ $option == = ]]; then
    option=${COMP_WORDS[COMP_CWORD-2]}
  fi
)";

/// Another form of a word of a case: bash splits words at the equals sign.
std::string CaseOf(const CommandEntry& command, const OptionEntry& option)
{
  std::vector<std::string> words(option.Flags.size());
  std::transform(option.Flags.begin(), option.Flags.end(), words.begin(),
    [&command](const std::string& flag) { return "'" + command.Name + " " + flag + "'"; });
  return "    " + Joined(words, "|") + ")";
}

std::string FilesWords(const OptionEntry& option)
{
  return " _bonedecimate_files '" + Joined(*option.Extensions, "|") + "';";
}

std::string Values(const CommandEntry& command)
{
  std::string text;
  for (const OptionEntry& option : command.Options)
  {
    if (!option.ValueName.empty())
    {
      text += CaseOf(command, option);
      text += option.Choices.empty()
        ? std::string()
        : " _bonedecimate_words '" + Joined(option.Choices, " ") + "';";
      text += option.Extensions ? FilesWords(option) : std::string();
      text += " return ;;\n";
    }
  }
  return text;
}

std::string OptionsAndFiles(const CommandEntry& command)
{
  std::vector<std::string> flags;
  for (const OptionEntry& option : command.Options)
  {
    flags.insert(flags.end(), option.Flags.begin(), option.Flags.end());
  }
  return "    " + command.Name +
    ")\n      if [[ $current == -* ]]; then\n        _bonedecimate_words '" + Joined(flags, " ") +
    "'\n      else\n       " + FilesWords(command.Files) + "\n      fi\n      ;;\n";
}
}

std::string BashCompletion(const std::vector<CommandEntry>& commands)
{
  const std::vector<std::string> names = NamesOfCommands(commands);
  std::string text = Beginning;
  text += "  if [[ $COMP_CWORD -gt 1 ]]; then\n    case ${COMP_WORDS[1]} in\n      " +
    Joined(names, "|") +
    ") command=${COMP_WORDS[1]} ;;\n    esac\n  else\n    _bonedecimate_words '" +
    Joined(names, " ") + "'\n  fi\n  command=${command:-" + commands.front().Name +
    "}\n"
    "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
    "    if [[ $word == -- ]]; then\n      option=--\n    fi\n  done\n"
    "  case \"$command $option\" in\n    *' --') ;;\n";
  for (const CommandEntry& command : commands)
  {
    text += Values(command);
  }
  text += "  esac\n  case $command in\n";
  for (const CommandEntry& command : commands)
  {
    text += OptionsAndFiles(command);
  }
  return text + "  esac\n}\n\ncomplete -F _bonedecimate bonedecimate\n";
}
}
