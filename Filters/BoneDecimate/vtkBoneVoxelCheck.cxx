// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBoneVoxelCheck.h"

#include "FilterProgress.h"
#include "ImageLabels.h"
#include "LabelMapArrays.h"
#include "Labels/LabelMap/EnclosedLabel.h"
#include "Labels/LabelMap/LabelRanks.h"
#include "Labels/LabelMap/VoxelCheck.h"
#include "Pieces.h"
#include "RejectedValues.h"
#include "Run/Input/LabelMapInput.h"
#include "Run/Report/Report.h"
#include "SurfaceConversion.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <vector>

struct vtkBoneVoxelCheck::Internals
{
  bonedecimate::VoxelChanges Changes;
  bool WasStopped = false;
  std::string ModelGridFound;
  bonedecimate::VoxelChanges ImageChanges; // besides those of the map of a network
  std::vector<std::int64_t> Values;
  std::vector<std::int64_t> LeftOut;

  bonedecimate::LabelChanges Of(int index) const
  {
    return index >= 0 && static_cast<std::size_t>(index) < this->Changes.OfLabel.size()
      ? this->Changes.OfLabel[static_cast<std::size_t>(index)]
      : bonedecimate::LabelChanges();
  }
};

namespace
{
std::vector<std::int64_t> ValuesWithout(
  const std::vector<std::int64_t>& values, const std::vector<std::int64_t>& others)
{
  std::vector<std::int64_t> rest;
  std::copy_if(values.begin(), values.end(), std::back_inserter(rest),
    [&others](std::int64_t value)
    { return std::find(others.begin(), others.end(), value) == others.end(); });
  return rest;
}
}

vtkStandardNewMacro(vtkBoneVoxelCheck);

vtkBoneVoxelCheck::vtkBoneVoxelCheck()
  : Internal(std::make_unique<Internals>())
{
  this->SetNumberOfInputPorts(2);
  this->SetInputArrayToProcess(
    0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS, vtkDataSetAttributes::SCALARS);
}

vtkBoneVoxelCheck::~vtkBoneVoxelCheck() = default;

//------------------------------------------------------------------------------
void vtkBoneVoxelCheck::SetNumberOfThreads(int threads)
{
  this->Rejected().SetOption(this, "NumberOfThreads", threads, this->NumberOfThreads);
}

//------------------------------------------------------------------------------
/// Before the first run, and after an update that did not get here, a run without figures.
const vtkBoneVoxelCheck::Internals& vtkBoneVoxelCheck::Last() const
{
  static const Internals none;
  return this->IsOutdated() ? none : *this->Internal;
}

vtkTypeInt64 vtkBoneVoxelCheck::GetNumberOfComparedVoxels() const
{
  return this->Last().Changes.Compared;
}

bool vtkBoneVoxelCheck::GetWasStopped() const
{
  return this->Last().WasStopped;
}

vtkTypeInt64 vtkBoneVoxelCheck::GetNumberOfChangedVoxels() const
{
  return this->Last().Changes.Changed;
}

std::string vtkBoneVoxelCheck::GetModelGridFound() const
{
  return this->Last().ModelGridFound;
}

vtkTypeInt64 vtkBoneVoxelCheck::GetNumberOfComparedImageVoxels() const
{
  return this->Last().ImageChanges.Compared;
}

vtkTypeInt64 vtkBoneVoxelCheck::GetNumberOfChangedImageVoxels() const
{
  return this->Last().ImageChanges.Changed;
}

void vtkBoneVoxelCheck::GetFirstChangedVoxel(int voxel[3]) const
{
  const std::array<std::int64_t, 3>& first = this->Last().Changes.FirstChanged;
  std::transform(
    first.begin(), first.end(), voxel, [](std::int64_t i) { return static_cast<int>(i); });
}

int vtkBoneVoxelCheck::GetNumberOfLabels() const
{
  return static_cast<int>(this->Last().Values.size());
}

vtkTypeInt64 vtkBoneVoxelCheck::GetLabelValue(int index) const
{
  return index >= 0 && index < this->GetNumberOfLabels()
    ? this->Last().Values[static_cast<std::size_t>(index)]
    : 0;
}

int vtkBoneVoxelCheck::GetNumberOfLabelsLeftOut() const
{
  return static_cast<int>(this->Last().LeftOut.size());
}

vtkTypeInt64 vtkBoneVoxelCheck::GetLabelLeftOut(int index) const
{
  return index >= 0 && index < this->GetNumberOfLabelsLeftOut()
    ? this->Last().LeftOut[static_cast<std::size_t>(index)]
    : 0;
}

vtkTypeInt64 vtkBoneVoxelCheck::GetNumberOfVoxels(int index) const
{
  return this->Last().Of(index).Voxels;
}

vtkTypeInt64 vtkBoneVoxelCheck::GetNumberOfLostVoxels(int index) const
{
  return this->Last().Of(index).Lost;
}

vtkTypeInt64 vtkBoneVoxelCheck::GetNumberOfGainedVoxels(int index) const
{
  return this->Last().Of(index).Gained;
}

//------------------------------------------------------------------------------
int vtkBoneVoxelCheck::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkBoneVoxelCheck::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* vtkNotUsed(outputVector))
{
  bonedecimate::RequestWholeImage(inputVector[1]->GetInformationObject(0));
  return 1;
}

