// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelCertificate.h"

#include "CommonOptions.h"
#include "FileNames.h"
#include "FilterRun.h"
#include "Formats/FileChecks.h"
#include "LabelVolume.h"
#include "NumberText.h"

#include "vtkBoneVoxelCheck.h"
#include "vtkImageData.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

namespace bonedecimate
{
namespace
{
using Json = nlohmann::ordered_json;

const NumberRange LabelRange = { -9007199254740992.0, 9007199254740992.0, true, "" };

std::string NameOf(vtkBoneVoxelCheck* check, int label)
{
  return label == check->GetNumberOfLabels() - 1 ? "background"
                                                 : std::to_string(check->GetLabelValue(label));
}

/// In one sentence; empty if the surface has all labels of the map.
std::string LeftOutText(vtkBoneVoxelCheck* check)
{
  std::string labels;
  for (int i = 0; i < check->GetNumberOfLabelsLeftOut(); ++i)
  {
    labels += (i > 0 ? ", " : "") + std::to_string(check->GetLabelLeftOut(i));
  }
  return labels.empty()
    ? labels
    : "labels of the map that the surface does not have count as background: " + labels;
}
}

void AddLabel(CLI::App& app, std::optional<double>& label)
{
  AddNumber(app,
    { "--label", "N", LabelRange,
      "The label of the label map that a surface without the array BoundaryLabels encloses; "
      "default "
      "the only one that is not 0." },
    [&label](double value) { label = value; });
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

VoxelCertificate::VoxelCertificate()
  : Check(vtkSmartPointer<vtkBoneVoxelCheck>::New())
{
}

VoxelCertificate::~VoxelCertificate() = default;

void VoxelCertificate::Compare(vtkPolyData* surface, const std::string& file,
  const VoxelRequest& request, int threads, std::vector<std::string>& warnings)
{
  this->Check->SetInputData(0, surface);
  this->Check->SetInputData(1, ReadLabels(request.Map, warnings));
  this->Check->SetLabel(static_cast<vtkTypeInt64>(request.Label.value_or(0.0)));
  this->Check->SetNumberOfThreads(threads);
  AcceptMessages(UpdateFilter(this->Check, Progress::Hidden), file, warnings);
  const std::string leftOut = LeftOutText(this->Check);
  if (!leftOut.empty())
  {
    warnings.push_back(leftOut);
  }
}

bool VoxelCertificate::IsViolated() const
{
  return this->Check->GetNumberOfChangedVoxels() > 0;
}

nlohmann::ordered_json VoxelCertificate::Json() const
{
  nlohmann::ordered_json voxels = { { "compared", this->Check->GetNumberOfComparedVoxels() },
    { "changed", this->Check->GetNumberOfChangedVoxels() } };
  if (this->IsViolated())
  {
    int first[3];
    this->Check->GetFirstChangedVoxel(first);
    voxels["first_changed"] = { first[0], first[1], first[2] };
  }
  for (int i = 0; i < this->Check->GetNumberOfLabels(); ++i)
  {
    voxels["of_" + std::to_string(this->Check->GetLabelValue(i))] = {
      { "voxels", this->Check->GetNumberOfVoxels(i) },
      { "lost", this->Check->GetNumberOfLostVoxels(i) },
      { "gained", this->Check->GetNumberOfGainedVoxels(i) }
    };
  }
  return voxels;
}

void VoxelCertificate::Print() const
{
  vtkBoneVoxelCheck* check = this->Check;
  const auto count = [](vtkTypeInt64 number) { return GroupedText(static_cast<double>(number)); };
  std::cout << "voxels               " << count(check->GetNumberOfChangedVoxels()) << " of "
            << count(check->GetNumberOfComparedVoxels()) << " have another label";
  if (this->IsViolated())
  {
    int first[3];
    check->GetFirstChangedVoxel(first);
    std::cout << ", the first is " << first[0] << ", " << first[1] << ", " << first[2];
  }
  std::cout << "\n";
  for (int i = 0; i < check->GetNumberOfLabels(); ++i)
  {
    std::string name = (i == check->GetNumberOfLabels() - 1 ? "" : "label ") + NameOf(check, i);
    name.resize(std::max<std::size_t>(name.size(), 20), ' ');
    std::cout << name << " " << count(check->GetNumberOfVoxels(i)) << " voxels, "
              << count(check->GetNumberOfLostVoxels(i)) << " lost, "
              << count(check->GetNumberOfGainedVoxels(i)) << " gained\n";
  }
}
}
