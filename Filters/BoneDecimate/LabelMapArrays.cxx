// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelMapArrays.h"

#include "Base/Parallel.h"
#include "LabelFieldOrder.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace bonedecimate
{
namespace
{
template <typename Array, typename Values>
void AddField(vtkPolyData* output, const char* name, const Values& values, int components)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  for (const auto value : values)
  {
    array->InsertNextValue(value);
  }
  output->GetFieldData()->AddArray(array);
}

void AddGrid(const VoxelGrid& grid, vtkPolyData* output)
{
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows = grid.Direction;
  AddField<vtkDoubleArray>(
    output, GridOriginName, std::vector<double>(grid.Origin.data(), grid.Origin.data() + 3), 3);
  AddField<vtkDoubleArray>(
    output, GridSpacingName, std::vector<double>(grid.Spacing.data(), grid.Spacing.data() + 3), 3);
  AddField<vtkDoubleArray>(
    output, GridDirectionName, std::vector<double>(rows.data(), rows.data() + 9), 9);
  AddField<vtkIntArray>(output, GridDimensionsName, grid.Dimensions, 3);
  if (grid.HasLayers())
  {
    AddField<vtkDoubleArray>(output, GridLayersName, grid.Layers, 1);
  }
}

template <typename Array>
void AddLabels(const LabelMapSource& source, int threads, vtkPolyData* output)
{
  using Value = typename Array::ValueType;
  std::vector<Value> values;
  values.reserve(source.Values.size());
  for (const std::int64_t value : source.Values)
  {
    values.push_back(static_cast<Value>(value));
  }
  AddField<Array>(output, LabelValuesName, values, 1);
  vtkNew<Array> labels;
  labels->SetName(BoundaryLabelsName);
  labels->SetNumberOfComponents(2);
  labels->SetNumberOfTuples(static_cast<vtkIdType>(source.OfTriangle.size()));
  Value* to = labels->GetPointer(0);
  ForEachId(source.OfTriangle.size(), threads,
    [&](std::size_t triangle)
    {
      const BoundaryLabels& both = source.OfTriangle[triangle];
      to[2 * triangle] = values[static_cast<std::size_t>(both[0])];
      to[2 * triangle + 1] = values[static_cast<std::size_t>(both[1])];
    });
  output->GetCellData()->AddArray(labels);
}

bool FitInt(const std::vector<std::int64_t>& values)
{
  return std::all_of(values.begin(), values.end(),
    [](std::int64_t value) {
      return value >= std::numeric_limits<int>::min() && value <= std::numeric_limits<int>::max();
    });
}

//------------------------------------------------------------------------------
// Reading.

class LabelMapReader
{
public:
  LabelMapReader(vtkPolyData* input, const ConvertedSurface& converted)
    : Input(input)
    , Converted(converted)
  {
  }

  ReadLabelMap Go()
  {
    ReadLabelMap result;
    this->ReadGrid();
    this->ReadValues();
    this->ReadLabels();
    this->ReadPoints();
    result.Problem = this->Problem;
    if (result.Problem.empty())
    {
      result.Source = std::move(this->Source);
    }
    return result;
  }

private:
  /// Null if it is not there; a problem if it has another shape or is not finite. -1: any number of
  /// tuples.
  vtkDataArray* Find(vtkFieldData* fields, const char* name, int components, vtkIdType tuples)
  {
    vtkDataArray* array = fields->GetArray(name);
    if (!array)
    {
      return nullptr;
    }
    if (array->GetNumberOfComponents() != components ||
      (tuples >= 0 && array->GetNumberOfTuples() != tuples))
    {
      this->Reject(name, "does not have the number of components or tuples that it needs");
      return nullptr;
    }
    for (vtkIdType tuple = 0; tuple < array->GetNumberOfTuples(); ++tuple)
    {
      for (int k = 0; k < components; ++k)
      {
        if (!(std::abs(array->GetComponent(tuple, k)) <= MaxCoordinate))
        {
          this->Reject(name, "has a value that is not finite or beyond 1e30");
          return nullptr;
        }
      }
    }
    return array;
  }

  void Reject(const char* name, const char* problem)
  {
    this->Problem = std::string("the array ") + name + " " + problem;
  }

  void ReadGrid()
  {
    vtkFieldData* fields = this->Input->GetFieldData();
    vtkDataArray* origin = this->Find(fields, GridOriginName, 3, 1);
    vtkDataArray* spacing = this->Find(fields, GridSpacingName, 3, 1);
    vtkDataArray* direction = this->Find(fields, GridDirectionName, 9, 1);
    vtkDataArray* dimensions = this->Find(fields, GridDimensionsName, 3, 1);
    if (!origin || !spacing || !direction || !dimensions)
    {
      return;
    }
    VoxelGrid& grid = this->Source.Grid;
    for (int axis = 0; axis < 3; ++axis)
    {
      grid.Origin[axis] = origin->GetComponent(0, axis);
      grid.Spacing[axis] = spacing->GetComponent(0, axis);
      grid.Dimensions[static_cast<std::size_t>(axis)] =
        ToWhole<Index>(dimensions->GetComponent(0, axis));
      for (int k = 0; k < 3; ++k)
      {
        grid.Direction(axis, k) = direction->GetComponent(0, 3 * axis + k);
      }
    }
    vtkDataArray* layers = this->Find(fields, GridLayersName, 1, grid.Dimensions[2]);
    for (vtkIdType layer = 0; layers && layer < layers->GetNumberOfTuples(); ++layer)
    {
      grid.Layers.push_back(layers->GetComponent(layer, 0));
    }
    this->CheckGrid();
  }

  void CheckGrid()
  {
    const VoxelGrid& grid = this->Source.Grid;
    if (*std::min_element(grid.Dimensions.begin(), grid.Dimensions.end()) < 1)
    {
      this->Reject(GridDimensionsName, "has a number that is not positive");
    }
    if (!(grid.Spacing.minCoeff() > 0.0))
    {
      this->Reject(GridSpacingName, "has a number that is not positive");
    }
    VoxelGrid even = grid;
    even.Layers.clear();
    if (this->Problem.empty() && !even.IsValid())
    {
      this->Reject(
        GridDirectionName, "does not have unit vectors that are not in one plane as columns");
    }
    if (this->Problem.empty() && !grid.IsValid())
    {
      this->Reject(GridLayersName,
        "does not ascend from 0 in steps of at least the third number of VoxelGridSpacing");
    }
  }

  void ReadValues()
  {
    vtkDataArray* values = this->Find(this->Input->GetFieldData(), LabelValuesName, 1, -1);
    for (vtkIdType i = 0; values && i < values->GetNumberOfTuples(); ++i)
    {
      this->Source.Values.push_back(LabelIn(values, i, 0));
    }
  }

  void ReadLabels()
  {
    vtkDataArray* labels = this->Find(
      this->Input->GetCellData(), BoundaryLabelsName, 2, this->Input->GetNumberOfCells());
    if (!labels)
    {
      return;
    }
    if (this->Source.Values.empty())
    {
      this->FindValues(labels);
    }
    // The background is last and need not be in order, so it is looked for apart from the others.
    std::vector<std::int64_t>& values = this->Source.Values;
    const auto last = values.end() - 1;
    if (!std::is_sorted(values.begin(), last))
    {
      this->Reject(LabelValuesName, "is not in ascending order");
      return;
    }
    const auto indexOf = [&](std::int64_t value)
    {
      const auto found = value == *last ? last : std::lower_bound(values.begin(), last, value);
      return *found == value ? static_cast<Index>(found - values.begin()) : None;
    };
    for (const vtkIdType cell : this->Converted.CellOfTriangle)
    {
      const BoundaryLabels both = { indexOf(LabelIn(labels, cell, 0)),
        indexOf(LabelIn(labels, cell, 1)) };
      this->Source.OfTriangle.push_back(both);
      if (both[0] == None || both[1] == None)
      {
        this->Reject(BoundaryLabelsName, "has a label that is not one of LabelValues");
        return;
      }
    }
  }

  void FindValues(vtkDataArray* labels)
  {
    std::vector<std::int64_t>& values = this->Source.Values;
    for (vtkIdType cell = 0; cell < labels->GetNumberOfTuples(); ++cell)
    {
      values.push_back(LabelIn(labels, cell, 0));
      values.push_back(LabelIn(labels, cell, 1));
    }
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    values.erase(std::remove(values.begin(), values.end(), 0), values.end());
    values.push_back(0);
  }

  void ReadPoints()
  {
    vtkDataArray* points =
      this->Find(this->Input->GetPointData(), GridPointName, 3, this->Input->GetNumberOfPoints());
    for (vtkIdType p = 0; points && p < points->GetNumberOfTuples(); ++p)
    {
      this->Source.OfPoint.push_back({ ToWhole<std::int32_t>(points->GetComponent(p, 0)),
        ToWhole<std::int32_t>(points->GetComponent(p, 1)),
        ToWhole<std::int32_t>(points->GetComponent(p, 2)) });
    }
  }

  vtkPolyData* Input;
  const ConvertedSurface& Converted;
  LabelMapSource Source;
  std::string Problem;
};
}

