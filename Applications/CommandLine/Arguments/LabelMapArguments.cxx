// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelMapArguments.h"

#include "Arguments.h"
#include "BoneVolume.h"
#include "CommonOptions.h"
#include "ExitCode.h"
#include "Formats/FileChecks.h"
#include "HelpFormatter.h"
#include "LabelMaps/LabelVolume.h"

#include "vtkBoneDecimateAlgorithm.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace bonedecimate
{
namespace
{
const NumberRange LabelRange = { -9007199254740992.0, 9007199254740992.0, true, "" };
}

void AddLabelMap(CLI::App& app, LabelMapFile& map, const char* flags, const char* help)
{
  AddFile(app, flags, "LABELMAP", map.Path, help);
  AddNumber(app,
    { "--label", "N", LabelRange,
      "The label of the label map that a surface without the array BoundaryLabels encloses; "
      "default "
      "the only one that is not 0." },
    [&map](double value)
    {
      if (value == 0.0)
      {
        throw Failure(ExitCode::Usage, "--label 0 is the background, which no surface encloses");
      }
      map.Label = static_cast<std::int64_t>(value);
    });
  AddNumberList(app,
    { "--spacing", "X,Y,Z", PositiveLengthRange,
      "The distance of voxels along x, y and z, in mm, of volumes whose files have none, such as "
      "TIFF; one number if all are equal." },
    [&map](double value) { map.Spacing.push_back(value); });
  app
    .add_option_function<std::string>(
      "--series",
      [&map](const std::string& text)
      {
        map.Series = text;
        ChooseSeries(text);
      },
      WrappedHelp("Of a folder of several DICOM series: the one with this number in the list, this "
                  "unique identifier, or this text in its description; default the largest. A "
                  "choice that is not there, such as 0, shows the list."))
    ->type_name("N|UID|TEXT")
    ->check(CLI::Validator([](std::string& text)
      { return text.empty() ? "takes a number, a UID or a text, not ''" : std::string(); },
      ""));
}

VoxelSpacing LabelMapFile::GetSpacing() const
{
  const std::vector<double>& spacing = this->Spacing;
  return spacing.empty()
    ? VoxelSpacing()
    : VoxelSpacing({ { spacing[0], spacing[spacing.size() / 2], spacing.back() } });
}

void CheckSpacing(const LabelMapFile& map, const std::vector<std::string>& inputs)
{
  const std::size_t count = map.Spacing.size();
  if (count != 0 && count != 1 && count != 3)
  {
    throw Failure(
      ExitCode::Usage, "--spacing takes one or three numbers, not " + std::to_string(count));
  }
  const bool isNeeded =
    NeedsSpacing(map.Path) || std::any_of(inputs.begin(), inputs.end(), NeedsSpacing);
  if (count != 0 && !isNeeded)
  {
    throw Failure(ExitCode::Usage,
      "--spacing has no effect; it is for volumes that have none of their own, such as TIFF files");
  }
}

void CheckSeries(const LabelMapFile& map, const std::vector<std::string>& inputs)
{
  const bool isNeeded = HasSeries(map.Path) || std::any_of(inputs.begin(), inputs.end(), HasSeries);
  if (!map.Series.empty() && !isNeeded)
  {
    throw Failure(
      ExitCode::Usage, "--series has no effect; it is for folders of DICOM files and a DICOMDIR");
  }
}

void CheckLabel(const LabelMapFile& map, const std::string& flag)
{
  if (map.Label != 0 && map.Path.empty())
  {
    throw Failure(ExitCode::Usage, "--label has no effect; it needs " + flag + " FILE");
  }
}

vtkSmartPointer<vtkImageData> ReadLabels(const std::string& path,
  std::vector<std::string>& warnings, const VoxelSpacing& spacing,
  const SegmentSelection& selection)
{
  const LabelVolume labels = ReadLabelVolume(path, spacing, selection);
  if (!labels.Image)
  {
    Reject(path, labels.Problem);
  }
  if (!labels.Note.empty())
  {
    warnings.push_back(labels.Note);
  }
  return labels.Image;
}

void ApplyLabelMap(
  const LabelMapFile& map, vtkBoneDecimateAlgorithm* filter, std::vector<std::string>& warnings)
{
  if (!map.Path.empty())
  {
    filter->SetLabelMapData(ReadLabels(map.Path, warnings, map.GetSpacing()));
    filter->SetLabel(map.Label);
  }
}

void AddVoxelArguments(CLI::App& app, VoxelArguments& arguments)
{
  for (const char* name : { "Smoothing", "FeatureAngle", "KeepVoxels" })
  {
    AddOptionOfTable(app, *FindOption(name),
      [&arguments](const OptionInfo& info, const std::string& text)
      { arguments.Options.emplace_back(info.Name, text); });
  }
  AddLabelMap(app, arguments.Map, "--label-map",
    "The label map (.nii, .nrrd, .mha, .dcm, .tif, .vti ...) from which INPUT was extracted: its "
    "voxels "
    "are those of --keep-voxels and --smooth, and results are compared with it.");
}

void ApplyVoxelArguments(const VoxelArguments& arguments, vtkBoneDecimateAlgorithm* filter,
  std::vector<std::string>& warnings)
{
  for (const auto& [name, text] : arguments.Options)
  {
    filter->SetOptionFromText(name, text);
  }
  ApplyLabelMap(arguments.Map, filter, warnings);
}
}
