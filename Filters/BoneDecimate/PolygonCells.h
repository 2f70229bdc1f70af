// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PolygonCells.h
 * @brief Polygons and strips of vtkPolyData as triangles, each with the cell it came from.
 */
#ifndef PolygonCells_h
#define PolygonCells_h

#include "Geometry/Surface.h"

#include "vtkType.h"

#include <array>
#include <vector>

class vtkPolyData;

namespace bonedecimate
{
struct TriangulatedCells
{
  std::vector<Triangle> Triangles;
  std::vector<vtkIdType> CellOfTriangle;
  vtkIdType LeftOut = 0; ///< Cells without a triangle.
  vtkIdType FirstLeftOut = -1;
  std::vector<std::array<Vector3, 3>> ShapesLeftOut; ///< mm, a point or a segment of each.
};

/**
 * Every polygon is triangulated (PolygonTriangulation.h). Polygons and strips of fewer than three
 * corners at different positions are left out. If a cell has a wrong id, the result is one triangle
 * of three None for each of these cells: the core rejects it.
 */
TriangulatedCells TriangulateCells(vtkPolyData* input, const std::vector<Vector3>& points);
}

#endif
