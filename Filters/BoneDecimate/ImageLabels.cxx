// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageLabels.h"

#include "LabelMapArrays.h"
#include "Labels/ModelGrid/ModelGridChoice.h"
#include "NamedArrays.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <type_traits>

namespace bonedecimate
{
namespace
{
constexpr double LargestOffset = 0.01; // voxels

/// The voxels are the points of the image, or its cells.
VoxelGrid GridOf(vtkImageData* image, bool ofCells)
{
  VoxelGrid grid;
  const int* extent = image->GetExtent();
  const double shift = ofCells ? 0.5 : 0.0;
  Vector3 first;
  for (int axis = 0; axis < 3; ++axis)
  {
    first[axis] = extent[2 * axis] + shift;
    grid.Dimensions[static_cast<std::size_t>(axis)] =
      extent[2 * axis + 1] - extent[2 * axis] + (ofCells ? 0 : 1);
    for (int k = 0; k < 3; ++k)
    {
      grid.Direction(axis, k) = image->GetDirectionMatrix()->GetElement(axis, k);
    }
  }
  grid.Spacing = Vector3(image->GetSpacing());
  grid.Origin = Vector3(image->GetOrigin());
  grid.Origin = grid.ToMillimeters(first);
  return grid;
}

/// Gives the grid the layers of the image, if it has positions of them.
/// @return One sentence; empty if they are positions.
std::string ReadLayers(vtkImageData* image, bool ofCells, VoxelGrid& grid)
{
  vtkDataArray* const layers = image->GetFieldData()->GetArray(GridLayersName);
  if (!layers)
  {
    return {};
  }
  const std::string name = std::string("the field array ") + GridLayersName;
  if (ofCells)
  {
    return name + " has positions of points, and the labels are those of cells";
  }
  if (layers->GetNumberOfComponents() != 1 || layers->GetNumberOfTuples() != grid.Dimensions[2])
  {
    return name + " does not have one position for each layer of the image";
  }
  double least = MaxCoordinate;
  for (vtkIdType k = 0; k < layers->GetNumberOfTuples(); ++k)
  {
    const double distance = k > 0 ? layers->GetComponent(k, 0) - grid.Layers.back() : MaxCoordinate;
    least = distance < least || std::isnan(distance) ? distance : least;
    grid.Layers.push_back(layers->GetComponent(k, 0));
  }
  grid.Spacing[2] = grid.Layers.size() > 1 ? least : grid.Spacing[2];
  return least > 0.0 && grid.Layers[0] == 0.0 && grid.Layers.back() <= MaxCoordinate
    ? std::string()
    : name + " does not ascend from 0";
}

/// Whether each number is one of the labels that doubles hold exactly; if not, which is the first.
vtkIdType FirstThatIsNoLabel(vtkDataArray* array)
{
  constexpr double largest = 9007199254740992.0;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    const double value = array->GetComponent(i, 0);
    if (!(std::abs(value) <= largest) || std::floor(value) != value)
    {
      return i;
    }
  }
  return -1;
}

/// In one block of memory, of integers.
vtkSmartPointer<vtkDataArray> AsIntegers(vtkDataArray* array)
{
  const int type = array->GetDataType();
  const bool isReal = type == VTK_FLOAT || type == VTK_DOUBLE;
  if (array->HasStandardMemoryLayout() && type != VTK_BIT && !isReal)
  {
    return array;
  }
  const auto copy = vtkSmartPointer<vtkDataArray>::Take(
    vtkDataArray::CreateDataArray(type == VTK_BIT ? VTK_UNSIGNED_CHAR
        : isReal                                  ? VTK_TYPE_INT64
                                                  : type));
  copy->DeepCopy(array);
  return copy;
}

template <typename Scalar>
LabelImage ImageOf(const Scalar* labels, const VoxelGrid& grid)
{
  if constexpr (std::is_integral_v<Scalar>)
  {
    return MakeLabelImage(labels, grid);
  }
  else
  {
    return {};
  }
}

std::string ProblemOf(vtkImageData* image, vtkDataArray* array, vtkIdType voxels)
{
  if (!array)
  {
    return "the image has no labels: neither active scalars nor the array that was chosen (of "
           "points "
           "there are: " +
      ListOfArrays(image->GetPointData()) + "; of cells: " + ListOfArrays(image->GetCellData()) +
      ")";
  }
  const std::string name = array->GetName() ? array->GetName() : "without a name";
  if (array->GetNumberOfComponents() != 1)
  {
    return "the array " + name + " has several components; labels have one";
  }
  if (array->GetNumberOfTuples() != voxels)
  {
    return "the array " + name + " does not have one label for each voxel";
  }
  const bool isReal = array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
  const vtkIdType wrong = isReal ? FirstThatIsNoLabel(array) : -1;
  return wrong < 0 ? std::string()
                   : "the array " + name +
      " has values that are not whole numbers, the first is that of voxel " + std::to_string(wrong);
}
}

