// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelCertificate.h"

#include "NumberText.h"
#include "Report/CountText.h"
#include "Runs/FilterRun.h"
#include "Terminal/Interruption.h"

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

VoxelCertificate::VoxelCertificate()
  : Check(vtkSmartPointer<vtkBoneVoxelCheck>::New())
{
}

VoxelCertificate::~VoxelCertificate() = default;

bool VoxelCertificate::Compare(vtkPolyData* surface, const std::string& file,
  const LabelMapFile& map, int threads, std::vector<std::string>& warnings)
{
  this->Check->SetInputData(0, surface);
  this->Check->SetInputData(1, ReadLabels(map.Path, warnings, map.GetSpacing()));
  this->Check->SetLabel(map.Label);
  this->Check->SetNumberOfThreads(threads);
  AcceptMessages(
    UpdateUntilInterrupted(this->Check, Progress::Hidden, "comparing"), file, warnings);
  const std::string leftOut = LeftOutText(this->Check);
  if (!leftOut.empty())
  {
    warnings.push_back(leftOut);
  }
  return !this->Check->GetWasStopped() && !IsInterrupted();
}

bool VoxelCertificate::IsViolated() const
{
  return this->Check->GetNumberOfChangedVoxels() > 0;
}

nlohmann::ordered_json VoxelCertificate::Json() const
{
  nlohmann::ordered_json voxels = { { "compared", this->Check->GetNumberOfComparedVoxels() },
    { "changed", this->Check->GetNumberOfChangedVoxels() } };
  if (const std::string model = this->Check->GetModelGridFound(); !model.empty())
  {
    voxels["model_grid"] = { { "sentence", model },
      { "compared_in_file", this->Check->GetNumberOfComparedImageVoxels() },
      { "changed_in_file", this->Check->GetNumberOfChangedImageVoxels() } };
  }
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
            << count(check->GetNumberOfComparedVoxels())
            << (check->GetNumberOfChangedVoxels() == 1 ? " has" : " have") << " another label";
  if (this->IsViolated())
  {
    int first[3];
    check->GetFirstChangedVoxel(first);
    std::cout << ", the first is " << first[0] << ", " << first[1] << ", " << first[2];
  }
  std::cout << "\n";
  if (!check->GetModelGridFound().empty())
  {
    std::cout << "model grid           " << check->GetModelGridFound() << ", "
              << count(check->GetNumberOfChangedImageVoxels()) << " of "
              << count(check->GetNumberOfComparedImageVoxels())
              << " voxels of the file have another label\n";
  }
  for (int i = 0; i < check->GetNumberOfLabels(); ++i)
  {
    std::string name = (i == check->GetNumberOfLabels() - 1 ? "" : "label ") + NameOf(check, i);
    name.resize(std::max<std::size_t>(name.size(), 20), ' ');
    std::cout << name << " " << CountText(check->GetNumberOfVoxels(i), "voxel") << ", "
              << count(check->GetNumberOfLostVoxels(i)) << " lost, "
              << count(check->GetNumberOfGainedVoxels(i)) << " gained\n";
  }
}
}
