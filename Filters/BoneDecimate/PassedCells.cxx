// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PassedCells.h"

#include "CellVisits.h"

#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace bonedecimate
{
PassedCells::PassedCells(vtkPolyData* input, vtkPoints* points)
  : Input(input)
  , Points(points)
  , NewId(static_cast<std::size_t>(input->GetNumberOfPoints()), -1)
{
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkCellArray> PassedCells::Pass(vtkCellArray* cells, vtkIdType firstCell)
{
  auto passed = vtkSmartPointer<vtkCellArray>::New();
  VisitCells(cells, firstCell,
    [&](vtkIdType cell, vtkIdType npts, const vtkIdType* old)
    {
      if (!HasWrongId(npts, old, this->Input->GetNumberOfPoints()))
      {
        this->PassPoints(npts, old);
        passed->InsertNextCell(npts, this->Corners.data());
        this->Passed.Cells.push_back(cell);
      }
    });
  return passed;
}

//------------------------------------------------------------------------------
void PassedCells::PassPoints(vtkIdType npts, const vtkIdType* old)
{
  this->Corners.clear();
  for (vtkIdType i = 0; i < npts; ++i)
  {
    vtkIdType& id = this->NewId[static_cast<std::size_t>(old[i])];
    if (id < 0)
    {
      id = this->Points->InsertNextPoint(this->Input->GetPoint(old[i]));
      this->Passed.Points.push_back(old[i]);
    }
    this->Corners.push_back(id);
  }
}
}
