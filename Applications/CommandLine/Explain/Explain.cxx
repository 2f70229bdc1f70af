// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Explain/Explain.h"

#include "Arguments/HelpFormatter.h"
#include "Batch/BatchPlan.h"
#include "Batch/EarlierResults.h"
#include "BoneVolume.h"
#include "Explain/ExplainBound.h"
#include "Explain/ExplainInput.h"
#include "Explain/ExplainStages.h"
#include "Explain/Explanation.h"
#include "Formats/FileChecks.h"
#include "Formats/SurfaceFormat.h"
#include "NumberText.h"
#include "Runs/FilterRun.h"
#include "Segments/SegmentOutput.h"
#include "VolumeFile.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// Each option of the command line with where it is from.
void ExplainOptions(const Arguments& arguments, Explanation& explanation)
{
  for (const auto& [flag, text] : arguments.Given)
  {
    const bool isAdded = arguments.Settings.Options.count(flag) > 0;
    const auto& table = OptionTable();
    const auto info = std::find_if(table.begin(), table.end(),
      [&flag = flag](const OptionInfo& one) { return one.Flag == flag; });
    const bool isDefault = info != table.end() && text == OptionText(Options{}, *info);
    std::string line = "--" + flag;
    line.append(" ").append(text);
    line.append(isAdded ? ", from " + OriginText(arguments.Settings) : "");
    line.append(isDefault ? ", the default" : "");
    explanation.Add("options", line);
  }
  for (const std::string& flag : arguments.Settings.Overridden)
  {
    explanation.Add("options",
      "--" + flag + " of " + OriginText(arguments.Settings) + " gives way to the command line");
  }
}

std::string FormatText(const SurfaceFormat& format, bool isSingle)
{
  std::string text = format.Extension;
  text += !format.HoldsDoubles ? ", single precision"
    : format.HasGrid           ? ", whole multiples of a step"
    : isSingle                 ? ", single precision"
                               : ", double precision";
  text += format.HoldsArrays ? ", arrays" : ", no arrays";
  return text + (format.NamesUnit ? ", names its unit" : "");
}

void ExplainOutputs(const Arguments& arguments, bool isSingle, Explanation& explanation)
{
  if (const SurfaceFormat* format = FindFormat(arguments.Output); format != nullptr)
  {
    explanation.Add("writes", "'" + arguments.Output + "': " + FormatText(*format, isSingle));
  }
  else if (WritesSegments(arguments))
  {
    explanation.Add("writes",
      "'" + arguments.Output + "': a surface for each segment, " +
        FormatText(*FormatsOfSurfaces(arguments).front(), isSingle));
  }
  for (const std::string& file : arguments.Also)
  {
    explanation.Add("writes", "'" + file + "': " + FormatText(*FindFormat(file), isSingle));
  }
  for (const std::string* file :
    { &arguments.Heatmap, &arguments.Report, &arguments.Page, &arguments.Picture })
  {
    if (!file->empty())
    {
      explanation.Add("writes", "'" + *file + "'");
    }
  }
}

void ExplainSurface(const Arguments& arguments, Explanation& explanation)
{
  const std::string& path = arguments.Inputs[0];
  CheckFile(path);
  std::vector<std::string> warnings;
  const MillimeterSurface loaded = ReadInput(path, arguments.Unit, warnings);
  const auto triangles = static_cast<double>(loaded.Surface->GetNumberOfPolys());
  explanation.Add("input",
    "'" + path + "': " + GroupedText(triangles) + " triangles, " +
      GroupedText(static_cast<double>(loaded.Surface->GetNumberOfPoints())) + " points, " +
      (loaded.IsSingle() ? "single" : "double") + " precision, diagonal " +
      LengthText(loaded.Surface->GetLength()));
  for (const std::string& warning : warnings)
  {
    explanation.Add("warning", warning);
  }
  const Options options =
    ExplainBound(arguments, { loaded.Surface, loaded.InFile, 0.0 }, explanation);
  ExplainStages(arguments, options, triangles, explanation);
  ExplainOutputs(arguments, options.WritesSingle(loaded.IsSingle()), explanation);
  ExplainUnchecked(arguments, true, explanation);
}

