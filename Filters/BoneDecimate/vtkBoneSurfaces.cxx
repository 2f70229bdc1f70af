// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBoneSurfaces.h"

#include "FilterProgress.h"
#include "ImageLabels.h"
#include "LabelMap/LabelSurfaces.h"
#include "LabelMap/SingleLabel.h"
#include "LabelMapArrays.h"
#include "RejectedValues.h"
#include "SurfaceArrays.h"
#include "SurfaceConversion.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <vector>

struct vtkBoneSurfaces::Internals
{
  std::vector<std::int64_t> Labels;
  bonedecimate::RejectedValues Rejected;
};

vtkStandardNewMacro(vtkBoneSurfaces);

namespace
{
constexpr std::size_t UnusualNumberOfLabels = 1000;

/// The first piece is the whole output, so that several processes do not repeat it.
bool IsFirstPiece(vtkInformationVector* outputVector)
{
  vtkInformation* output = outputVector->GetInformationObject(0);
  vtkInformationIntegerKey* piece = vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER();
  return !output->Has(piece) || output->Get(piece) == 0;
}

/// Copies the values of the original points or cells.
void CopyAttributes(vtkDataSetAttributes* from, const std::vector<bonedecimate::Index>& originals,
  const std::vector<vtkIdType>* idOfOriginal, vtkDataSetAttributes* to)
{
  to->CopyAllOn();
  to->CopyAllocate(from, static_cast<vtkIdType>(originals.size()));
  for (std::size_t i = 0; i < originals.size(); ++i)
  {
    const auto original = static_cast<std::size_t>(originals[i]);
    to->CopyData(
      from, idOfOriginal ? (*idOfOriginal)[original] : originals[i], static_cast<vtkIdType>(i));
  }
}
}

vtkBoneSurfaces::vtkBoneSurfaces()
  : Internal(std::make_unique<Internals>())
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS, vtkDataSetAttributes::SCALARS);
}

vtkBoneSurfaces::~vtkBoneSurfaces() = default;

//------------------------------------------------------------------------------
void vtkBoneSurfaces::AddLabel(vtkTypeInt64 label)
{
  this->Internal->Labels.push_back(label);
  this->Modified();
}

void vtkBoneSurfaces::RemoveAllLabels()
{
  if (!this->Internal->Labels.empty())
  {
    this->Internal->Labels.clear();
    this->Modified();
  }
}

int vtkBoneSurfaces::GetNumberOfLabels() const
{
  return static_cast<int>(this->Internal->Labels.size());
}

vtkTypeInt64 vtkBoneSurfaces::GetLabel(int index) const
{
  return index >= 0 && index < this->GetNumberOfLabels()
    ? this->Internal->Labels[static_cast<std::size_t>(index)]
    : 0;
}

//------------------------------------------------------------------------------
void vtkBoneSurfaces::SetNumberOfThreads(int threads)
{
  this->Internal->Rejected.SetOption(this, "NumberOfThreads", threads, this->NumberOfThreads);
}

void vtkBoneSurfaces::SetOutputPointsPrecision(int precision)
{
  this->Internal->Rejected.SetNumber(this, "OutputPointsPrecision",
    { SINGLE_PRECISION, DEFAULT_PRECISION, true, {} }, precision, this->OutputPointsPrecision);
}

std::string vtkBoneSurfaces::GetRejectedValue(const std::string& property) const
{
  return this->Internal->Rejected.Of(property);
}

vtkMTimeType vtkBoneSurfaces::GetMTime()
{
  return this->Internal->Rejected.MTime(this->Superclass::GetMTime());
}

//------------------------------------------------------------------------------
int vtkBoneSurfaces::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkBoneSurfaces::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* vtkNotUsed(outputVector))
{
  vtkInformation* input = inputVector[0]->GetInformationObject(0);
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  input->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent, 6);
  return 1;
}

