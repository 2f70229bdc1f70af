// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HelpFormatter.h
 * @brief The texts of --help, wrapped to a terminal's width.
 */
#ifndef BoneDecimate_Applications_HelpFormatter_h
#define BoneDecimate_Applications_HelpFormatter_h

#include "OptionTable.h"

#include <CLI/CLI.hpp>

#include <string>

namespace bonedecimate
{
class HelpFormatter : public CLI::Formatter
{
public:
  /// @param usage What follows the program's name.
  explicit HelpFormatter(const std::string& usage);

  std::string make_usage(const CLI::App* app, std::string name) const override;

private:
  std::string Usage;
};

std::string ProgramDescription();

/// Formats, how finished bones are recognised, exit codes.
std::string HelpFooter();

/// The help of an option of the core's table: its sentence, range, unit and default.
std::string OptionHelp(const OptionInfo& info);

/// What stands for its value: "MM", "N", "on|off", "Thesis".
std::string OptionValueName(const OptionInfo& info);

/// Breaks a help text to the width beside the column of flags.
std::string WrappedHelp(const std::string& text);
}

#endif
