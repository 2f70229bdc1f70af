// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DataTransfer.h"

#include "PassedNames.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bonedecimate
{
namespace
{
const std::string OriginalPointIds = "OriginalPointIds";
const std::string OriginalCellIds = "OriginalCellIds";

/// An array like the other, without its values.
vtkSmartPointer<vtkAbstractArray> EmptyCopy(vtkAbstractArray* from, vtkIdType tuples)
{
  // Create by type and not by class: arrays that compute their values cannot hold others.
  auto to =
    vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(from->GetDataType()));
  to->SetName(from->GetName());
  to->SetNumberOfComponents(from->GetNumberOfComponents());
  to->CopyComponentNames(from);
  if (from->HasInformation())
  {
    to->CopyInformation(from->GetInformation());
  }
  to->SetNumberOfTuples(tuples);
  return to;
}

/// Arrays in the order of the input, each active as what it was.
void AddLike(
  vtkDataSetAttributes* from, int index, vtkAbstractArray* array, vtkDataSetAttributes* to)
{
  const int added = to->AddArray(array);
  const int attribute = from->IsArrayAnAttribute(index);
  if (attribute >= 0)
  {
    to->SetActiveAttribute(added, attribute);
  }
}

bool IsBlended(vtkDataSetAttributes* data, int index)
{
  vtkAbstractArray* array = data->GetAbstractArray(index);
  const int type = array->GetDataType();
  return vtkDataArray::SafeDownCast(array) && (type == VTK_FLOAT || type == VTK_DOUBLE) &&
    array != data->GetGlobalIds() && array != data->GetPedigreeIds();
}

/// Whether the point lies where the input point nearest to it does: then it is that one.
bool IsInputPoint(const Result& result, const ConvertedSurface& converted, std::size_t point)
{
  return result.Surface.Points[point] ==
    converted.Surface.Points[static_cast<std::size_t>(result.Origins.NearestPoint[point])];
}

void Blend(vtkDataArray* from, const Triangle& corners, const std::array<double, 3>& weights,
  vtkIdType point, vtkDataArray* to)
{
  for (int component = 0; component < from->GetNumberOfComponents(); ++component)
  {
    double sum = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      // A corner without weight may be anything, not a number too.
      sum += weights[k] == 0.0 ? 0.0 : weights[k] * from->GetComponent(corners[k], component);
    }
    to->SetComponent(point, component, sum);
  }
}

/// Normalizes an interpolated normal. Between opposite normals it takes that of the nearest point.
void Normalize(vtkDataArray* from, vtkIdType nearest, vtkIdType point, vtkDataArray* to)
{
  std::array<double, 3> normal = {};
  to->GetTuple(point, normal.data());
  // Use only sqrt of libm, so that every build and the Python package round alike.
  const double length =
    std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
  if (length < 1e-6)
  {
    to->SetTuple(point, nearest, from);
    return;
  }
  for (double& component : normal)
  {
    component /= length;
  }
  to->SetTuple(point, normal.data());
}

void FillPoints(vtkPointData* data, int index, const Result& result,
  const ConvertedSurface& converted, vtkAbstractArray* to)
{
  vtkAbstractArray* from = data->GetAbstractArray(index);
  auto* numbers = IsBlended(data, index) ? vtkDataArray::SafeDownCast(from) : nullptr;
  auto* blended = vtkDataArray::SafeDownCast(to);
  const bool isNormal = from == data->GetNormals();
  for (std::size_t p = 0; p < result.Surface.Points.size(); ++p)
  {
    const auto point = static_cast<vtkIdType>(p);
    const Index nearest = result.Origins.NearestPoint[p];
    if (!numbers || IsInputPoint(result, converted, p))
    {
      to->SetTuple(point, nearest, from);
      continue;
    }
    Blend(numbers, converted.Surface.Triangles[result.Origins.NearestTriangle[p]],
      result.Origins.Barycentric[p], point, blended);
    if (isNormal)
    {
      Normalize(numbers, nearest, point, blended);
    }
  }
}

