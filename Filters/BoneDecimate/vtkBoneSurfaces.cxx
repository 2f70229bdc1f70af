// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBoneSurfaces.h"

#include "FilterProgress.h"
#include "ImageLabels.h"
#include "LabelFieldOrder.h"
#include "LabelMapArrays.h"
#include "Labels/LabelMap/LabelSurfaces.h"
#include "Labels/LabelMap/SingleLabel.h"
#include "Labels/ModelGrid/ModelGridChoice.h"
#include "Pieces.h"
#include "RejectedValues.h"
#include "SurfaceArrays.h"
#include "SurfaceConversion.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

struct vtkBoneSurfaces::Internals
{
  std::vector<std::int64_t> Labels;
  std::string ModelGrid = "auto";
  std::string ModelGridFound;

  /// The labels to extract: those of the image, or of the map of the network. Sets the problem if
  /// that was requested and is not there.
  bonedecimate::ImageLabels Choose(bonedecimate::ImageLabels labels, int threads)
  {
    bonedecimate::ModelGridChoice choice = bonedecimate::ReadModelGridChoice(this->ModelGrid);
    if (!choice.Request)
    {
      return labels;
    }
    choice.Request->Threads = threads;
    bonedecimate::ModelLabels model = bonedecimate::FindModelLabels(labels, *choice.Request);
    if (!model.AreFound())
    {
      labels.Problem = choice.IsRequired() ? bonedecimate::NoModelGridReason : "";
      return labels;
    }
    this->ModelGridFound = model.Sentence;
    return std::move(model.Labels);
  }
};

vtkStandardNewMacro(vtkBoneSurfaces);

namespace
{
/// Labels that no voxel has: one that has voxels is closed, or open at the end of the image.
std::vector<std::int64_t> LabelsWithoutTriangles(const bonedecimate::LabelSurfaces& surfaces)
{
  const bonedecimate::LabelMapSource& source = surfaces.Source;
  std::vector<bool> isThere(source.Values.size(), false);
  if (source.OfTriangle.empty() && !surfaces.Surface.Triangles.empty()) // one label
  {
    isThere.front() = true;
  }
  for (const bonedecimate::BoundaryLabels& both : source.OfTriangle)
  {
    isThere[both[0]] = isThere[both[1]] = true;
  }
  std::vector<std::int64_t> labels;
  for (bonedecimate::Index i = 0; i < source.Background(); ++i)
  {
    if (!isThere[i])
    {
      labels.push_back(source.Values[i]);
    }
  }
  return labels;
}

/// Keeps an equal part of the triangles, which are in order of the layers of the image, and the
/// points they use.
void KeepPiece(const bonedecimate::PieceOfOutput& piece, bonedecimate::LabelSurfaces& surfaces)
{
  std::vector<bonedecimate::Triangle>& triangles = surfaces.Surface.Triangles;
  std::vector<bonedecimate::BoundaryLabels>& labels = surfaces.Source.OfTriangle;
  const auto at = [&](int number)
  {
    return static_cast<std::ptrdiff_t>(
      triangles.size() * static_cast<std::size_t>(number) / static_cast<std::size_t>(piece.Pieces));
  };
  const std::ptrdiff_t first = at(piece.Number);
  const std::ptrdiff_t end = at(piece.Number + 1);
  triangles = { triangles.begin() + first, triangles.begin() + end };
  labels = { labels.begin() + first, labels.begin() + end };
  std::vector<bonedecimate::Index> ids(surfaces.Surface.Points.size(), bonedecimate::None);
  for (const bonedecimate::Triangle& corners : triangles)
  {
    for (const bonedecimate::Index corner : corners)
    {
      ids[static_cast<std::size_t>(corner)] = 0;
    }
  }
  std::size_t kept = 0;
  for (std::size_t point = 0; point < ids.size(); ++point)
  {
    if (ids[point] != bonedecimate::None)
    {
      surfaces.Surface.Points[kept] = surfaces.Surface.Points[point];
      surfaces.Source.OfPoint[kept] = surfaces.Source.OfPoint[point];
      ids[point] = static_cast<bonedecimate::Index>(kept++);
    }
  }
  surfaces.Surface.Points.resize(kept);
  surfaces.Source.OfPoint.resize(kept);
  for (bonedecimate::Triangle& corners : triangles)
  {
    for (bonedecimate::Index& corner : corners)
    {
      corner = ids[static_cast<std::size_t>(corner)];
    }
  }
}

/// Gives the surface of a label the arrays of one: its triangles bound the label, and OtherLabel
/// has the label beyond each.
void DescribeSingleLabel(const bonedecimate::LabelMapSource& all,
  const std::vector<bonedecimate::Index>& triangles, std::int64_t label, vtkFieldData* fieldsOfAll,
  vtkPolyData* output)
{
  const std::int64_t background = all.Values.back();
  const std::int64_t outside = label != background ? background : background - 1;
  vtkNew<vtkTypeInt64Array> sides;
  sides->SetName(bonedecimate::BoundaryLabelsName);
  sides->SetNumberOfComponents(2);
  vtkNew<vtkTypeInt64Array> others;
  others->SetName(bonedecimate::OtherLabelName);
  for (const bonedecimate::Index triangle : triangles)
  {
    const auto [first, second] = all.OfTriangle[triangle];
    others->InsertNextValue(all.Values[all.Values[first] == label ? second : first]);
    sides->InsertNextValue(label);
    sides->InsertNextValue(outside);
  }
  output->GetCellData()->AddArray(sides);
  output->GetCellData()->AddArray(others);
  bonedecimate::LabelMapSource single;
  single.Values = { label, outside };
  bonedecimate::OrderLabelFields(fieldsOfAll, single, output->GetFieldData());
  vtkNew<vtkTypeInt64Array> values;
  values->SetName(bonedecimate::LabelValuesName);
  values->InsertNextValue(label);
  values->InsertNextValue(outside);
  output->GetFieldData()->AddArray(values);
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
  this->Rejected().SetOption(this, "NumberOfThreads", threads, this->NumberOfThreads);
}

void vtkBoneSurfaces::SetOutputPointsPrecision(int precision)
{
  this->Rejected().SetNumber(this, "OutputPointsPrecision",
    { SINGLE_PRECISION, DEFAULT_PRECISION, true, {} }, precision, this->OutputPointsPrecision);
}

void vtkBoneSurfaces::SetModelGrid(const std::string& choice)
{
  const std::string problem = bonedecimate::ReadModelGridChoice(choice).Problem;
  this->Rejected().Set(this, "ModelGrid", problem.empty() ? problem : "ModelGrid " + problem,
    choice, this->Internal->ModelGrid);
}

std::string vtkBoneSurfaces::GetModelGrid() const
{
  return this->Internal->ModelGrid;
}

std::string vtkBoneSurfaces::GetModelGridFound() const
{
  return this->IsOutdated() ? std::string() : this->Internal->ModelGridFound;
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
  bonedecimate::RequestWholeImage(inputVector[0]->GetInformationObject(0));
  return 1;
}

//------------------------------------------------------------------------------
int vtkBoneSurfaces::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->ReportRejectedValues())
  {
    return 0;
  }
  vtkImageData* image = vtkImageData::GetData(inputVector[0]);
  if (!bonedecimate::IsWholeImage(image, inputVector[0]->GetInformationObject(0)))
  {
    vtkErrorMacro(
      << "the image is one of several pieces; surfaces are extracted from whole images, "
         "so that labels do not end where pieces do");
    return 0;
  }
  return this->Extract(image, vtkPolyData::GetData(outputVector), outputVector) ? 1 : 0;
}

