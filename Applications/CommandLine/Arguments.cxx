// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"

#include "CommonOptions.h"
#include "ExitCode.h"
#include "FileNames.h"
#include "HelpFormatter.h"
#include "InputArguments.h"
#include "Options/OptionTable.h"

#include <CLI/CLI.hpp>

#include <iomanip>
#include <sstream>

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

/// A number, or "auto" for the option AutomaticSmoothing.
void AddSmoothing(CLI::App& app, const OptionReceiver& give)
{
  const OptionInfo& info = *FindOption("Smoothing");
  const CLI::Validator isNumber = ValueOf(info);
  app
    .add_option_function<std::string>(
      "--" + info.Flag,
      [give, &info](const std::string& text)
      {
        const bool isAutomatic = text == "auto";
        give(isAutomatic ? *FindOption("AutomaticSmoothing") : info, isAutomatic ? "on" : text);
      },
      WrappedHelp(OptionHelp(info) + " auto is --auto-smooth on."))
    ->type_name("MM|auto")
    ->check(CLI::Validator([isNumber](std::string& text)
      { return text == "auto" ? std::string() : isNumber(text); },
      ""));
}

OptionReceiver ReceiverOf(Arguments& arguments)
{
  return [&arguments](const OptionInfo& info, const std::string& text)
  { GiveOption(arguments, info, text); };
}

void AddIso(CLI::App& app, Arguments& arguments)
{
  AddNumber(app,
    { "--iso", "HU", HounsfieldRange,
      "The input is a CT volume (.vti, .mha, .mhd, .nrrd, .nhdr, a DICOM folder): take the bone "
      "surface at this Hounsfield value, for example 226." },
    [&arguments](double hounsfield)
    {
      arguments.Iso = hounsfield;
      std::ostringstream text;
      text << std::setprecision(17) << hounsfield;
      arguments.Given["iso"] = text.str();
    });
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
    ->type_name("FILE")
    ->expected(1)
    ->take_all()
    ->allow_extra_args(false);
  AddFile(app, "--reference", arguments.Reference,
    "The surface from which INPUT was made by runs before: --max-error is proved "
    "against it, and distances are measured to it.");
  AddLabelMap(app, arguments.LabelMap, "--label-map",
    "The label map (.vti, .mha, .mhd, .nrrd, .nhdr) from which INPUT was extracted: its voxels are "
    "those of --keep-voxels and --smooth, and the result is compared with it.");
  AddUnit(app, arguments.Unit);
  AddFile(app, "--report", arguments.Report, "Write the report as JSON.");
  AddFile(app, "--page", arguments.Page,
    "Write a self-contained HTML page for people, with the picture in it.");
  AddFile(app, "--heatmap", arguments.Heatmap,
    "Write the input surface, in a format that holds arrays, with the distance in mm of each of "
    "its points to the "
    "result.");
  AddFile(app, "--picture", arguments.Picture,
    "Draw before, after and the distances as colors into a PNG. If it cannot be drawn everything "
    "else is written and the program ends with 3; for --page alone it is a warning.");
  AddQuiet(app, arguments.Quiet);
}

void AddBatchFlags(CLI::App& app, Arguments& arguments)
{
  AddNumber(app,
    { "--jobs", "N", { 1, 1024, true, "processes" },
      "Many bones: how many at once, each a process of its own." },
    [&arguments](double jobs) { arguments.Jobs = static_cast<int>(jobs); });
  app.add_flag("--force", arguments.Force,
    WrappedHelp("Many bones: do those again that are finished already."));
  app
    .add_option("--format", arguments.Format,
      WrappedHelp("Many bones: format of the outputs by its extension; default that of each input, "
                  "vtp for volumes."))
    ->type_name("EXT");
}
}

void AddOptionOfTable(CLI::App& app, const OptionInfo& info, const OptionReceiver& give)
{
  if (info.Name == "Smoothing")
  {
    AddSmoothing(app, give);
  }
  else
  {
    AddTableOption(app, info, give);
  }
}

void GiveOption(Arguments& arguments, const OptionInfo& info, const std::string& text)
{
  SetOptionFromText(arguments.Options, info, text);
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
  AddIntensities(app, arguments);
  AddRegions(app, arguments.Regions,
    [&arguments](const std::string& all) { arguments.Given["region"] = all; });
  AddCommonFlags(app, arguments);
  AddBatchFlags(app, arguments);
}

void AddSmoothOptions(CLI::App& app, Arguments& arguments)
{
  app.add_option("FILES", arguments.Inputs, "INPUT OUTPUT")->type_name("")->allow_extra_args();
  for (const char* name : { "Smoothing", "FeatureAngle", "MaximumError", "AllowLargeError",
         "ToleranceArrayName", "LabelArrayName", "MergePoints", "MeasureDistances", "ProveResult",
         "NumberOfThreads", "OutputPointsPrecision", "PassArrays", "RecomputeNormals" })
  {
    AddOptionOfTable(app, *FindOption(name), ReceiverOf(arguments));
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
    throw Failure(ExitCode::Usage, "an INPUT and an OUTPUT are needed; see bonedecimate --help");
  }
  arguments.Output = arguments.Inputs.back();
  arguments.Inputs.pop_back();
  if (!arguments.Unit.IsMillimeter())
  {
    arguments.Given["unit"] = arguments.Unit.Name;
  }
  if (!arguments.LabelMap.Path.empty())
  {
    arguments.Given["label-map"] = BaseName(arguments.LabelMap.Path);
  }
  if (arguments.LabelMap.Label != 0)
  {
    arguments.Given["label"] = std::to_string(arguments.LabelMap.Label);
  }
}
}
