// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"

#include "Base/Text.h"
#include "CommonOptions.h"
#include "ExitCode.h"
#include "FileGrid.h"
#include "Files/FileNames.h"
#include "HelpFormatter.h"
#include "InputArguments.h"
#include "MemoryArguments.h"
#include "Options/NumberRange.h"
#include "Options/OptionTable.h"
#include "Options/RunKinds.h"
#include "Segments/VoxelPieces.h"

#include <CLI/CLI.hpp>

#include <map>
#include <optional>
#include <utility>

namespace bonedecimate
{
namespace
{
void AddTableOption(CLI::App& app, const OptionInfo& info, const OptionReceiver& give)
{
  app
    .add_option_function<std::string>(
      "--" + info.Flag, [give, &info](const std::string& text) { give(info, text); },
      OptionHelp(info))
    ->type_name(OptionValueName(info))
    ->check(ValueOf(info));
}

/// A number, or a word for an option of the table with a value.
struct NumberOrWord
{
  const char* Option;
  const char* ValueName;
  const char* Help; ///< Behind that of the option.
  std::map<std::string, std::pair<const char*, const char*>> Words;
  const char* Accepted; ///< "auto".
};

const NumberOrWord SmoothingForm = { "Smoothing", "MM|auto", " auto is --auto-smooth on.",
  { { "auto", { "AutomaticSmoothing", "on" } } }, "auto" };

const NumberOrWord ErrorForm = { "MaximumError", "MM|quartervoxel|halfvoxel|voxel",
  " quartervoxel, halfvoxel and voxel, or 0.25voxel, 0.5voxel and 1voxel, are the values of "
  "--preset.",
  { { "quartervoxel", { "ErrorPreset", "QuarterVoxel" } },
    { "0.25voxel", { "ErrorPreset", "QuarterVoxel" } },
    { "halfvoxel", { "ErrorPreset", "HalfVoxel" } }, { "0.5voxel", { "ErrorPreset", "HalfVoxel" } },
    { "voxel", { "ErrorPreset", "OneVoxel" } }, { "onevoxel", { "ErrorPreset", "OneVoxel" } },
    { "1voxel", { "ErrorPreset", "OneVoxel" } } },
  "quartervoxel, halfvoxel or voxel" };

void AddNumberOrWord(CLI::App& app, const NumberOrWord& form, const OptionReceiver& give)
{
  const OptionInfo& info = *FindOption(form.Option);
  const CLI::Validator isNumber = ValueOf(info);
  app
    .add_option_function<std::string>(
      "--" + info.Flag,
      [give, &info, &form](const std::string& text)
      {
        const auto word = form.Words.find(LowerCase(text));
        const bool isNumberText = word == form.Words.end();
        give(isNumberText ? info : *FindOption(word->second.first),
          isNumberText ? text : word->second.second);
      },
      WrappedHelp(OptionHelp(info) + form.Help))
    ->type_name(form.ValueName)
    ->check(CLI::Validator(
      [isNumber, &form](std::string& text)
      {
        const std::string problem =
          form.Words.count(LowerCase(text)) > 0 ? std::string() : isNumber(text);
        const std::size_t end = problem.rfind(", not '");
        return problem.empty() || end == std::string::npos
          ? problem
          : problem.substr(0, end) + ", or " + form.Accepted + problem.substr(end);
      },
      ""));
}

OptionReceiver ReceiverOf(Arguments& arguments)
{
  return [&arguments](const OptionInfo& info, const std::string& text)
  { GiveOption(arguments, info, text); };
}

void AddIso(CLI::App& app, Arguments& arguments)
{
  AddIsoValue(
    app,
    [&arguments](double value)
    {
      arguments.Iso = value;
      arguments.Given["iso"] = NumberText(value);
    },
    "The input is a CT volume (.nii, .nrrd, .mha, .tif, .vti ..., a folder of DICOM files or TIFF "
    "slices): take the bone surface at this Hounsfield value.");
}

/// "0.5,0.5,1"
std::string NumberListText(const std::vector<double>& numbers)
{
  std::string text;
  for (const double number : numbers)
  {
    text += (text.empty() ? "" : ",") + NumberText(number);
  }
  return text;
}

void AddIntensities(CLI::App& app, Arguments& arguments)
{
  AddSwitch(
    app, "--intensities",
    [&arguments](bool on)
    {
      arguments.TakesLabels = on;
      arguments.Given["intensities"] = on ? "on" : "off";
    },
    "Take the values of a volume for intensities even where they look like the labels of a "
    "segmentation, which is rejected otherwise; default off.");
}

void AddCommonFlags(CLI::App& app, Arguments& arguments)
{
  app
    .add_option("--also", arguments.Also,
      WrappedHelp("Write the surface to this file, too; may be repeated."))
    ->type_name("SURFACE")
    ->expected(1)
    ->take_all()
    ->allow_extra_args(false);
  AddFile(app, "--reference", "SURFACE", arguments.Reference,
    "The surface from which INPUT was made by runs before: --max-error is proved "
    "against it, and distances are measured to it.");
  AddLabelMap(app, arguments.LabelMap, "--label-map",
    "The label map (.nii, .nrrd, .mha, .dcm, .tif, .vti ...) from which INPUT was extracted: its "
    "voxels "
    "are those of --keep-voxels and --smooth, and the result is compared with it.");
  AddUnit(app, arguments.Unit);
  AddFileOptions(app, arguments);
  AddFile(app, "--report", "JSON", arguments.Report, "Write the report as JSON.");
  AddFile(app, "--page", "HTML", arguments.Page,
    "Write a self-contained HTML page for people, with the picture and an interactive view in it.");
  AddFile(app, "--heatmap", "SURFACE", arguments.Heatmap,
    "Write the input surface, in a format that holds arrays, with the distance in mm of each of "
    "its points to the "
    "result.");
  AddFile(app, "--picture", "PNG", arguments.Picture,
    "Draw before, after and the distances as colors into a PNG. If it cannot be drawn everything "
    "else is written and the program ends with 3; for --page alone it is a warning.");
  AddQuiet(app, arguments.Quiet);
  app.add_flag("--progress", arguments.ShowsProgress,
    WrappedHelp("Show the phase of the run and the time left, also where the error output is no "
                "terminal: a line every 10 %, of many bones one whenever a bone has ended."));
}

/// @throws Failure(ExitCode::Usage)
ShardOfBatch ReadShard(const std::string& text)
{
  const std::size_t slash = text.find('/');
  const auto isNumber = [](const std::string& digits)
  {
    return !digits.empty() && digits.size() < 7 &&
      digits.find_first_not_of("0123456789") == std::string::npos;
  };
  ShardOfBatch shard;
  if (slash != std::string::npos && isNumber(text.substr(0, slash)) &&
    isNumber(text.substr(slash + 1)))
  {
    shard = { std::stoul(text.substr(0, slash)), std::stoul(text.substr(slash + 1)) };
  }
  if (shard.Number < 1 || shard.Number > shard.Of)
  {
    throw Failure(ExitCode::Usage,
      "--shard takes two numbers I/N with I from 1 to N, as 3/8, not '" + text + "'");
  }
  return shard;
}

void AddBatchFlags(CLI::App& app, Arguments& arguments)
{
  AddNumber(app,
    { "--jobs", "N", { 1, 1024, true, "processes" },
      "Many bones: how many at once, each a process of its own." },
    [&arguments](double jobs) { arguments.Jobs = static_cast<int>(jobs); });
  AddNumber(app,
    { "--time-limit", "S", { 1, 1e6, false, "seconds" },
      "Many bones: an input that takes longer is stopped and has failed. Default: no limit." },
    [&arguments](double seconds) { arguments.TimeLimit = seconds; });
  AddMemoryLimit(app, arguments);
  app
    .add_option_function<std::string>(
      "--shard", [&arguments](const std::string& text) { arguments.Shard = ReadShard(text); },
      WrappedHelp("Many bones: only every N-th input, from number I on, as one of N jobs of a "
                  "scheduler: 3/8."))
    ->type_name("I/N");
  app.add_flag("--force", arguments.Force,
    WrappedHelp("Many bones: do those again that are finished already."));
  app
    .add_option("--only", arguments.Only,
      WrappedHelp("Many bones: of the folders only files whose name, or path below the folder, "
                  "matches this pattern, as of the shell: '*_seg.nii.gz'."))
    ->type_name("PATTERN");
  app
    .add_option_function<std::string>(
      "--format",
      [&arguments](const std::string& extension)
      { arguments.Format = extension.substr(extension[0] == '.' ? 1 : 0); },
      WrappedHelp("Outputs in a folder: their format by its extension; default that of each "
                  "input, vtp for volumes and segments."))
    ->type_name("EXT");
}
}

Progress ProgressOf(const Arguments& arguments)
{
  return arguments.HasTags    ? Progress::Tags
    : arguments.Quiet         ? Progress::Hidden
    : arguments.ShowsProgress ? Progress::Lines
                              : Progress::Bar;
}

void AddOptionOfTable(CLI::App& app, const OptionInfo& info, const OptionReceiver& give)
{
  if (info.Name == SmoothingForm.Option)
  {
    AddNumberOrWord(app, SmoothingForm, give);
  }
  else if (info.Name == ErrorForm.Option)
  {
    AddNumberOrWord(app, ErrorForm, give);
  }
  else
  {
    AddTableOption(app, info, give);
  }
}

void GiveOption(Arguments& arguments, const OptionInfo& info, const std::string& text)
{
  const auto given = arguments.Given.find(info.Flag);
  const std::string before = given == arguments.Given.end() ? std::string() : given->second;
  SetOptionFromText(arguments.Options, info, text);
  if (!before.empty() && before != OptionText(arguments.Options, info))
  {
    throw Failure(ExitCode::Usage, "--" + info.Flag + " is both " + before + " and " + text);
  }
  arguments.Given[info.Flag] = OptionText(arguments.Options, info);
}

void AddDecimateOptions(CLI::App& app, Arguments& arguments)
{
  app
    .add_option("FILES", arguments.Inputs,
      WrappedHelp("INPUT OUTPUT, or several inputs or a folder, and an output folder."))
    ->type_name("")
    ->allow_extra_args();
  for (const OptionInfo& info : OptionTable())
  {
    if (!info.Flag.empty())
    {
      AddOptionOfTable(app, info, ReceiverOf(arguments));
    }
  }
  AddIso(app, arguments);
  const auto given = [&arguments](const std::string& flag, const std::string& text)
  { arguments.Given[flag] = text; };
  AddSegments(app, arguments.Segments, given);
  AddModelGrid(app, arguments.ModelGrid, given);
  AddIntensities(app, arguments);
  AddMemory(app, arguments);
  AddFillVolume(app, arguments);
  AddRegions(app, arguments.Regions,
    [&arguments](const std::string& all) { arguments.Given["region"] = all; });
  AddCommonFlags(app, arguments);
  AddBatchFlags(app, arguments);
}

void AddSmoothOptions(CLI::App& app, Arguments& arguments)
{
  app.add_option("FILES", arguments.Inputs, "INPUT OUTPUT")->type_name("")->allow_extra_args();
  const RunKind& kind = FindRunKind("SmoothFilter");
  for (const OptionInfo& info : OptionTable())
  {
    if (!info.Flag.empty() && WhyUnsupported(kind, info).empty())
    {
      AddOptionOfTable(app, info, ReceiverOf(arguments));
    }
  }
  AddRegions(app, arguments.Regions,
    [&arguments](const std::string& all) { arguments.Given["region"] = all; });
  AddCommonFlags(app, arguments);
}

void AddThesisOptions(CLI::App& app, Arguments& arguments)
{
  AddOptionOfTable(app, *FindOption("NumberOfThreads"), ReceiverOf(arguments));
  AddIso(app, arguments);
  AddIntensities(app, arguments);
  AddCommonFlags(app, arguments);
}

void TakeFiles(Arguments& arguments)
{
  if (arguments.Inputs.size() < 2)
  {
    throw Failure(ExitCode::Usage,
      "an INPUT and an OUTPUT are needed; see bonedecimate -h, or try bonedecimate demo");
  }
  arguments.Output = arguments.Inputs.back();
  arguments.Inputs.pop_back();
  if (arguments.Unit.IsRequested)
  {
    arguments.Given["unit"] = arguments.Unit.Name;
  }
  if (!arguments.LabelMap.Path.empty())
  {
    arguments.Given["label-map"] = BaseName(arguments.LabelMap.Path);
  }
  if (!arguments.Format.empty() && arguments.Segments.IsRequested())
  {
    // of files whose names are not those of the command line
    arguments.Given["format"] = LowerCase(arguments.Format);
  }
  if (arguments.LabelMap.Label != 0)
  {
    arguments.Given["label"] = std::to_string(arguments.LabelMap.Label);
  }
  if (!arguments.LabelMap.Spacing.empty())
  {
    arguments.Given["spacing"] = NumberListText(arguments.LabelMap.Spacing);
  }
  if (!arguments.LabelMap.Series.empty())
  {
    arguments.Given["series"] = arguments.LabelMap.Series;
  }
}

std::string OptionsText(const std::map<std::string, std::string>& given)
{
  std::string text;
  for (const auto& [flag, value] : given)
  {
    if (flag != FindOption("NumberOfThreads")->Flag) // the results are the same
    {
      text.append(text.empty() ? "--" : " --").append(flag).append(" ").append(value);
    }
  }
  return text;
}
}
