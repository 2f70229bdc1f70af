// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellVisits.h
 * @brief The cells of a vtkCellArray one after the other.
 */
#ifndef CellVisits_h
#define CellVisits_h

#include "SurfaceArrays.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <vector>

namespace bonedecimate
{
inline bool HasWrongId(vtkIdType npts, const vtkIdType* ids, vtkIdType numberOfPoints)
{
  return std::any_of(
    ids, ids + npts, [=](vtkIdType id) { return ToIndex(id, numberOfPoints) == None; });
}

/// Whether a polygon has a normal. Without one it cannot be triangulated, but VTK 9.6 makes triangles without area of it.
inline bool HasNormal(const std::vector<Vector3>& points, vtkIdType npts, const vtkIdType* ids)
{
  Vector3 sum = Vector3::Zero();
  for (vtkIdType i = 2; i < npts; ++i)
  {
    const Vector3& first = points[static_cast<std::size_t>(ids[0])];
    sum += (points[static_cast<std::size_t>(ids[i - 1])] - first)
             .cross(points[static_cast<std::size_t>(ids[i])] - first);
  }
  return sum != Vector3::Zero();
}

/// Calls visit(cell, npts, ids) for every cell of the array; cells are numbered from firstCell.
template <typename Visit>
void VisitCells(vtkCellArray* cells, vtkIdType firstCell, Visit visit)
{
  if (!cells)
  {
    return;
  }
  auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType npts = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(npts, ids);
    visit(firstCell + iterator->GetCurrentCellId(), npts, ids);
  }
}
}

#endif
