// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HelpFormatter.h
 * @brief The texts of --help, wrapped to a terminal's width.
 */
#ifndef BoneDecimate_Applications_HelpFormatter_h
#define BoneDecimate_Applications_HelpFormatter_h

#include "Options/OptionTable.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace bonedecimate
{
class HelpFormatter : public CLI::Formatter
{
public:
  /// @param usage What follows the name of the command, one form a line.
  explicit HelpFormatter(std::vector<std::string> usage);

  /// The whole help, in a layout that does not depend on the version of CLI11.
  std::string make_help(
    const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;

  /// The forms of this command; for the default command those of all others, too.
  std::string make_usage(const CLI::App* app, std::string name) const override;

  const std::vector<std::string>& GetUsage() const { return this->Usage; }

private:
  std::vector<std::string> Usage;
};

/// What follows the name of a command, one form each.
std::vector<std::string> UsageOf(const CLI::App& command);

/// What a user types: "bonedecimate levels", and "bonedecimate" for the default command.
std::string CommandPath(const CLI::App& command);

std::string ProgramDescription();

/// Formats, how finished bones are recognized, exit codes.
std::string HelpFooter();

/// @name Parts of it. @{
std::string FormatsText();
std::string BatchText();
/// @}

/// The help of an option of the core's table: its sentence, range, unit and default.
std::string OptionHelp(const OptionInfo& info);

/// Its value in the help: "MM", "N", "on|off", "Thesis".
std::string OptionValueName(const OptionInfo& info);

/// The entries of these options in the help, those that the command has. @param flags No dashes.
std::string OptionEntries(const CLI::App& command, const std::vector<std::string>& flags);

/// Breaks a help text to the width beside the column of flags.
std::string WrappedHelp(const std::string& text);
}

#endif
