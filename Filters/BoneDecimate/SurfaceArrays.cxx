// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceArrays.h"

#include "Base/Parallel.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <type_traits>

namespace bonedecimate
{
namespace
{
template <typename Value>
void CopyPoints(const Value* from, int threads, std::vector<Vector3>& points)
{
  ForEachId(points.size(), threads,
    [&](std::size_t p) { points[p] = Vector3(from[3 * p], from[3 * p + 1], from[3 * p + 2]); });
}

/// The array, or a copy where it is stored in another way: since VTK 9.6 offsets of triangles may
/// be computed.
template <typename Value>
vtkSmartPointer<vtkAOSDataArrayTemplate<Value>> ToPlainArray(vtkDataArray* array)
{
  using Plain = vtkAOSDataArrayTemplate<Value>;
  if (auto* plain = Plain::FastDownCast(array))
  {
    return plain;
  }
  auto copy = vtkSmartPointer<Plain>::New();
  copy->DeepCopy(array);
  return copy;
}

template <typename Value>
bool ReadStored(
  vtkCellArray* cells, vtkIdType numberOfPoints, int threads, std::vector<Triangle>& triangles)
{
  const auto offsets = ToPlainArray<Value>(cells->GetOffsetsArray());
  const auto corners = ToPlainArray<Value>(cells->GetConnectivityArray());
  const vtkIdType values = std::max<vtkIdType>(1, offsets->GetNumberOfValues());
  const auto count = static_cast<std::size_t>(values - 1);
  const auto* offset = offsets->GetPointer(0);
  std::atomic<bool> onlyTriangles{ true };
  ForEachId(count, threads,
    [&](std::size_t t)
    {
      if (offset[t + 1] - offset[t] != 3)
      {
        onlyTriangles = false;
      }
    });
  if (!onlyTriangles)
  {
    return false;
  }
  triangles.resize(count);
  const auto* corner = corners->GetPointer(0);
  ForEachId(count, threads,
    [&](std::size_t t)
    {
      const auto* ids = corner + offset[t];
      triangles[t] = { ToIndex(ids[0], numberOfPoints), ToIndex(ids[1], numberOfPoints),
        ToIndex(ids[2], numberOfPoints) };
    });
  return true;
}

template <typename Array>
vtkSmartPointer<vtkPoints> ToPointsIn(const std::vector<Vector3>& from, int threads)
{
  vtkNew<Array> array;
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(from.size()));
  auto* to = array->GetPointer(0);
  using Value = std::remove_pointer_t<decltype(to)>;
  ForEachId(from.size(), threads,
    [&](std::size_t p)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        to[3 * p + axis] = static_cast<Value>(from[p][static_cast<Eigen::Index>(axis)]);
      }
    });
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(array);
  return points;
}
}

Index ToIndex(vtkIdType id, vtkIdType numberOfPoints)
{
  return id >= 0 && id < numberOfPoints && id < std::numeric_limits<Index>::max()
    ? static_cast<Index>(id)
    : None;
}

//------------------------------------------------------------------------------
std::vector<Vector3> ReadPoints(vtkPoints* points, int threads)
{
  std::vector<Vector3> read(static_cast<std::size_t>(points->GetNumberOfPoints()));
  vtkDataArray* data = points->GetData();
  if (auto* floats = vtkFloatArray::SafeDownCast(data))
  {
    CopyPoints(floats->GetPointer(0), threads, read);
  }
  else if (auto* doubles = vtkDoubleArray::SafeDownCast(data))
  {
    CopyPoints(doubles->GetPointer(0), threads, read);
  }
  else
  {
    for (std::size_t p = 0; p < read.size(); ++p)
    {
      data->GetTuple(static_cast<vtkIdType>(p), read[p].data());
    }
  }
  return read;
}

//------------------------------------------------------------------------------
bool ReadTriangles(
  vtkCellArray* cells, vtkIdType numberOfPoints, int threads, std::vector<Triangle>& triangles)
{
  if (!cells)
  {
    return true;
  }
  return vtkAOSDataArrayTemplate<vtkTypeInt32>::FastDownCast(cells->GetConnectivityArray())
    ? ReadStored<vtkTypeInt32>(cells, numberOfPoints, threads, triangles)
    : ReadStored<vtkTypeInt64>(cells, numberOfPoints, threads, triangles);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPoints> ToPoints(const std::vector<Vector3>& from, bool single, int threads)
{
  return single ? ToPointsIn<vtkFloatArray>(from, threads)
                : ToPointsIn<vtkDoubleArray>(from, threads);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkCellArray> ToCells(const std::vector<Triangle>& from, int threads)
{
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> corners;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(from.size()) + 1);
  corners->SetNumberOfValues(3 * static_cast<vtkIdType>(from.size()));
  vtkIdType* offset = offsets->GetPointer(0);
  vtkIdType* corner = corners->GetPointer(0);
  offset[0] = 0;
  ForEachId(from.size(), threads,
    [&](std::size_t t)
    {
      std::copy(from[t].begin(), from[t].end(), corner + 3 * t);
      offset[t + 1] = static_cast<vtkIdType>(3 * t) + 3;
    });
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, corners);
  return cells;
}
}