//------------------------------------------------------------------------------
int vtkBoneSurfaces::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->Internal->Rejected.Report(this))
  {
    return 0;
  }
  return !IsFirstPiece(outputVector) ||
    this->Extract(vtkImageData::GetData(inputVector[0]), vtkPolyData::GetData(outputVector));
}

//------------------------------------------------------------------------------
bool vtkBoneSurfaces::Extract(vtkImageData* image, vtkPolyData* output)
{
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* array = this->GetInputArrayToProcess(0, image, association);
  const bonedecimate::ImageLabels labels = bonedecimate::ReadImageLabels(image, array, association);
  if (!labels.Problem.empty())
  {
    vtkErrorMacro(<< labels.Problem);
    return false;
  }
  const bonedecimate::LabelSurfaces surfaces = bonedecimate::ExtractLabelSurfaces(labels.Image,
    { this->Internal->Labels, this->BackgroundLabel, this->Closed, this->NumberOfThreads },
    [this](double fraction) { return bonedecimate::GoesOn(*this, fraction); });
  if (surfaces.Status == bonedecimate::LabelSurfaceStatus::Aborted)
  {
    return true;
  }
  if (surfaces.Status != bonedecimate::LabelSurfaceStatus::Good)
  {
    vtkErrorMacro(<< bonedecimate::LabelSurfaceMessage(surfaces.Status));
    return false;
  }
  if (this->Internal->Labels.empty() && surfaces.Source.Values.size() > UnusualNumberOfLabels)
  {
    vtkWarningMacro(<< "the image has " << surfaces.Source.Values.size()
                    << " different values; gray values have to be segmented first");
  }
  const bool isSingle = this->OutputPointsPrecision != DOUBLE_PRECISION;
  output->SetPoints(
    bonedecimate::ToPoints(surfaces.Surface.Points, isSingle, this->NumberOfThreads));
  output->SetPolys(bonedecimate::ToCells(surfaces.Surface.Triangles, this->NumberOfThreads));
  bonedecimate::AddLabelMapArrays(surfaces.Source, this->NumberOfThreads, output);
  bonedecimate::OrderLabelFields(image->GetFieldData(), surfaces.Source, output->GetFieldData());
  return true;
}

//------------------------------------------------------------------------------
bool vtkBoneSurfaces::ExtractLabel(vtkPolyData* surfaces, vtkTypeInt64 label, vtkPolyData* output)
{
  output->Initialize();
  const bonedecimate::ConvertedSurface converted = bonedecimate::ToSurface(surfaces, 0);
  const bonedecimate::ReadLabelMap read = bonedecimate::ReadLabelMapArrays(surfaces, converted);
  const std::vector<std::int64_t>& values = read.Source.Values;
  const auto index = std::find(values.begin(), values.end(), label);
  if (!read.Problem.empty() || read.Source.OfTriangle.empty() || index == values.end())
  {
    return false;
  }
  const bonedecimate::SingleLabelSurface single = bonedecimate::ExtractLabel(converted.Surface,
    read.Source.OfTriangle, static_cast<bonedecimate::Index>(index - values.begin()));
  output->SetPoints(bonedecimate::ToPoints(single.Surface.Points, converted.IsSingle, 0));
  output->SetPolys(bonedecimate::ToCells(single.Surface.Triangles, 0));
  output->GetFieldData()->PassData(surfaces->GetFieldData());
  CopyAttributes(surfaces->GetPointData(), single.OriginalPoint, nullptr, output->GetPointData());
  CopyAttributes(surfaces->GetCellData(), single.OriginalTriangle, &converted.CellOfTriangle,
    output->GetCellData());
  return !single.Surface.Triangles.empty();
}

//------------------------------------------------------------------------------
void vtkBoneSurfaces::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Labels:";
  for (const std::int64_t label : this->Internal->Labels)
  {
    os << " " << label;
  }
  os << (this->Internal->Labels.empty() ? " all\n" : "\n");
  os << indent << "BackgroundLabel: " << this->BackgroundLabel << "\n";
  os << indent << "Closed: " << (this->Closed ? "on" : "off") << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
