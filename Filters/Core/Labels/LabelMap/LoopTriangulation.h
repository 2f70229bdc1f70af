// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LoopTriangulation.h
 * @brief Triangulates a closed loop of points of a cell by dynamic programming, without a
 * diagonal in a face of the cell.
 *
 * G. T. Klincsek, Minimal triangulations of polygonal domains, Annals of Discrete Mathematics 9,
 * 1980.
 */
#ifndef BoneDecimate_Core_Labels_LabelMap_LoopTriangulation_h
#define BoneDecimate_Core_Labels_LabelMap_LoopTriangulation_h

#include "CellSurface.h"

#include <array>
#include <cstddef>

namespace bonedecimate
{
/// Points of a cell in order around a polygon: at most one for each of 12 edges and 6 faces.
class CellLoop
{
public:
  void Add(int point) { this->Points[this->Count++] = point; }
  std::size_t Size() const { return this->Count; }
  int operator[](std::size_t k) const { return this->Points[k]; }

private:
  std::array<int, FirstInnerPoint> Points = {};
  std::size_t Count = 0;
};

/// The preferred sum of squared lengths of the diagonals.
enum class Diagonals
{
  Longest, ///< Normals are more accurate by 0.2 to 0.3 degrees.
  Shortest ///< Polygons of one cell do not intersect.
};

/// Adds the triangles of the loop to the surface. The loop is counter-clockwise seen from the
/// second label.
void TriangulateLoop(
  const CellLoop& loop, Index from, Index to, Diagonals diagonals, CellSurface& surface);
}

#endif