//------------------------------------------------------------------------------
bool vtkBoneSurfaces::Extract(
  vtkImageData* image, vtkPolyData* output, vtkInformationVector* outputVector)
{
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* array = this->GetInputArrayToProcess(0, image, association);
  array =
    array ? array : bonedecimate::OnlyArray(image, this->GetInputArrayInformation(0), association);
  bonedecimate::ImageLabels labels = bonedecimate::ReadImageLabels(image, array, association);
  this->Internal->ModelGridFound.clear();
  if (labels.Problem.empty())
  {
    labels = this->Internal->Choose(std::move(labels), this->NumberOfThreads);
  }
  if (!labels.Problem.empty())
  {
    vtkErrorMacro(<< labels.Problem);
    return false;
  }
  bonedecimate::FilterProgress progress(*this, "Extracting surfaces");
  bonedecimate::LabelSurfaces surfaces = bonedecimate::ExtractLabelSurfaces(labels.Image,
    { this->Internal->Labels, this->BackgroundLabel, this->Closed, this->NumberOfThreads },
    std::ref(progress));
  if (surfaces.Status == bonedecimate::LabelSurfaceStatus::Aborted)
  {
    return true;
  }
  if (surfaces.Status != bonedecimate::LabelSurfaceStatus::Good)
  {
    vtkErrorMacro(<< bonedecimate::LabelSurfaceMessage(surfaces.Status));
    return false;
  }
  if (!this->Internal->Labels.empty())
  {
    for (const std::int64_t label : LabelsWithoutTriangles(surfaces))
    {
      vtkWarningMacro(<< "no voxel has the label " << label);
    }
  }
  if (const bonedecimate::PieceOfOutput piece = bonedecimate::RequestedPiece(outputVector);
      piece.Pieces > 1)
  {
    KeepPiece(piece, surfaces);
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
  const auto hasWrongId = [](const bonedecimate::Triangle& corners)
  { return std::count(corners.begin(), corners.end(), bonedecimate::None) > 0; };
  const std::vector<bonedecimate::Triangle>& triangles = converted.Surface.Triangles;
  if (!read.Problem.empty() || read.Source.OfTriangle.empty() || index == values.end() ||
    std::any_of(triangles.begin(), triangles.end(), hasWrongId))
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
  DescribeSingleLabel(
    read.Source, single.OriginalTriangle, label, surfaces->GetFieldData(), output);
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
  os << indent << "ModelGrid: " << this->Internal->ModelGrid << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