/// By its header: voxels are not read.
void ExplainVolume(const Arguments& arguments, Explanation& explanation)
{
  const std::string& path = arguments.Inputs[0];
  const auto reader = volume::OpenVolume(path, arguments.LabelMap.GetSpacing());
  const volume::VolumeHeader& header = reader->GetHeader();
  if (!header.Problem.empty())
  {
    Reject(path, header.Problem);
  }
  std::string size;
  std::string spacing;
  double least = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double step = volume::Length(header.Geometry.Steps[axis]);
    size += (axis == 0 ? "" : " x ") + std::to_string(header.Size[axis]);
    spacing += (axis == 0 ? "" : " x ") + LengthText(step);
    least = axis == 0 ? step : std::min(least, step);
  }
  explanation.Add("input",
    "'" + path + "': volume of " + size + " voxels of " + spacing +
      "; its triangles are not known before it is read");
  BoundSubject subject = { nullptr, nullptr, least };
  if (!arguments.Iso && arguments.ModelGrid != "off")
  {
    subject.MayBeCoarser = true;
    subject.VoxelSize = arguments.ModelGrid == "auto" ? least : 0.0;
  }
  const Options options = ExplainBound(arguments, subject, explanation);
  if (arguments.Memory > 0)
  {
    explanation.Add(
      "memory", "in slabs if the whole needs more than " + arguments.Given.at("memory"));
  }
  ExplainStages(arguments, options, 0.0, explanation);
  ExplainOutputs(arguments, true, explanation);
  ExplainUnchecked(arguments, false, explanation);
}

void ExplainBatch(const Arguments& arguments, Explanation& explanation)
{
  const std::vector<BatchBone> bones = PlanBatch(arguments);
  RejectOtherOptions(bones, arguments);
  for (const BatchBone& bone : bones)
  {
    const bool isFinished = bone.IsBone() && !arguments.Force && HasEarlierResult(bone, arguments);
    explanation.Add(!bone.IsBone() ? "skipped"
        : isFinished               ? "finished"
                                   : "run",
      "'" + bone.Input + "'" + (bone.IsBone() ? " -> '" + bone.Output + "'" : ": " + bone.WhyNot));
  }
  const Options& options = arguments.Options;
  if (options.MaximumError > 0.0)
  {
    explanation.Add("bound", LengthText(options.MaximumError) + ": --max-error");
  }
  if (options.ErrorPreset != ErrorPreset::NoPreset)
  {
    explanation.Add(
      "bound", OptionText(options, *FindOption("ErrorPreset")) + " of the voxels of each");
  }
  ExplainStages(arguments, options, 0.0, explanation);
  explanation.Add("writes", "'" + arguments.Output + "': surfaces, reports and summary.csv");
  ExplainUnchecked(arguments, false, explanation);
}

/// What the run would be rejected for; options without effect all together.
std::vector<std::string> Problems(const Arguments& arguments)
{
  std::vector<std::string> problems = IneffectiveSentences(arguments);
  try
  {
    CheckArguments(arguments);
  }
  catch (const Failure& failure)
  {
    if (std::find(problems.begin(), problems.end(), failure.what()) == problems.end())
    {
      problems.emplace_back(failure.what());
    }
    return problems;
  }
  const std::vector<std::string> ofFolders = MissingFolders(arguments);
  problems.insert(problems.end(), ofFolders.begin(), ofFolders.end());
  return problems;
}
}

void AddExplain(CLI::App& app, Arguments& arguments)
{
  app
    .add_flag("--explain", arguments.IsExplained,
      WrappedHelp(
        "Print what the run would do with these options on this input: stages, the bound at each "
        "point and how it "
        "is derived, formats, and options without effect. Nothing is run and nothing is written."))
    ->configurable(false);
}

ExitCode Explain(const Arguments& arguments)
{
  if (arguments.Quiet)
  {
    throw Failure(ExitCode::Usage, "--explain prints what --quiet would hide");
  }
  const std::vector<std::string> problems = Problems(arguments);
  Explanation explanation;
  ExplainOptions(arguments, explanation);
  for (const std::string& problem : problems)
  {
    explanation.Add("rejected", WithOrigin(problem, arguments.Settings));
  }
  if (problems.empty())
  {
    IsBatch(arguments)                ? ExplainBatch(arguments, explanation)
      : IsVolume(arguments.Inputs[0]) ? ExplainVolume(arguments, explanation)
                                      : ExplainSurface(arguments, explanation);
  }
  explanation.Print();
  return problems.empty() ? ExitCode::Done : ExitCode::Usage;
}
}