//------------------------------------------------------------------------------
void AddLabelMapArrays(const LabelMapSource& source, int threads, vtkPolyData* output)
{
  AddGrid(source.Grid, output);
  if (FitInt(source.Values))
  {
    AddLabels<vtkIntArray>(source, threads, output);
  }
  else
  {
    AddLabels<vtkTypeInt64Array>(source, threads, output);
  }
  vtkNew<vtkIntArray> points;
  points->SetName(GridPointName);
  points->SetNumberOfComponents(3);
  points->SetNumberOfTuples(static_cast<vtkIdType>(source.OfPoint.size()));
  int* to = points->GetPointer(0);
  ForEachId(source.OfPoint.size(), threads,
    [&](std::size_t point)
    { std::copy(source.OfPoint[point].begin(), source.OfPoint[point].end(), to + 3 * point); });
  output->GetPointData()->AddArray(points);
}

//------------------------------------------------------------------------------
void PassLabelMapArrays(
  const LabelMapSource& source, const std::vector<BoundaryLabels>& ofTriangle, vtkPolyData* output)
{
  output->GetPointData()->RemoveArray(GridPointName);
  if (ofTriangle.empty() || output->GetCellData()->HasArray(BoundaryLabelsName))
  {
    return;
  }
  vtkNew<vtkTypeInt64Array> labels;
  labels->SetName(BoundaryLabelsName);
  labels->SetNumberOfComponents(2);
  labels->SetNumberOfTuples(output->GetNumberOfCells());
  labels->Fill(0.0);
  const vtkIdType first = output->GetNumberOfCells() - output->GetNumberOfPolys();
  for (std::size_t triangle = 0; triangle < ofTriangle.size(); ++triangle)
  {
    for (int side = 0; side < 2; ++side)
    {
      const Index label = ofTriangle[triangle][static_cast<std::size_t>(side)];
      labels->SetTypedComponent(first + static_cast<vtkIdType>(triangle), side,
        source.Values[static_cast<std::size_t>(label)]);
    }
  }
  output->GetCellData()->AddArray(labels);
}

//------------------------------------------------------------------------------
ReadLabelMap ReadLabelMapArrays(vtkPolyData* input, const ConvertedSurface& converted)
{
  return LabelMapReader(input, converted).Go();
}
}
