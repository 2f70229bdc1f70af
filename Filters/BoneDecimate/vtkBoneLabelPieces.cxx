// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBoneLabelPieces.h"

#include "ImageLabels.h"
#include "Labels/LabelMap/ChangePieces.h"
#include "Labels/LabelMap/LabelSurfaces.h"
#include "RejectedValues.h"
#include "vtkBoneAlgorithm.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <algorithm>
#include <vector>

namespace
{
using bonedecimate::SegmentPieces;

SegmentPieces PiecesOf(const std::vector<SegmentPieces>& all, std::int64_t label)
{
  const auto found = std::find_if(
    all.begin(), all.end(), [label](const SegmentPieces& one) { return one.Label == label; });
  return found == all.end() ? SegmentPieces() : *found;
}
}

struct vtkBoneLabelPieces::Internals
{
  std::vector<std::int64_t> Labels;
  bonedecimate::PieceCounts Counts;
  bonedecimate::RejectedValues Rejected;

  void SetLimit(vtkBoneLabelPieces* filter, const char* property, double value, double& member)
  {
    this->Rejected.SetNumber(
      filter, property, { 0.0, bonedecimate::MaxNumber, false, {} }, value, member);
  }
};

namespace
{
/// Why nothing was changed.
std::string ReasonOf(const bonedecimate::PieceCounts& counts)
{
  return counts.HoldsBackground
    ? bonedecimate::LabelSurfaceMessage(bonedecimate::LabelSurfaceStatus::LabelOutOfRange)
    : "the labels are of a type that does not hold BackgroundLabel";
}
}

vtkStandardNewMacro(vtkBoneLabelPieces);

vtkBoneLabelPieces::vtkBoneLabelPieces()
  : Internal(std::make_unique<Internals>())
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS, vtkDataSetAttributes::SCALARS);
}

vtkBoneLabelPieces::~vtkBoneLabelPieces() = default;

//------------------------------------------------------------------------------
void vtkBoneLabelPieces::AddLabel(vtkTypeInt64 label)
{
  this->Internal->Labels.push_back(label);
  this->Modified();
}

