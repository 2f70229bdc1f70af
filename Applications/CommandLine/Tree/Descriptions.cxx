// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Tree/Descriptions.h"

#include "Arguments/CommonOptions.h"
#include "Arguments/HelpFormatter.h"
#include "Options/OptionTable.h"
#include "Options/OptionTableJson.h"
#include "Options/Profiles.h"
#include "Tree/CommandTree.h"
#include "Tree/Completion.h"
#include "Tree/ManPage.h"
#include "Tree/Tables.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <iostream>

namespace bonedecimate
{
namespace
{
void AddPrinter(CLI::App& command, const char* flag, const std::function<std::string()>& compose,
  const char* help)
{
  command.add_flag_callback(
    flag,
    [compose]
    {
      std::cout << compose();
      throw CLI::Success();
    },
    WrappedHelp(help));
}
}

void AddDescriptions(CLI::App& command, const CLI::App& program)
{
  command
    .add_option_function<std::string>(
      "--completion",
      [&program](const std::string& shell)
      {
        const std::vector<CommandEntry> commands = CommandTree(program);
        std::cout << (shell == "bash" ? BashCompletion(commands)
            : shell == "zsh"          ? ZshCompletion(commands)
                                      : FishCompletion(commands));
        throw CLI::Success();
      },
      WrappedHelp("Print the script that makes this shell complete commands, options, values and "
                  "files: eval \"$(bonedecimate --completion bash)\"."))
    ->type_name("bash|zsh|fish")
    ->check(OneOf("bash|zsh|fish"));
  AddPrinter(
    command, "--man", [&program] { return ManPage(CommandTree(program)); },
    "Print the manual page, for man -l -.");
  AddPrinter(
    command, "--options-markdown", &OptionTableMarkdown, "Print the table of options as Markdown.");
  AddPrinter(command, "--options-json", &OptionTableJson,
    "Print the table of options as JSON, for programs.");
  AddPrinter(command, "--profiles-markdown", &ProfileTableMarkdown,
    "Print the built-in profiles as Markdown.");
  AddPrinter(command, "--tables", &TablesJson,
    "Print modes, formats of surfaces and reasons of rejections as JSON, for programs.");
}
}
