// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LeftOutCells.h
 * @brief What of a vtkPolyData is no surface to be proved: cells without a triangle, lines, vertices, and what the reader of its file
 *        left out.
 *
 * A reader says so in the field array BoneDecimateLeftOut: four texts for each entry, its kind, count, noun and place
 * (Report/LeftOut.h). The report of a run takes them over, and the array ends there.
 */
#ifndef LeftOutCells_h
#define LeftOutCells_h

#include "PolygonCells.h"
#include "Report/LeftOut.h"

#include <vector>

class vtkFieldData;
class vtkPolyData;

namespace bonedecimate
{
/// In the order polygons, lines, vertices, and then what the reader left out.
std::vector<LeftOutShape> FindLeftOut(
  vtkPolyData* input, const std::vector<Vector3>& points, const TriangulatedCells& cells);

/// Adds an entry of a reader, unless its count is 0; its distance is not known.
void AddLeftOutOfReader(const LeftOut& entry, vtkPolyData* surface);

std::vector<LeftOut> LeftOutOfReader(vtkPolyData* surface);

void RemoveLeftOutOfReader(vtkFieldData* fieldData);
}

#endif
