// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelMapArguments.h"

#include "Arguments.h"
#include "CommonOptions.h"
#include "ExitCode.h"
#include "Formats/FileChecks.h"
#include "LabelVolume.h"

#include "vtkBoneDecimateAlgorithm.h"

#include <CLI/CLI.hpp>

namespace bonedecimate
{
namespace
{
const NumberRange LabelRange = { -9007199254740992.0, 9007199254740992.0, true, "" };
}

void AddLabelMap(CLI::App& app, LabelMapFile& map, const char* flags, const char* help)
{
  AddFile(app, flags, map.Path, help);
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
}

void CheckLabel(const LabelMapFile& map, const std::string& flag)
{
  if (map.Label != 0 && map.Path.empty())
  {
    throw Failure(ExitCode::Usage, "--label has no effect; it needs " + flag + " FILE");
  }
}

vtkSmartPointer<vtkImageData> ReadLabels(
  const std::string& path, std::vector<std::string>& warnings)
{
  const LabelVolume labels = ReadLabelVolume(path);
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
    filter->SetLabelMapData(ReadLabels(map.Path, warnings));
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
    "The label map (.vti, .mha, .mhd, .nrrd, .nhdr) from which INPUT was extracted: its voxels are "
    "those of --keep-voxels and --smooth, and results are compared with it.");
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