//------------------------------------------------------------------------------
ImageLabels ReadImageLabels(vtkImageData* image, vtkDataArray* array, int association)
{
  ImageLabels result;
  const bool ofCells = association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  VoxelGrid grid = GridOf(image, ofCells);
  result.Problem = ProblemOf(image, array, static_cast<vtkIdType>(grid.NumberOfVoxels()));
  if (result.Problem.empty())
  {
    result.Problem = ReadLayers(image, ofCells, grid);
  }
  if (!result.Problem.empty())
  {
    return result;
  }
  result.Array = AsIntegers(array);
  switch (result.Array->GetDataType())
  {
    vtkTemplateMacro(
      result.Image = ImageOf(static_cast<const VTK_TT*>(result.Array->GetVoidPointer(0)), grid));
    default:
      result.Problem = "the array has a type that is not supported";
  }
  return result;
}

//------------------------------------------------------------------------------
vtkDataArray* OnlyArray(vtkImageData* image, vtkInformation* choice, int& association)
{
  const char* const name = choice ? choice->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  vtkPointData* const points = image->GetPointData();
  vtkCellData* const cells = image->GetCellData();
  if ((name && *name != '\0') || points->GetNumberOfArrays() + cells->GetNumberOfArrays() != 1)
  {
    return nullptr;
  }
  const bool isOfPoints = points->GetNumberOfArrays() == 1;
  association =
    isOfPoints ? vtkDataObject::FIELD_ASSOCIATION_POINTS : vtkDataObject::FIELD_ASSOCIATION_CELLS;
  return isOfPoints ? points->GetArray(0) : cells->GetArray(0);
}

ImageLabels ReadActiveLabels(vtkImageData* image)
{
  vtkDataArray* array = image->GetPointData()->GetScalars();
  int association =
    array ? vtkDataObject::FIELD_ASSOCIATION_POINTS : vtkDataObject::FIELD_ASSOCIATION_CELLS;
  array = array ? array : image->GetCellData()->GetScalars();
  array = array ? array : OnlyArray(image, nullptr, association);
  return ReadImageLabels(image, array, association);
}

bool AreSameGrids(const VoxelGrid& a, const VoxelGrid& b)
{
  if (a.Dimensions != b.Dimensions)
  {
    return false;
  }
  for (Index layer = 0; layer < static_cast<Index>(std::max(a.Layers.size(), b.Layers.size()));
       ++layer)
  {
    if (!(std::abs(b.ToVoxels(a.ToMillimeters({ 0.0, 0.0, 1.0 * layer }))[2] - layer) <=
          LargestOffset))
    {
      return false;
    }
  }
  for (int corner = 0; corner < 8; ++corner)
  {
    Vector3 voxel;
    for (int axis = 0; axis < 3; ++axis)
    {
      voxel[axis] = (corner >> axis & 1) != 0 ? a.Dimensions[static_cast<std::size_t>(axis)] : 0;
    }
    if (!((b.ToVoxels(a.ToMillimeters(voxel)) - voxel).cwiseAbs().maxCoeff() <= LargestOffset))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
ModelLabels FindModelLabels(const ImageLabels& labels, const ModelGridRequest& request)
{
  const ModelGrid found = FindModelGrid(labels.Image, request);
  ModelLabels model;
  if (!found.IsFound)
  {
    return model;
  }
  const LabelImage map = found.Map();
  const auto array = vtkSmartPointer<vtkDataArray>::Take(labels.Array->NewInstance());
  array->SetName(labels.Array->GetName());
  array->SetNumberOfTuples(static_cast<vtkIdType>(map.Grid.NumberOfVoxels()));
  std::memcpy(array->GetVoidPointer(0), map.Labels,
    map.Grid.NumberOfVoxels() * static_cast<std::size_t>(array->GetDataTypeSize()));
  model.Labels = { { array->GetVoidPointer(0), map.Type, map.Grid }, array, {} };
  model.Sentence = ModelGridSentence(found);
  model.Chance = found.Chance;
  model.Different = found.Different;
  return model;
}

vtkSmartPointer<vtkImageData> MakeModelImage(vtkImageData* image, const ModelLabels& model)
{
  const VoxelGrid& grid = model.Labels.Image.Grid;
  auto made = vtkSmartPointer<vtkImageData>::New();
  made->SetDimensions(grid.Dimensions.data());
  made->SetOrigin(grid.Origin.data());
  made->SetSpacing(grid.Spacing.data());
  made->SetDirectionMatrix(
    Eigen::Matrix<double, 3, 3, Eigen::RowMajor>(grid.Direction).eval().data());
  made->GetPointData()->SetScalars(model.Labels.Array);
  made->GetFieldData()->ShallowCopy(image->GetFieldData());
  return made;
}

ModelLabels FindLabelsOnGrid(const ImageLabels& labels, const VoxelGrid& grid, int threads)
{
  if (AreSameGrids(labels.Image.Grid, grid))
  {
    return { labels, {}, 1.0, 0 };
  }
  for (const std::optional<Vector3>& spacing :
    { std::optional<Vector3>(), std::optional<Vector3>(grid.Spacing) })
  {
    ModelLabels model = FindModelLabels(labels, { spacing, threads });
    if (model.AreFound() && AreSameGrids(model.Labels.Image.Grid, grid))
    {
      return model;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
void RequestWholeImage(vtkInformation* input)
{
  int whole[6] = { 0, -1, 0, -1, 0, -1 };
  input->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), whole, 6);
}

bool IsWholeImage(vtkImageData* image, vtkInformation* input)
{
  int whole[6] = { 0, -1, 0, -1, 0, -1 };
  input->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  return std::equal(whole, whole + 6, image->GetExtent());
}
}
