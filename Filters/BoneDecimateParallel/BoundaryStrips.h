// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoundaryStrips.h
 * @brief The strips of triangles along the lines where surfaces of different processes meet.
 */
#ifndef BoundaryStrips_h
#define BoundaryStrips_h

#include "SharedPositions.h"

#include "vtkSmartPointer.h"
#include "vtkType.h" // for vtkIdType

#include <array>
#include <vector>

class vtkPoints;
class vtkPolyData;

namespace bonedecimate
{
struct StripParts
{
  /// Triangles around the shared positions, with marks of its rim and of the edges where it was cut
  /// out.
  vtkSmartPointer<vtkPolyData> Strip;
  vtkSmartPointer<vtkPolyData> Rest; ///< Everything else. Both have the arrays of the surface.
};

/// For each cell, whether it is marked or within a few rings of triangles around a marked one.
std::vector<bool> RingsAround(vtkPolyData* surface, std::vector<bool> cells);

/// For each cell, whether one of its corners is at one of the positions.
std::vector<bool> CellsAt(vtkPolyData* surface, const Positions& positions);

/// @param mayChange Cells of the strip that are not at its rim.
/// @param around Cells that it has, too, as its rim.
StripParts CutStrips(
  vtkPolyData* surface, const std::vector<bool>& mayChange, const std::vector<bool>& around);

/// The marked cells with their points and all arrays, or all others.
vtkSmartPointer<vtkPolyData> OnlyCells(vtkPolyData* surface, const std::vector<bool>& cells);
vtkSmartPointer<vtkPolyData> WithoutCells(vtkPolyData* surface, const std::vector<bool>& cells);

/// The marked cells, and a mark of the edges at which they are cut out of the surface.
vtkSmartPointer<vtkPolyData> CutOut(vtkPolyData* surface, const std::vector<bool>& cells);

/// Removes the mark of the rim: of each point of joined strips, whether it must not change.
std::vector<char> TakeRim(vtkPolyData* strips);

/// Removes the mark of edges: pairs of points.
std::vector<std::array<vtkIdType, 2>> TakeCuts(vtkPolyData* strips);

/// Cell array of an input with labels while it is decimated: the label of each cell
/// (LabelArrayName).
constexpr const char* CellLabelsName = "bonedecimate.labels";

/// The polygons without arrays but their labels (BoundaryLabels, CellLabelsName).
vtkSmartPointer<vtkPolyData> WithoutArrays(vtkPolyData* surface);

/// One after the other, with the field data of the first that has points. Points are not merged.
vtkSmartPointer<vtkPolyData> Join(const std::vector<vtkSmartPointer<vtkPolyData>>& parts);

/// mm, of each point to the nearest position of the surface; infinity if it has no cells.
std::vector<double> DistancesTo(vtkPolyData* surface, vtkPoints* points);
}

#endif
