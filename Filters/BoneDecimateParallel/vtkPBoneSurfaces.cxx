// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPBoneSurfaces.h"

#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

vtkStandardNewMacro(vtkPBoneSurfaces);
vtkCxxSetObjectMacro(vtkPBoneSurfaces, Controller, vtkMultiProcessController);

namespace
{
using Extent = std::array<int, 6>;

/// The extent that encloses all pieces.
Extent UnionOf(const std::vector<vtkImageData*>& pieces)
{
  Extent all;
  std::copy_n(pieces.front()->GetExtent(), 6, all.begin());
  for (vtkImageData* piece : pieces)
  {
    for (std::size_t k = 0; k < 6; k += 2)
    {
      all[k] = std::min(all[k], piece->GetExtent()[k]);
      all[k + 1] = std::max(all[k + 1], piece->GetExtent()[k + 1]);
    }
  }
  return all;
}

/// Origin, spacing and direction. They do not survive the way to another process bit for bit.
std::vector<double> GridOf(vtkImageData* image)
{
  std::vector<double> values(image->GetOrigin(), image->GetOrigin() + 3);
  values.insert(values.end(), image->GetSpacing(), image->GetSpacing() + 3);
  const double* direction = image->GetDirectionMatrix()->GetData();
  values.insert(values.end(), direction, direction + 9);
  return values;
}

bool HasCells(vtkImageData* image)
{
  return image->GetPointData()->GetNumberOfArrays() == 0;
}

vtkDataArray* LabelsOf(vtkImageData* image)
{
  return HasCells(image) ? image->GetCellData()->GetArray(0) : image->GetPointData()->GetArray(0);
}

/// The image with one array, which becomes its scalars. Empty if there is none.
vtkSmartPointer<vtkImageData> WithLabelsAlone(
  vtkImageData* image, vtkDataArray* labels, bool ofCells)
{
  auto result = vtkSmartPointer<vtkImageData>::New();
  if (labels && labels->GetNumberOfTuples() > 0)
  {
    result->CopyStructure(image);
    result->GetFieldData()->ShallowCopy(image->GetFieldData());
    vtkDataSetAttributes* data =
      ofCells ? static_cast<vtkDataSetAttributes*>(result->GetCellData()) : result->GetPointData();
    data->SetScalars(labels);
  }
  return result;
}

/// Copies the labels of a piece to where they belong, and marks these voxels.
void CopyLabels(vtkImageData* piece, vtkImageData* whole, std::vector<char>& isKnown)
{
  const bool ofCells = HasCells(whole);
  const int last = ofCells ? 1 : 0;
  const int* extent = piece->GetExtent();
  vtkDataArray* from = LabelsOf(piece);
  vtkDataArray* to = LabelsOf(whole);
  int at[3];
  for (at[2] = extent[4]; at[2] <= extent[5] - last; ++at[2])
  {
    for (at[1] = extent[2]; at[1] <= extent[3] - last; ++at[1])
    {
      for (at[0] = extent[0]; at[0] <= extent[1] - last; ++at[0])
      {
        const vtkIdType id = ofCells ? whole->ComputeCellId(at) : whole->ComputePointId(at);
        to->SetTuple(id, ofCells ? piece->ComputeCellId(at) : piece->ComputePointId(at), from);
        isKnown[static_cast<std::size_t>(id)] = 1;
      }
    }
  }
}

/// Null if the pieces do not belong together, or are not all there.
vtkSmartPointer<vtkImageData> Assembled(
  const std::vector<vtkSmartPointer<vtkDataObject>>& received, const std::vector<double>& grid)
{
  std::vector<vtkImageData*> pieces;
  for (vtkDataObject* one : received)
  {
    vtkImageData* piece = vtkImageData::SafeDownCast(one);
    if (piece && LabelsOf(piece))
    {
      pieces.push_back(piece);
    }
  }
  const auto fits = [&pieces](vtkImageData* piece)
  {
    return HasCells(piece) == HasCells(pieces.front()) &&
      LabelsOf(piece)->GetDataType() == LabelsOf(pieces.front())->GetDataType() &&
      LabelsOf(piece)->GetNumberOfComponents() == 1;
  };
  if (pieces.empty() || !std::all_of(pieces.begin(), pieces.end(), fits))
  {
    return nullptr;
  }
  const auto labels = vtkSmartPointer<vtkDataArray>::Take(LabelsOf(pieces.front())->NewInstance());
  vtkNew<vtkImageData> structure;
  structure->SetOrigin(grid.data());
  structure->SetSpacing(grid.data() + 3);
  structure->SetDirectionMatrix(grid.data() + 6);
  structure->SetExtent(UnionOf(pieces).data());
  structure->GetFieldData()->ShallowCopy(pieces.front()->GetFieldData());
  const bool ofCells = HasCells(pieces.front());
  labels->SetName(LabelsOf(pieces.front())->GetName());
  labels->SetNumberOfTuples(
    ofCells ? structure->GetNumberOfCells() : structure->GetNumberOfPoints());
  const vtkSmartPointer<vtkImageData> whole = WithLabelsAlone(structure, labels, ofCells);
  std::vector<char> isKnown(static_cast<std::size_t>(labels->GetNumberOfTuples()), 0);
  for (vtkImageData* piece : pieces)
  {
    CopyLabels(piece, whole, isKnown);
  }
  const bool isComplete = std::find(isKnown.begin(), isKnown.end(), 0) == isKnown.end();
  return isComplete ? whole : vtkSmartPointer<vtkImageData>();
}
}

