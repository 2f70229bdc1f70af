// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Tree/Completion.h"

namespace bonedecimate
{
namespace
{
/// In single quotes.
std::string ZshQuoted(const std::string& text)
{
  std::string quoted;
  for (const char letter : text)
  {
    quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  }
  return "'" + quoted + "'";
}

std::string FilesAction(const std::vector<std::string>& extensions)
{
  return extensions.empty() ? "_files"
                            : "_files -g \"*.(#i)(" + Joined(extensions, "|") + ")(-.)\"";
}

std::string ActionOf(const OptionEntry& option)
{
  const bool both = !option.Choices.empty() && option.Extensions;
  const std::string words = "(" + Joined(option.Choices, " ") + ")";
  if (both)
  {
    return "{ compadd " + Joined(option.Choices, " ") + "; " + FilesAction(*option.Extensions) +
      " }";
  }
  return option.Extensions ? FilesAction(*option.Extensions) : option.Choices.empty() ? " " : words;
}

/// A specification of _arguments for each of its flags.
std::string Specifications(const OptionEntry& option)
{
  std::string text;
  for (const std::string& flag : option.Flags)
  {
    const bool isLong = flag.compare(0, 2, "--") == 0;
    const bool takesValue = !option.ValueName.empty();
    std::string one = option.IsRepeatable ? "*" : "";
    one +=
      flag + (takesValue && isLong ? "=" : "") + "[" + Escaped(option.Summary(), "[]:\\") + "]";
    one += takesValue ? ":" + Escaped(option.ValueName, ":\\") + ":" + ActionOf(option) : "";
    text += " \\\n        " + ZshQuoted(one);
  }
  return text;
}
}

std::string ZshCompletion(const std::vector<CommandEntry>& commands)
{
  std::string text = R"(#compdef bonedecimate
# Completion of bonedecimate for zsh; written by "bonedecimate --completion zsh".

_bonedecimate()
{
  local command=)" +
    commands.front().Name + "\n  if (( CURRENT > 2 )); then\n    case $words[2] in\n      " +
    Joined(NamesOfCommands(commands), "|") +
    ")\n        command=$words[2]\n        shift words\n        (( CURRENT-- ))\n        ;;\n    "
    "esac\n  else\n"
    "    local -a commands=(\n";
  for (const CommandEntry& command : commands)
  {
    const std::size_t end = command.Description.find_first_of(".:");
    text += "      " + ZshQuoted(command.Name + ":" + command.Description.substr(0, end)) + "\n";
  }
  text += "    )\n    [[ $words[2] == -* ]] || _describe -t commands command commands\n  fi\n  "
          "case $command in\n";
  for (const CommandEntry& command : commands)
  {
    text += "    " + command.Name + ")\n      _arguments -S";
    for (const OptionEntry& option : command.Options)
    {
      text += Specifications(option);
    }
    text += " \\\n        " + ZshQuoted("*:file:" + FilesAction(*command.Files.Extensions)) +
      "\n      ;;\n";
  }
  return text +
    "  esac\n}\n\nif [[ $funcstack[1] == _bonedecimate ]]; then\n  _bonedecimate \"$@\"\nelse\n"
    "  compdef _bonedecimate bonedecimate\nfi\n";
}
}
