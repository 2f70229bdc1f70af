// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PassedCells.h
 * @brief Vertices and lines of the input on their way to the output, with the points that they use.
 */
#ifndef PassedCells_h
#define PassedCells_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkCellArray;
class vtkPoints;
class vtkPolyData;

namespace bonedecimate
{
/// Where points and cells of the output come from that are no part of the surface. Ids are those of
/// the input.
struct PassedIds
{
  std::vector<vtkIdType> Points; ///< Points after those of the surface.
  std::vector<vtkIdType> Cells;  ///< Cells before the triangles.
};

class PassedCells
{
public:
  /// @param points Points of the output; those of a cell are appended at their first use.
  PassedCells(vtkPolyData* input, vtkPoints* points);

  /// Passes the cells whose ids are valid.  @param firstCell Id of the first of these cells.
  vtkSmartPointer<vtkCellArray> Pass(vtkCellArray* cells, vtkIdType firstCell);

  const PassedIds& Ids() const { return this->Passed; }

private:
  void PassPoints(vtkIdType npts, const vtkIdType* old);

  vtkPolyData* Input;
  vtkPoints* Points;
  std::vector<vtkIdType> NewId; // of each input point
  std::vector<vtkIdType> Corners;
  PassedIds Passed;
};
}

#endif
