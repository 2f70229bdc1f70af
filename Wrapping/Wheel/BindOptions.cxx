// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays.h"
#include "Bindings.h"
#include "Options/NumberRange.h"
#include "Options/OptionTable.h"
#include "Options/OptionTableJson.h"
#include "Options/Profiles.h"
#include "Options/RunKinds.h"
#include "Run/Report/ProofSentence.h"
#include "Run/Report/ReportFigures.h"
#include "Run/Report/ReportJson.h"
#include "Run/Report/ReportTable.h"

#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/variant.h>
#include <nanobind/stl/vector.h>

#include <stdexcept>
#include <tuple>
#include <type_traits>

namespace bonedecimate
{
namespace
{
const OptionInfo& Row(const std::string& name)
{
  const OptionInfo* info = FindOption(name);
  if (!info)
  {
    throw nb::key_error(name.c_str());
  }
  return *info;
}

/// A Python number as the kind of number that the option is; what cannot be turned without loss is
/// a TypeError.
OptionValue AsKindOf(const OptionValue& current, const OptionValue& given, const OptionInfo& info)
{
  return std::visit(
    [&](const auto& old, const auto& value) -> OptionValue
    {
      using To = std::decay_t<decltype(old)>;
      using From = std::decay_t<decltype(value)>;
      constexpr bool isSame = std::is_same_v<To, From>;
      constexpr bool isText = std::is_same_v<To, std::string> || std::is_same_v<From, std::string>;
      if constexpr (isSame || (!isText && !std::is_same_v<From, double>))
      {
        return static_cast<To>(value);
      }
      else
      {
        throw nb::type_error((info.Name + ": a value of the wrong type").c_str());
      }
    },
    current, given);
}

/// Whether that changes anything.
bool Set(Options& options, const std::string& name, const OptionValue& value)
{
  const OptionInfo& info = Row(name);
  const OptionValue before = GetOption(options, info);
  const bool wasExplicit = options.TargetReductionIsExplicit;
  const std::string problem = SetOption(options, info, AsKindOf(before, value, info));
  if (!problem.empty())
  {
    throw nb::value_error(problem.c_str());
  }
  return before != GetOption(options, info) || wasExplicit != options.TargetReductionIsExplicit;
}

void Read(Options& options, const std::string& name, const std::string& text)
{
  const std::string problem = SetOptionFromText(options, Row(name), text);
  if (!problem.empty())
  {
    throw nb::value_error(problem.c_str());
  }
}

const char* KindWord(const OptionInfo& info)
{
  static const char* const words[] = { "bool", "int", "float", "str" };
  return words[GetOption(Options(), info).index()];
}

/// As ToList() gives them to Python.
std::string JsonOf(const std::vector<std::tuple<std::string, std::string, ReportValue>>& entries)
{
  std::vector<ReportEntry> list;
  for (const auto& [name, unit, value] : entries)
  {
    list.push_back({ name, unit, value });
  }
  return ReportJson(list);
}

void BindEnums(nb::module_& module)
{
  nb::enum_<Mode> modes(module, "Mode", "How the result is found.");
  for (const ModeInfo& mode : ModeTable())
  {
    modes.value(mode.Name, mode.Mode);
  }
  nb::enum_<ErrorPreset>(
    module, "ErrorPreset", "A largest error as a fraction of the scan's voxels.")
    .value("NoPreset", ErrorPreset::NoPreset)
    .value("QuarterVoxel", ErrorPreset::QuarterVoxel)
    .value("HalfVoxel", ErrorPreset::HalfVoxel)
    .value("OneVoxel", ErrorPreset::OneVoxel);
  nb::enum_<KeepVoxels>(module, "KeepVoxels", "Whether edits may let a voxel center change sides.")
    .value("KeepVoxelsOff", KeepVoxels::Off)
    .value("KeepVoxelsOn", KeepVoxels::On)
    .value("KeepVoxelsAuto", KeepVoxels::Automatic);
  nb::enum_<StopReason>(module, "StopReason", "Why a run ended.")
    .value("NotRun", StopReason::NotRun)
    .value("TargetReached", StopReason::TargetReached)
    .value("ErrorReached", StopReason::ErrorReached)
    .value("AlreadySatisfied", StopReason::AlreadySatisfied)
    .value("NothingLeft", StopReason::NothingLeft)
    .value("Aborted", StopReason::Aborted)
    .value("Handles", StopReason::Handles);
  nb::enum_<InputStatus>(module, "InputStatus", "Whether an input could be used.")
    .value("Good", InputStatus::Good)
    .value("Empty", InputStatus::Empty)
    .value("NoTriangles", InputStatus::NoTriangles)
    .value("NonFinitePoints", InputStatus::NonFinitePoints)
    .value("HugeCoordinates", InputStatus::HugeCoordinates)
    .value("IndexOutOfRange", InputStatus::IndexOutOfRange)
    .value("TooManyTriangles", InputStatus::TooManyTriangles)
    .value("BadTolerances", InputStatus::BadTolerances)
    .value("BadEdgeLengths", InputStatus::BadEdgeLengths)
    .value("UnprovableTolerances", InputStatus::UnprovableTolerances)
    .value("ReferenceWithoutError", InputStatus::ReferenceWithoutError)
    .value("BadReference", InputStatus::BadReference)
    .value("FarFromReference", InputStatus::FarFromReference)
    .value("EverythingPruned", InputStatus::EverythingPruned)
    .value("OptionConflict", InputStatus::OptionConflict)
    .value("RoundingTooCoarse", InputStatus::RoundingTooCoarse)
    .value("ErrorBeyondSize", InputStatus::ErrorBeyondSize)
    .value("ErrorBelowSize", InputStatus::ErrorBelowSize)
    .value("BadLabelMap", InputStatus::BadLabelMap)
    .value("NoVoxelGrid", InputStatus::NoVoxelGrid)
    .value("InvalidOption", InputStatus::InvalidOption);
}

void BindTable(nb::module_& module)
{
  nb::class_<OptionInfo>(module, "OptionInfo", "A row of the table of options.")
    .def_ro("name", &OptionInfo::Name, "As in SetName() of the filter.")
    .def_ro("minimum", &OptionInfo::Minimum)
    .def_ro("maximum", &OptionInfo::Maximum)
    .def_ro("unit", &OptionInfo::Unit)
    .def_ro("flag", &OptionInfo::Flag, "Of the command line, without dashes; may be empty.")
    .def_ro("choices", &OptionInfo::Choices)
    .def_ro("sentence", &OptionInfo::Sentence)
    .def_prop_ro("kind", &KindWord, "bool, int, float or str.")
    .def_prop_ro("default", [](const OptionInfo& info) { return GetOption(Options(), info); })
    .def_prop_ro(
      "default_text", [](const OptionInfo& info) { return OptionText(Options(), info); });
  module.def(
    "option_table", [] { return OptionTable(); },
    "All options, in the order of the documentation.");
  module.def("option_table_markdown", &OptionTableMarkdown);
  module.def("option_table_json", &OptionTableJson);
  module.def(
    "why_unsupported",
    [](const std::string& kind, const std::string& option)
    { return WhyUnsupported(FindRunKind(kind), Row(option)); },
    nb::arg("kind"), nb::arg("option"),
    "Why a kind of run does not have an option, by the names of both; empty if it has it.");
  module.def(
    "check_number",
    [](const std::string& name, double minimum, double maximum, bool isWhole,
      const std::string& unit, double value) {
      return CheckNumber(name, { minimum, maximum, isWhole, unit }, value);
    },
    nb::arg("name"), nb::arg("minimum"), nb::arg("maximum"), nb::arg("is_whole"), nb::arg("unit"),
    nb::arg("value"), "What is wrong with a number, in one sentence; empty if nothing is.");
}

void BindProfiles(nb::module_& module)
{
  nb::class_<Profile>(module, "Profile", "A built-in profile: options for a purpose.")
    .def_prop_ro("name", [](const Profile& profile) { return std::string(profile.Name); })
    .def_prop_ro("purpose", [](const Profile& profile) { return std::string(profile.Purpose); })
    .def_prop_ro(
      "options",
      [](const Profile& profile)
      {
        std::vector<std::tuple<std::string, std::string, std::string>> options;
        for (const ProfileOption& option : profile.Options)
        {
          options.emplace_back(option.Flag, option.Value, option.Reason);
        }
        return options;
      },
      "Flag without dashes, value and reason of each.");
  module.def(
    "profile_table", [] { return ProfileTable(); }, "All built-in profiles.");
  module.def("alternatives_to", &AlternativesTo, nb::arg("flag"),
    "The flags of the options that say the same in another way, with itself.");
}
}

//------------------------------------------------------------------------------
void BindOptions(nb::module_& module)
{
  BindEnums(module);
  BindTable(module);
  BindProfiles(module);
  nb::class_<Options>(module, "Options", "The values of all options.")
    .def(nb::init<>())
    .def(
      "get",
      [](const Options& options, const std::string& name) { return GetOption(options, Row(name)); },
      nb::arg("name"))
    .def("set", &Set, nb::arg("name"), nb::arg("value"),
      "Raises ValueError for a value outside its range; returns whether anything changed.")
    .def("read", &Read, nb::arg("name"), nb::arg("text"),
      "Raises ValueError if the text is none of the option's values.")
    .def(
      "text",
      [](const Options& options, const std::string& name)
      { return OptionText(options, Row(name)); },
      nb::arg("name"));
  module.def(
    "empty_report", [] { return ToList(ReportEntries(Report())); },
    "The entries before the first run.");
  module.def(
    "empty_json", [] { return ReportJson(ReportEntries(Report())); },
    "The report before the first run.");
  module.def(
    "changed_surface_sentence", [] { return ChangedSurfaceSentence; },
    "In a report that travels with another surface than the proved one.");
  module.def("report_json", &JsonOf, nb::arg("entries"),
    "The JSON text of a list of entries (name, unit, value).");
  module.def(
    "key_figures", [] { return KeyFigures(); },
    "Names of the entries that the field data has as arrays of their own.");
  module.def(
    "certificate_key_figures", [] { return CertificateKeyFigures(); },
    "The same of a certificate.");
  module.def("stop_sentence", &StopReasonSentence, nb::arg("reason"));
  module.attr("__version__") = Version();
}
}