//------------------------------------------------------------------------------
int vtkBoneVoxelCheck::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  *this->Internal = {};
  if (this->ReportRejectedValues())
  {
    return 0;
  }
  if (bonedecimate::RequestedPiece(outputVector).Pieces > 1)
  {
    vtkErrorMacro(<< "vtkBoneVoxelCheck is for one process alone: a part of a surface encloses "
                     "nothing; the report of vtkPBoneDecimate counts the voxels of all parts");
    return 0;
  }
  vtkPolyData* surface = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData::GetData(outputVector)->ShallowCopy(surface);
  const std::string problem = this->Compare(surface, vtkImageData::GetData(inputVector[1]));
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return 0;
  }
  return 1;
}

//------------------------------------------------------------------------------
/// Which of the labels has no effect on a surface with labels and this background, in one sentence.
std::string vtkBoneVoxelCheck::FindIneffective(vtkTypeInt64 background) const
{
  if (this->BackgroundLabel != 0 && this->BackgroundLabel != background)
  {
    return "BackgroundLabel is " + std::to_string(this->BackgroundLabel) +
      ", but the background of the surface, the last of LabelValues, is " +
      std::to_string(background);
  }
  return this->Label == this->BackgroundLabel ? std::string()
                                              : "Label has no effect on a surface with the array " +
      std::string(bonedecimate::BoundaryLabelsName);
}

//------------------------------------------------------------------------------
/// Gives the values of the labels to a source that has none. @returns One sentence if they are not
/// known, or if a label has no effect.
std::string vtkBoneVoxelCheck::ChooseLabel(
  const std::vector<std::int64_t>& inImage, bonedecimate::LabelMapSource& source) const
{
  if (!source.OfTriangle.empty())
  {
    return this->FindIneffective(source.Values.back());
  }
  const bonedecimate::EnclosedLabel enclosed =
    bonedecimate::FindEnclosedLabel(inImage, this->Label, this->BackgroundLabel);
  source.Values = { enclosed.Label, this->BackgroundLabel };
  return enclosed.Problem;
}

//------------------------------------------------------------------------------
/// What is wrong with the inputs, in one sentence.
std::string vtkBoneVoxelCheck::Compare(vtkPolyData* surface, vtkImageData* image)
{
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* array = this->GetInputArrayToProcess(0, image, association);
  array =
    array ? array : bonedecimate::OnlyArray(image, this->GetInputArrayInformation(0), association);
  const bonedecimate::ImageLabels ofImage =
    bonedecimate::ReadImageLabels(image, array, association);
  if (!ofImage.Problem.empty())
  {
    return ofImage.Problem;
  }
  const bonedecimate::ConvertedSurface converted =
    bonedecimate::ToSurface(surface, this->NumberOfThreads);
  bonedecimate::ReadLabelMap map = bonedecimate::ReadLabelMapArrays(surface, converted);
  if (!map.Problem.empty())
  {
    return map.Problem;
  }
  const bonedecimate::ModelLabels model = map.Source.Grid.Dimensions[0] > 0
    ? bonedecimate::FindLabelsOnGrid(ofImage, map.Source.Grid, this->NumberOfThreads)
    : bonedecimate::ModelLabels();
  const bonedecimate::ImageLabels& labels = model.AreFound() ? model.Labels : ofImage;
  bonedecimate::Report found;
  found.Status = bonedecimate::CheckForVoxels(
    converted.Surface, labels.Image.Grid, this->NumberOfThreads, found.Cleaning);
  if (found.Status != bonedecimate::InputStatus::Good)
  {
    return bonedecimate::InputMessage(found);
  }
  const std::vector<std::int64_t> inImage =
    bonedecimate::FindLabelValues(labels.Image, this->NumberOfThreads, {}).Values;
  const std::string problem = this->ChooseLabel(inImage, map.Source);
  if (!problem.empty())
  {
    return problem;
  }
  const std::vector<std::int64_t>& values = map.Source.Values;
  bonedecimate::FilterProgress progress(*this, "Comparing voxels");
  const auto compare = [&](const bonedecimate::LabelImage& reference)
  {
    const bonedecimate::VoxelCheckSettings settings = { reference.Grid,
      static_cast<bonedecimate::Index>(values.size()), this->NumberOfThreads };
    return bonedecimate::CompareVoxels(reference, values,
      { converted.Surface, map.Source.OfTriangle }, settings, std::ref(progress));
  };
  Internals counts;
  counts.Changes = compare(labels.Image);
  counts.ModelGridFound = model.Sentence;
  const bool hasTwo = !model.Sentence.empty() && counts.Changes.IsDone;
  counts.ImageChanges = hasTwo ? compare(ofImage.Image) : bonedecimate::VoxelChanges();
  counts.LeftOut = ValuesWithout(inImage, values);
  counts.Values = values;
  // Counts of a part of the voxels say nothing.
  const bool isDone = counts.Changes.IsDone && (!hasTwo || counts.ImageChanges.IsDone);
  *this->Internal = isDone ? std::move(counts) : Internals();
  this->Internal->WasStopped = !isDone;
  return {};
}

//------------------------------------------------------------------------------
void vtkBoneVoxelCheck::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Label: " << this->Label << "\n";
  os << indent << "BackgroundLabel: " << this->BackgroundLabel << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "NumberOfComparedVoxels: " << this->GetNumberOfComparedVoxels() << "\n";
  os << indent << "NumberOfChangedVoxels: " << this->GetNumberOfChangedVoxels() << "\n";
  os << indent << "ModelGridFound: " << this->GetModelGridFound() << "\n";
  os << indent << "NumberOfLabelsLeftOut: " << this->GetNumberOfLabelsLeftOut() << "\n";
}