void TransferPointArrays(const Result& result, const ConvertedSurface& converted,
  const PassedIds& passed, const ArrayNames& names, vtkPolyData* input, vtkPolyData* output)
{
  vtkPointData* data = input->GetPointData();
  const auto count = static_cast<vtkIdType>(result.Surface.Points.size());
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* from = data->GetAbstractArray(i);
    const std::string name = PassedName(from, names.Own, data);
    if (from->GetName() != nullptr &&
      (name.empty() || name == OriginalPointIds || names.LeftOut.count(name) > 0))
    {
      continue;
    }
    const vtkSmartPointer<vtkAbstractArray> to = EmptyCopy(from, output->GetNumberOfPoints());
    to->SetName(from->GetName() != nullptr ? name.c_str() : nullptr);
    FillPoints(data, i, result, converted, to);
    for (std::size_t p = 0; p < passed.Points.size(); ++p)
    {
      to->SetTuple(count + static_cast<vtkIdType>(p), passed.Points[p], from);
    }
    AddLike(data, i, to, output->GetPointData());
  }
}

/// For each output cell the input cell that it represents.
std::vector<vtkIdType> CellSources(
  const Result& result, const ConvertedSurface& converted, const PassedIds& passed)
{
  std::vector<vtkIdType> cells = passed.Cells;
  cells.reserve(cells.size() + result.Origins.TriangleAtCentroid.size());
  for (const Index triangle : result.Origins.TriangleAtCentroid)
  {
    cells.push_back(converted.CellOfTriangle[static_cast<std::size_t>(triangle)]);
  }
  return cells;
}

template <typename Ids>
vtkSmartPointer<vtkIdTypeArray> IdArray(const char* name, const Ids& ids)
{
  auto array = vtkSmartPointer<vtkIdTypeArray>::New();
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(ids.size()));
  std::copy(ids.begin(), ids.end(), array->GetPointer(0));
  return array;
}
}

void TransferArrays(const Result& result, const ConvertedSurface& converted,
  const PassedIds& passed, const ArrayNames& names, vtkPolyData* input, vtkPolyData* output)
{
  TransferPointArrays(result, converted, passed, names, input, output);
  const std::vector<vtkIdType> cells = CellSources(result, converted, passed);
  vtkCellData* data = input->GetCellData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* from = data->GetAbstractArray(i);
    if (from->GetName() != nullptr && OriginalCellIds == from->GetName())
    {
      continue;
    }
    const vtkSmartPointer<vtkAbstractArray> to =
      EmptyCopy(from, static_cast<vtkIdType>(cells.size()));
    for (std::size_t cell = 0; cell < cells.size(); ++cell)
    {
      to->SetTuple(static_cast<vtkIdType>(cell), cells[cell], from);
    }
    AddLike(data, i, to, output->GetCellData());
  }
}

//------------------------------------------------------------------------------
void AddMaps(const Result& result, const ConvertedSurface& converted, const PassedIds& passed,
  vtkPolyData* output)
{
  std::vector<vtkIdType> points(
    result.Origins.NearestPoint.begin(), result.Origins.NearestPoint.end());
  points.insert(points.end(), passed.Points.begin(), passed.Points.end());
  output->GetPointData()->AddArray(IdArray(OriginalPointIds.c_str(), points));
  output->GetCellData()->AddArray(
    IdArray(OriginalCellIds.c_str(), CellSources(result, converted, passed)));
}

//------------------------------------------------------------------------------
void AddInputMap(const Result& result, vtkPolyData* inputCopy)
{
  inputCopy->GetPointData()->AddArray(IdArray("ResultPointIds", result.Origins.OutputPoint));
}

//------------------------------------------------------------------------------
void RecomputeNormals(vtkPolyData* output)
{
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(output->GetPoints());
  surface->SetPolys(output->GetPolys());
  vtkNew<vtkPolyDataNormals> compute;
  compute->SetInputData(surface);
  compute->SplittingOff(); // points stay as they are
  compute->ConsistencyOff();
  compute->Update();
  output->GetPointData()->SetNormals(compute->GetOutput()->GetPointData()->GetNormals());
}
}
