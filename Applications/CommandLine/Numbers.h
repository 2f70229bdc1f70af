// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Numbers.h
 * @brief The only reader of numbers on the command line: every numeric option of every command goes through it.
 */
#ifndef BoneDecimate_Applications_Numbers_h
#define BoneDecimate_Applications_Numbers_h

#include "NumberRange.h"
#include "OptionTable.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace bonedecimate
{
/// @name Ranges that several options share. @{
const NumberRange TriangleRange = { 1, 2147483647, true, "triangles" };
const NumberRange PositiveLengthRange = { 1e-9, LargestNumber, false, "mm" };
const NumberRange LengthRange = { 0, LargestNumber, false, "mm" };
const NumberRange CoordinateRange = { -LargestNumber, LargestNumber, false, "mm" };
const NumberRange HounsfieldRange = { -LargestNumber, LargestNumber, false, "HU" };
/// @}

/// The range of a numeric row of the table of options; nothing for switches, choices and texts.
std::optional<NumberRange> RangeOf(const OptionInfo& info);

/// A finite decimal number: no blanks, no unit, no hexadecimal digits, no comma. Nothing if the text is anything else.
std::optional<double> NumberFromText(const std::string& text);

/// @throws Failure(ExitCode::Usage) with a sentence that names flag, range, unit and text.
double ReadNumber(const std::string& flag, const std::string& text, const NumberRange& range);

struct NumberOption
{
  const char* Flag;      ///< With dashes.
  const char* ValueName; ///< Stands for the value in the help.
  NumberRange Range;
  const char* Help; ///< The range is added to it.
};

/// Adds an option that takes one number.
CLI::Option* AddNumber(
  CLI::App& app, const NumberOption& option, const std::function<void(double)>& set);

/// Adds an option that takes numbers with commas in between.
CLI::Option* AddNumberList(
  CLI::App& app, const NumberOption& option, const std::function<void(double)>& append);

/// Adds --threads.
void AddThreads(CLI::App& app, int& threads);
}

#endif
