// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ArgumentKinds.h"
#include "Arguments.h"
#include "CommonOptions.h"
#include "FileGrid.h"
#include "FilePath.h"
#include "Files/FileNames.h"
#include "FlagNames.h"
#include "Formats/FileChecks.h"
#include "Formats/SurfaceFormat.h"

#include "Base/Text.h"
#include "BoneVolume.h"
#include "ExitCode.h"
#include "Files/SameFile.h"
#include "MemoryArguments.h"
#include "Options/OptionTable.h"
#include "Options/UnmetNeeds.h"
#include "Picture.h"
#include "Segments/SegmentOutput.h"

#include <algorithm>
#include <filesystem>

namespace fs = std::filesystem;

namespace bonedecimate
{
namespace
{
/// The first thing to say of a command line whose files are all misspelled.
void RequireInput(const std::string& path)
{
  std::error_code error;
  if (!fs::exists(FilePath(path), error))
  {
    Reject(path, path.back() == '/' ? "there is no such folder" : "there is no such file");
  }
}

void RequireSurfaceFormat(const std::string& what, const std::string& path)
{
  RequireUsage(FindFormat(path) != nullptr,
    what + " '" + path + "' needs one of the extensions " + SurfaceExtensions());
  RequireUsage(LackText(path).empty(), what + " " + LackText(path));
}

/// What is proved is proved of coordinates as they will be read.
void CheckPrecision(const Arguments& arguments)
{
  const bool isProved = arguments.Options.ProvesError() &&
    (arguments.Options.BoundsError() || !arguments.Options.ToleranceArrayName.empty() ||
      !arguments.Regions.empty());
  for (const SurfaceFormat* format : FormatsOfSurfaces(arguments))
  {
    RequireUsage(!isProved || arguments.Options.OutputPointsPrecision != PointsPrecision::Double ||
        format->HoldsDoubles,
      std::string("--precision Double has no effect with a largest error; ") + format->Extension +
        " holds single precision");
  }
}

void CheckFormat(const Arguments& arguments)
{
  const std::string file = "x." + arguments.Format;
  RequireUsage(arguments.Format.empty() || FindFormat(file) != nullptr,
    "--format '" + arguments.Format + "' is none of " + SurfaceExtensions());
  RequireUsage(arguments.Format.empty() || LackText(file).empty(), "--format: " + LackText(file));
}

/// Files that name their unit are not in that of --unit.
void CheckUnit(const Arguments& arguments)
{
  for (const std::string& file : { arguments.Inputs[0], arguments.Reference })
  {
    const SurfaceFormat* const format = FindFormat(file);
    RequireUsage(arguments.Unit.IsMillimeter() || format == nullptr || !format->NamesUnit ||
        format->UnitMayDiffer, // which the file shows, see RequireUnitOfFile()
      "--unit is for files that do not name their unit; '" + file + "' does");
  }
}

void CheckOneBone(const Arguments& arguments)
{
  if (!WritesSegments(arguments))
  {
    if (FindFormat(arguments.Output) == nullptr)
    {
      RequireInput(arguments.Inputs[0]);
    }
    RequireUsage(!IsBlockFile(arguments.Output),
      "'" + arguments.Output +
        "' has a block for each segment of a label map; it needs --segments");
    RequireSurfaceFormat("the output", arguments.Output);
  }
  CheckFormat(arguments);
  for (const std::string& file : arguments.Also)
  {
    RequireSurfaceFormat("--also", file);
  }
  const SurfaceFormat* const heatmap = FindFormat(arguments.Heatmap);
  RequireUsage(arguments.Heatmap.empty() || (heatmap != nullptr && heatmap->HoldsArrays),
    "--heatmap '" + arguments.Heatmap + "' needs an extension whose format holds arrays: " +
      ExtensionsThat(&SurfaceFormat::HoldsArrays));
  RequireUsage(arguments.Picture.empty() || ExtensionOf(arguments.Picture) == "png",
    "--picture '" + arguments.Picture + "' needs the extension png");
  RequireUsage(
    arguments.Picture.empty() || WhyNoPictures().empty(), "--picture: " + WhyNoPictures());
  RequireUsage(arguments.Reference.empty() || arguments.Options.BoundsError(),
    "--reference needs --max-error or --preset, in every mode but " +
      ModeNamesWhere([](const ModeInfo& mode) { return !mode.ProvesError(); }));
  const bool volume = IsVolume(arguments.Inputs[0]);
  RequireUsage(!volume || arguments.Iso || arguments.Segments.IsRequested(),
    "'" + arguments.Inputs[0] +
      "' is a volume: --iso HU or, of a label map, --segments says which surface to take");
  RequireUsage(volume || !arguments.Iso || !fs::exists(FilePath(arguments.Inputs[0])),
    "--iso is for volumes; '" + arguments.Inputs[0] + "' is none: read are " + ReadVolumesText());
  CheckPrecision(arguments);
  CheckUnit(arguments);
  RequireDistinct(OutputsOf(arguments),
    { arguments.Inputs[0], arguments.Reference, arguments.LabelMap.Path,
      arguments.Segments.LabelNames });
  RequireExtension("--report", arguments.Report, { "json" });
  RequireExtension("--page", arguments.Page, { "html", "htm" });
}

void CheckBatch(const Arguments& arguments)
{
  CheckFormat(arguments);
  std::error_code error;
  if (arguments.Inputs.size() > 1)
  {
    RequireFolderName(arguments.Output);
  }
  RequireUsage(!fs::exists(FilePath(arguments.Output), error) ||
      fs::is_directory(FilePath(arguments.Output), error),
    "'" + arguments.Output + "' is a file; many bones need an output folder");
  RequireUsage(
    fs::is_directory(FilePath(arguments.Output), error) || !IsNamedLikeFile(arguments.Output),
    "'" + arguments.Output + "' is named like a file; it would become an output folder" +
      (arguments.Inputs.size() == 1
          ? ": '" + arguments.Inputs[0] + "' has neither a DICOM series nor slices of one volume"
          : ""));
  for (const std::string& input : arguments.Inputs)
  {
    RequireUsage(
      !IsSameFile(input, arguments.Output), "'" + input + "' is input and output folder at once");
  }
}

/// The inputs, and what is in the folders of a batch and below.
std::vector<std::string> FilesOf(const Arguments& arguments)
{
  std::vector<std::string> files = arguments.Inputs;
  for (const std::string& input : arguments.Inputs)
  {
    std::error_code error;
    const auto options = fs::directory_options::skip_permission_denied;
    for (fs::recursive_directory_iterator entry(FilePath(input), options, error);
         !error && entry != fs::recursive_directory_iterator(); entry.increment(error))
    {
      files.push_back(entry->path().string());
    }
  }
  return files;
}
}

void RequireFolderName(const std::string& output)
{
  std::error_code error;
  RequireUsage(fs::exists(FilePath(output), error) || !ParseFinite(output),
    "'" + output +
      "' is no folder; an option takes its value behind its name, for example --max-error " +
      output);
}

bool IsNamedLikeFile(std::string path)
{
  path.erase(path.find_last_not_of('/') + 1);
  const std::string extension = ExtensionOf(path);
  const auto others = { "json", "html", "png", "svg", "csv" };
  return FindFormat(path) != nullptr || IsVolumeFile(path) ||
    std::find(others.begin(), others.end(), extension) != others.end();
}

bool IsBatch(const Arguments& arguments)
{
  std::error_code error;
  const std::string& input = arguments.Inputs[0];
  if (arguments.ThesisForm)
  {
    return false;
  }
  if (arguments.Segments.IsRequested() && arguments.Inputs.size() == 1 && IsVolume(input))
  {
    return false; // a folder is for the segments
  }
  return arguments.Inputs.size() > 1 ||
    (fs::is_directory(FilePath(input), error) && !IsVolume(input)) ||
    fs::is_directory(FilePath(arguments.Output), error) || arguments.Output.back() == '/';
}

/// 3D Slicer gives every option; there those count that do not have their default.
std::vector<std::string> IneffectiveSentences(const Arguments& arguments)
{
  Options options = arguments.Options;
  if (options.ToleranceArrayName.empty() && !arguments.Regions.empty())
  {
    options.ToleranceArrayName = "Tolerance";
  }
  std::vector<std::string> given;
  for (const OptionInfo& info : OptionTable())
  {
    if (arguments.Given.count(info.Flag) > 0)
    {
      given.push_back(info.Name);
    }
  }
  std::vector<std::string> sentences =
    UnmetNeeds(options, arguments.HasTags ? ChangedOptions(options) : given);
  std::transform(sentences.begin(), sentences.end(), sentences.begin(), WithFlags);
  return sentences;
}

std::vector<std::string> OutputsOf(const Arguments& arguments)
{
  std::vector<std::string> outputs = arguments.Also;
  outputs.insert(outputs.begin(), arguments.Output);
  outputs.insert(
    outputs.end(), { arguments.Report, arguments.Page, arguments.Heatmap, arguments.Picture });
  return outputs;
}

/// An error of 0 is none. What ends the run must then not be the default of another option.
void CheckZeroError(const Arguments& arguments)
{
  const Options& options = arguments.Options;
  const OptionInfo& error = *FindOption("MaximumError");
  const OptionInfo& reduction = *FindOption("TargetReduction");
  const bool isSet = arguments.Given.count(error.Flag) > 0 && !arguments.HasTags;
  const bool isLimited = options.ErrorPreset != ErrorPreset::NoPreset ||
    !options.ToleranceArrayName.empty() || !arguments.Regions.empty();
  RequireUsage(!isSet || options.MaximumError > 0.0 || options.TargetReductionIsExplicit ||
      !options.EndsAtReduction(isLimited),
    "--" + error.Flag + " 0 sets no largest error, and nothing else ends the run; --" +
      reduction.Flag + " 0 keeps every triangle");
}

void CheckArguments(const Arguments& arguments)
{
  const bool named = !arguments.Output.empty() &&
    std::none_of(arguments.Inputs.begin(), arguments.Inputs.end(),
      [](const std::string& input) { return input.empty(); });
  RequireUsage(named, "a name is empty");
  const std::vector<std::string> ineffective = IneffectiveSentences(arguments);
  RequireUsage(ineffective.empty(), ineffective.empty() ? "" : ineffective.front());
  const std::string contradiction = FindContradiction(arguments);
  RequireUsage(contradiction.empty(), contradiction);
  CheckZeroError(arguments);
  CheckMemory(arguments);
  CheckSegments(arguments);
  CheckLabel(arguments.LabelMap, "--label-map");
  if (!arguments.LabelMap.Spacing.empty() || !arguments.LabelMap.Series.empty())
  {
    CheckSpacing(arguments.LabelMap, FilesOf(arguments));
    CheckSeries(arguments.LabelMap, FilesOf(arguments));
  }
  if (IsBatch(arguments))
  {
    CheckBatch(arguments);
  }
  else
  {
    CheckOneBone(arguments);
  }
  CheckFileOptions(arguments);
}
}
