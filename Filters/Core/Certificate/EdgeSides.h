// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EdgeSides.h
 * @brief What lies across each side of a triangle, and the open borders: edges of exactly one triangle. Points of equal
 *        coordinates are one point.
 *
 * Triangles that name one point twice have no edges; those of three points in a line have three.
 */
#ifndef BoneDecimate_Core_Certificate_EdgeSides_h
#define BoneDecimate_Core_Certificate_EdgeSides_h

#include "Surface.h"

#include <array>
#include <vector>

namespace bonedecimate::certificate
{
constexpr Index Border = None;   ///< Nothing lies across.
constexpr Index NotRegular = -2; ///< Several triangles do, or one of the other orientation.

/// Of each triangle the triangles across the sides from its corners to the next ones, or one of the above.
using EdgeSides = std::vector<std::array<Index, 3>>;

EdgeSides FindEdgeSides(const std::vector<Vector3>& points, const std::vector<Triangle>& triangles);

struct BorderEdge
{
  std::array<Index, 2> Points; ///< as that triangle names them
  Index Triangle = None;
};

/// In the order of the triangles.
std::vector<BorderEdge> FindBorders(const Surface& surface);
}

#endif
