// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CommonOptions.h
 * @brief Options that several commands have, and the validators of their values.
 */
#ifndef BoneDecimate_Applications_CommonOptions_h
#define BoneDecimate_Applications_CommonOptions_h

#include "CliForward.h"
#include "Options/NumberRange.h"
#include "Options/OptionTable.h"

#include <functional>
#include <string>
#include <vector>

namespace bonedecimate
{
/// @name Ranges of several options. @{
const NumberRange TriangleRange = { 1, 2147483647, true, "triangles" };
const NumberRange PositiveLengthRange = { 1e-9, MaxNumber, false, "mm" };
const NumberRange LengthRange = { 0, MaxNumber, false, "mm" };
const NumberRange CoordinateRange = { -MaxNumber, MaxNumber, false, "mm" };
const NumberRange HounsfieldRange = { -MaxNumber, MaxNumber, false, "HU" };
/// @}

/// @name Validators of texts; their message is "takes VALUES, not 'TEXT'". @{
CLI::Validator InRange(const NumberRange& range);
CLI::Validator EachInRange(const NumberRange& range); ///< Numbers with commas in between.
CLI::Validator ValueOf(const OptionInfo& info);       ///< A value of an option of the table.
CLI::Validator OneOf(const std::string& choices);     ///< Words with bars in between, in any case.
/// @}

/// Outside of CLI11: words that are no options.
/// @throws Failure(ExitCode::Usage) with a sentence that names flag, range, unit and text.
double ReadNumber(const std::string& flag, const std::string& text, const NumberRange& range);

struct NumberOption
{
  const char* Flag;      ///< With dashes.
  const char* ValueName; ///< The value in the help.
  NumberRange Range;
  const char* Help; ///< The range is added to it.
};

/// Adds an option that takes one number.
CLI::Option* AddNumber(
  CLI::App& app, const NumberOption& option, const std::function<void(double)>& set);

/// Adds --iso, a Hounsfield value or "bone".  @param help Ends before the range.
void AddIsoValue(CLI::App& app, const std::function<void(double)>& set, const std::string& help);

/// Adds an option that takes numbers with commas in between.
CLI::Option* AddNumberList(
  CLI::App& app, const NumberOption& option, const std::function<void(double)>& append);

/// Adds an option that takes the name of a file.
/// @param kind Kind of Tree/FileKinds.h, in the help the name of the value.
void AddFile(
  CLI::App& app, const char* flag, const char* kind, std::string& value, const char* help);

/// Adds an option that takes on or off.
void AddSwitch(
  CLI::App& app, const char* flag, const std::function<void(bool)>& set, const char* help);

/// Adds the positional files of a command that reads surfaces. @param what "A surface".
void AddSurfaces(CLI::App& app, std::vector<std::string>& files, const std::string& what);

/// @param what "one INPUT". @throws Failure(ExitCode::Usage) if there are not so many files.
void RequireFiles(const CLI::App& command, const std::vector<std::string>& files, std::size_t count,
  const std::string& what);

/// Rejects the name of a file of another kind; a name without an extension is accepted.
/// @param extensions The first is the one to name. @throws Failure(ExitCode::Usage)
void RequireExtension(
  const std::string& flag, const std::string& path, const std::vector<std::string>& extensions);

/// The name of the mode of a run without --mode.
std::string DefaultMode();

/// Adds --mode. @param choices Separated by bars.
void AddMode(CLI::App& app, std::string& mode, const std::string& choices, const std::string& help);

/// Adds --threads.
void AddThreads(CLI::App& app, int& threads);

/// Adds --quiet.
void AddQuiet(CLI::App& app, bool& quiet);

/// Adds --allow-large-error, for commands whose options are not those of the table.
void AddAllowLargeError(CLI::App& app, bool& allow);
}

#endif
