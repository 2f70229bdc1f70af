// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Tree/Completion.h"

namespace bonedecimate
{
namespace
{
std::string FishQuoted(const std::string& text)
{
  return "'" + Escaped(text, "'\\") + "'";
}

std::string FilesCall(const std::vector<std::string>& extensions)
{
  return "(__bonedecimate_files " + FishQuoted(Joined(extensions, "|")) + ")";
}

std::string Line(const CommandEntry& command, const OptionEntry& option)
{
  std::string text = "complete -c bonedecimate -n '__bonedecimate_is " + command.Name + "'";
  for (const std::string& flag : option.Flags)
  {
    const bool isLong = flag.compare(0, 2, "--") == 0;
    text += isLong ? " -l " + flag.substr(2) : " -s " + flag.substr(1);
  }
  if (!option.ValueName.empty())
  {
    std::vector<std::string> values = option.Choices;
    if (option.Extensions)
    {
      values.push_back(FilesCall(*option.Extensions));
    }
    text += " -x" + (values.empty() ? std::string() : " -a " + FishQuoted(Joined(values, " ")));
  }
  return text + " -d " + FishQuoted(option.Summary()) + "\n";
}
}

std::string FishCompletion(const std::vector<CommandEntry>& commands)
{
  const std::string names = Joined(NamesOfCommands(commands), " ");
  std::string text =
    R"(# Completion of bonedecimate for fish; written by "bonedecimate --completion fish".

function __bonedecimate_is
    set -l words (commandline -opc)
    set -l command )" +
    commands.front().Name + "\n    if contains -- \"$words[2]\" " + names + R"(
        set command $words[2]
    end
    test $command = $argv[1]
end

function __bonedecimate_is_first
    test (count (commandline -opc)) -eq 1
end

# Folders, and files with one of the extensions, which have bars in between; all files without any.
function __bonedecimate_files
    set -l token (string replace -r -- '^--[a-z-]+=' '' (commandline -ct))
    set -l beginning (string replace -r -- '^~/' $HOME/ $token)
    set -l files $beginning*
    for file in $files
        set -l shown (string replace -- $beginning $token $file)
        if test -d $file
            echo $shown/
        else if test -z $argv[1]; or string match -qri -- '\.('$argv[1]')$' $file
            echo $shown
        end
    end
end

complete -c bonedecimate -f
)";
  for (const CommandEntry& command : commands)
  {
    const std::size_t end = command.Description.find_first_of(".:");
    text += "complete -c bonedecimate -n __bonedecimate_is_first -a " + command.Name + " -d " +
      FishQuoted(command.Description.substr(0, end)) + "\n";
  }
  for (const CommandEntry& command : commands)
  {
    text += "complete -c bonedecimate -n '__bonedecimate_is " + command.Name + "' -a " +
      FishQuoted(FilesCall(*command.Files.Extensions)) + "\n";
    for (const OptionEntry& option : command.Options)
    {
      text += Line(command, option);
    }
  }
  return text;
}
}
