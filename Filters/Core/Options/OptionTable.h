// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OptionTable.h
 * @brief The one table of options. Every interface is generated, documented or checked from it.
 */
#ifndef BoneDecimate_Core_Options_OptionTable_h
#define BoneDecimate_Core_Options_OptionTable_h

#include "Needs.h"
#include "NumberRange.h"
#include "Options.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace bonedecimate
{
/// The field of Options that a row describes; its alternative is the kind of the option.
using OptionField =
  std::variant<bool Options::*, int Options::*, double Options::*, std::string Options::*,
    Mode Options::*, PointsPrecision Options::*, ErrorPreset Options::*, KeepVoxels Options::*>;

/// Switches are bool, choices are their number as int.
using OptionValue = std::variant<bool, int, double, std::string>;

/// Groups of options in panels. NoGroup: in the first view alone.
enum class PanelGroup : int
{
  NoGroup = 0,
  Targets,
  Smoothing,
  Proof,
  Shape,
  Input,
  Output,
  Names,
  Thesis
};

/// A row; OptionRows.def has them all.
struct OptionInfo
{
  std::string Name; ///< As in SetName() of the filter.
  OptionField Field;
  double Minimum = 0.0; ///< Least and greatest value of a number, both allowed and finite.
  double Maximum = 1.0;
  std::string Unit; ///< "mm", "triangles", ...; empty where there is none.
  std::string Flag; ///< Long flag of the command line without dashes; empty: not there.
  std::vector<std::string> Choices; ///< Names of the values 0, 1, ... of a choice.
  std::string Sentence;             ///< What it means and what happens at the ends of its range.
  std::vector<NeedList> Needs;      ///< Unmet needs of a list are named together.
  bool (*IsUsed)(const Options& options) = nullptr; ///< If null, any value but the default.
  PanelGroup Group = PanelGroup::NoGroup;
  bool IsPointArrayName = false; ///< Chosen from the point arrays of the input.
};

/// Every option once, in the order in which people meet them.
const std::vector<OptionInfo>& OptionTable();

/// The row of that name, or nullptr.
const OptionInfo* FindOption(const std::string& name);

/// The range of a number; nothing for switches, choices and texts.
std::optional<NumberRange> RangeOf(const OptionInfo& info);

/// The values that an option accepts: "a number from 0 to 1e30 mm", "one of Thesis, Fast,
/// Balanced, Accurate", "on or off".
std::string ValuesText(const OptionInfo& info);

OptionValue GetOption(const Options& options, const OptionInfo& info);

/// Whether the option requests something of the run: mostly that its value is not the default.
bool IsUsed(const Options& options, const OptionInfo& info);

/// Names of the options that do not have their default, for callers that do not know which were
/// set.
std::vector<std::string> ChangedOptions(const Options& options);

/// What is wrong with a value, in one sentence: its kind, or that it is outside the range (NaN and
/// infinity are). Empty if nothing is.
std::string CheckOption(const OptionInfo& info, const OptionValue& value);

/// What is wrong with the first option whose value cannot be, empty if nothing is: structs are
/// filled without SetOption(), too.
std::string CheckOptions(const Options& options);

/// Sets the value; or leaves the options as they are and returns what CheckOption() says.
std::string SetOption(Options& options, const OptionInfo& info, const OptionValue& value);

/// The same from text.
std::string SetOptionFromText(Options& options, const OptionInfo& info, const std::string& text);

/// The value as text: the name of a choice, "on"/"off", the shortest decimals that read back the
/// same.
std::string OptionText(const Options& options, const OptionInfo& info);

/// The table as Markdown, for Documentation/reference/options.md.
std::string OptionTableMarkdown();
}

#endif
