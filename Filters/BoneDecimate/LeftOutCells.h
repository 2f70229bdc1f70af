// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LeftOutCells.h
 * @brief What of a vtkPolyData is no surface to be proved: cells without a triangle, lines,
 * vertices, and what the reader of its file left out (LeftOutOfReader.h).
 */
#ifndef LeftOutCells_h
#define LeftOutCells_h

#include "Figures/LeftOut.h"
#include "PolygonCells.h"

#include <vector>

class vtkPolyData;

namespace bonedecimate
{
/// Finds what is left out, in this order: polygons, lines, vertices, what the reader left out.
std::vector<LeftOutShape> FindLeftOut(
  vtkPolyData* input, const std::vector<Vector3>& points, const TriangulatedCells& cells);
}

#endif