vtkPBoneSurfaces::vtkPBoneSurfaces()
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkPBoneSurfaces::~vtkPBoneSurfaces()
{
  this->SetController(nullptr);
}

vtkMultiProcessController* vtkPBoneSurfaces::GetController()
{
  return this->Controller;
}

//------------------------------------------------------------------------------
/// Whether all processes that have some of the values have the same.
bool vtkPBoneSurfaces::IsCommon(std::vector<double>& values, bool areThere)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  const std::vector<double> nothing(values.size(), none);
  const std::vector<double> low = areThere ? values : nothing;
  std::vector<double> high = low;
  std::transform(low.begin(), low.end(), high.begin(),
    [areThere](double value) { return areThere ? value : -none; });
  const auto count = static_cast<vtkIdType>(values.size());
  std::vector<double> most = high;
  this->Controller->AllReduce(low.data(), values.data(), count, vtkCommunicator::MIN_OP);
  this->Controller->AllReduce(high.data(), most.data(), count, vtkCommunicator::MAX_OP);
  return values == most;
}

//------------------------------------------------------------------------------
int vtkPBoneSurfaces::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* image = vtkImageData::GetData(inputVector[0]);
  std::vector<double> grid = GridOf(image);
  std::vector<double> extent(image->GetExtent(), image->GetExtent() + 6);
  const bool hasProcesses = this->Controller && this->Controller->GetNumberOfProcesses() > 1;
  const bool isOneGrid = !hasProcesses || this->IsCommon(grid, image->GetNumberOfPoints() > 0);
  if (!hasProcesses || (this->IsCommon(extent, true) && isOneGrid))
  {
    return this->Superclass::RequestData(request, inputVector, outputVector);
  }
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* labels = this->GetInputArrayToProcess(0, image, association);
  const auto own =
    WithLabelsAlone(image, labels, association == vtkDataObject::FIELD_ASSOCIATION_CELLS);
  std::vector<vtkSmartPointer<vtkDataObject>> received;
  this->Controller->AllGather(own, received);
  const vtkSmartPointer<vtkImageData> whole =
    isOneGrid ? Assembled(received, grid) : vtkSmartPointer<vtkImageData>();
  if (!whole)
  {
    vtkErrorMacro(<< "the images of the processes are not the pieces of one image of labels: they "
                     "differ in origin, spacing, direction or type, or leave voxels out");
    return 0;
  }
  vtkNew<vtkInformation> information;
  information->Set(vtkDataObject::DATA_OBJECT(), whole);
  information->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole->GetExtent(), 6);
  vtkNew<vtkInformationVector> assembled;
  assembled->Append(information);
  vtkInformationVector* inputs[] = { assembled };
  return this->Superclass::RequestData(request, inputs, outputVector);
}

//------------------------------------------------------------------------------
void vtkPBoneSurfaces::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
}
