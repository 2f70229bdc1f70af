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
