// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Shape.h
 * @brief Topology and triangle quality of plain triangles.
 */
#ifndef BoneDecimate_Testing_Oracle_Shape_h
#define BoneDecimate_Testing_Oracle_Shape_h

#include "TriangleFile.h"

#include <array>
#include <cstdint>

struct Shape
{
  std::int64_t Components = 0;          ///< Connected by common points.
  std::int64_t BoundaryEdges = 0;       ///< Edges of one triangle.
  std::int64_t NonManifoldEdges = 0;    ///< Edges of three or more triangles.
  std::int64_t NonManifoldVertices = 0; ///< Points whose triangles are not one fan.
  std::int64_t EulerNumber = 0;         ///< Points in use - edges + triangles.
  std::int64_t Degenerate = 0;          ///< Triangles below 1e-8 mm^2, or with two equal corners.
  /// Mean of 4 sqrt(3) area / (sum of squared edges), 1 for equilateral ones.
  double Quality = 0.0;
  double BadFraction = 0.0; ///< Fraction of the triangles whose quality is below 0.2.
  /// Triangles with an angle below 10, 20 and 30 degrees.
  std::array<std::int64_t, 3> SmallAngles{};
};

/// Merges exactly equal points, so that a repeated point does not make a boundary.
Triangles Welded(const Triangles& triangles);

/// @param welded Triangles with two equal corners count as degenerate and nowhere else.
Shape MeasureShape(const Triangles& welded);

#endif
