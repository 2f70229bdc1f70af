// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PolygonTriangulation.h
 * @brief Triangulates polygons of any shape by ear clipping that always finishes.
 *
 *     plane       perpendicular to the sum of the corners' cross products; if that is 0 (a
 *                 bow tie), to the largest of them
 *     ear         a convex corner whose triangle contains no reflex corner, by exact signs in
 *                 the projection along an axis
 *     next ear    the one with the smallest perimeter^2 / area; of many corners first every
 *                 second one, so that no corner is in many triangles
 *     no ear      the convex corner with the smallest perimeter^2 / area, even if triangles
 *                 then overlap
 *
 * n corners always give n - 2 triangles. Every edge of the polygon is an edge of one of them, so
 * neighboring polygons still meet at their common edges. The triangles depend on differences of
 * coordinates alone. For a quadrilateral, both diagonals are compared: the one with two ears is
 * used, otherwise the shorter one. Corners at the position of the previous corner are skipped.
 *
 * The time is n log n for polygons whose ears are small, and at most n^2.
 */
#ifndef BoneDecimate_Core_Geometry_PolygonTriangulation_h
#define BoneDecimate_Core_Geometry_PolygonTriangulation_h

#include "Surface.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace bonedecimate
{
/// Triangulates one polygon after the other, and reuses its memory.
class PolygonTriangulation
{
public:
  /// @param points The points of all polygons; must outlive this object.
  explicit PolygonTriangulation(const std::vector<Vector3>& points);
  ~PolygonTriangulation();
  PolygonTriangulation(const PolygonTriangulation&) = delete;
  void operator=(const PolygonTriangulation&) = delete;

  /**
   * Appends triangles with the orientation of the polygon.
   * @param corners Valid indices of points.
   * @return False if fewer than three corners remain after skipping: nothing is appended.
   */
  bool Append(const std::vector<Index>& corners, std::vector<Triangle>& triangles);

private:
  class Clipper;
  std::unique_ptr<Clipper> Internal;
};

/// Appends the triangles of a strip, every second one reversed. False if it has fewer than three
/// corners.
bool AppendStrip(const std::vector<Index>& corners, std::vector<Triangle>& triangles);
}

#endif