void vtkBoneLabelPieces::RemoveAllLabels()
{
  if (!this->Internal->Labels.empty())
  {
    this->Internal->Labels.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkBoneLabelPieces::SetIslandSize(double size)
{
  this->Internal->SetLimit(this, "IslandSize", size, this->IslandSize);
}

void vtkBoneLabelPieces::SetIslandArea(double area)
{
  this->Internal->SetLimit(this, "IslandArea", area, this->IslandArea);
}

void vtkBoneLabelPieces::SetIslandVolume(double volume)
{
  this->Internal->SetLimit(this, "IslandVolume", volume, this->IslandVolume);
}

void vtkBoneLabelPieces::SetCavityVolume(double volume)
{
  this->Internal->SetLimit(this, "CavityVolume", volume, this->CavityVolume);
}

std::string vtkBoneLabelPieces::GetRejectedValue(const std::string& property) const
{
  return this->Internal->Rejected.Of(property);
}

vtkMTimeType vtkBoneLabelPieces::GetMTime()
{
  return this->Internal->Rejected.MTime(this->Superclass::GetMTime());
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkBoneLabelPieces::GetNumberOfIslands(vtkTypeInt64 label) const
{
  return PiecesOf(this->Internal->Counts.Islands, label).Pieces;
}

vtkTypeInt64 vtkBoneLabelPieces::GetNumberOfIslandVoxels(vtkTypeInt64 label) const
{
  return PiecesOf(this->Internal->Counts.Islands, label).Voxels;
}

double vtkBoneLabelPieces::GetVolumeOfIslands(vtkTypeInt64 label) const
{
  return PiecesOf(this->Internal->Counts.Islands, label).Volume;
}

vtkTypeInt64 vtkBoneLabelPieces::GetNumberOfCavities(vtkTypeInt64 label) const
{
  return PiecesOf(this->Internal->Counts.Cavities, label).Pieces;
}

vtkTypeInt64 vtkBoneLabelPieces::GetNumberOfCavityVoxels(vtkTypeInt64 label) const
{
  return PiecesOf(this->Internal->Counts.Cavities, label).Voxels;
}

double vtkBoneLabelPieces::GetVolumeOfCavities(vtkTypeInt64 label) const
{
  return PiecesOf(this->Internal->Counts.Cavities, label).Volume;
}

bool vtkBoneLabelPieces::IsLargestPieceTooSmall(vtkTypeInt64 label) const
{
  return PiecesOf(this->Internal->Counts.Islands, label).IsLargestTooSmall;
}

//------------------------------------------------------------------------------
int vtkBoneLabelPieces::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* vtkNotUsed(outputVector))
{
  return 1; // the superclass warns of arrays that may be of points or of cells
}

//------------------------------------------------------------------------------
int vtkBoneLabelPieces::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* vtkNotUsed(outputVector))
{
  bonedecimate::RequestWholeImage(inputVector[0]->GetInformationObject(0));
  return 1;
}

//------------------------------------------------------------------------------
int vtkBoneLabelPieces::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  Internals& internal = *this->Internal;
  internal.Counts = {};
  this->ErrorCode = vtkBoneAlgorithm::REJECTED_RUN;
  vtkImageData* image = vtkImageData::GetData(inputVector[0]);
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* array = this->GetInputArrayToProcess(0, image, association);
  array =
    array ? array : bonedecimate::OnlyArray(image, this->GetInputArrayInformation(0), association);
  const bonedecimate::ImageLabels labels = bonedecimate::ReadImageLabels(image, array, association);
  if (internal.Rejected.Report(this))
  {
    this->ErrorCode = vtkBoneAlgorithm::REJECTED_VALUE;
    return 0;
  }
  if (!labels.Problem.empty() ||
    !bonedecimate::IsWholeImage(image, inputVector[0]->GetInformationObject(0)))
  {
    vtkErrorMacro(
      << (labels.Problem.empty()
             ? "the image is one of several pieces; islands and cavities are those of whole images"
             : labels.Problem));
    return 0;
  }
  const auto changed = vtkSmartPointer<vtkDataArray>::Take(labels.Array->NewInstance());
  changed->DeepCopy(labels.Array);
  changed->SetName(array->GetName());
  internal.Counts = bonedecimate::ChangePieces(
    { internal.Labels, this->BackgroundLabel,
      { this->IslandSize, this->IslandArea, this->IslandVolume }, this->CavityVolume },
    changed->GetVoidPointer(0), labels.Image.Type, labels.Image.Grid);
  if (!internal.Counts.HoldsBackground || !internal.Counts.FitInt64)
  {
    vtkErrorMacro(<< ReasonOf(internal.Counts));
    return 0;
  }
  vtkImageData* output = vtkImageData::GetData(outputVector);
  output->ShallowCopy(image);
  vtkDataSetAttributes* attributes = output->GetAttributes(
    association == vtkDataObject::FIELD_ASSOCIATION_CELLS ? vtkDataObject::CELL
                                                          : vtkDataObject::POINT);
  if (changed->GetName() == nullptr)
  {
    attributes->SetScalars(changed); // in place of the labels
  }
  else
  {
    attributes->AddArray(changed); // beside what was active, a CT
    attributes->SetActiveScalars(changed->GetName());
  }
  this->ErrorCode = 0;
  return 1;
}

//------------------------------------------------------------------------------
void vtkBoneLabelPieces::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Labels:";
  for (const std::int64_t label : this->Internal->Labels)
  {
    os << " " << label;
  }
  os << (this->Internal->Labels.empty() ? " all\n" : "\n");
  os << indent << "BackgroundLabel: " << this->BackgroundLabel << "\n";
  os << indent << "IslandSize: " << this->IslandSize << "\n";
  os << indent << "IslandArea: " << this->IslandArea << "\n";
  os << indent << "IslandVolume: " << this->IslandVolume << "\n";
  os << indent << "CavityVolume: " << this->CavityVolume << "\n";
}
