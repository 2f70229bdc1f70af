// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CapTriangles.h
 * @brief Triangles that fill boundary loops, by a triangulator of contours.
 */
#ifndef BoneDecimate_Core_Repair_Caps_CapTriangles_h
#define BoneDecimate_Core_Repair_Caps_CapTriangles_h

#include "BoundaryLoops.h"

#include <functional>
#include <vector>

namespace bonedecimate
{
/// Closed contours in one plane, outlines and holes.
struct Contours
{
  std::vector<Vector3> Points; ///< mm
  std::vector<Index> Starts;   ///< The first point of each contour, and the number of points.
  Vector3 Normal; ///< Unit vector; outlines are counter-clockwise around it, holes clockwise.
};

/// Makes triangles between the points of contours, like vtkContourTriangulator; none if it fails.
using ContourTriangulator = std::function<std::vector<Triangle>(const Contours&)>;

/// A connected piece, and the loops that it closes.
struct Cap
{
  std::vector<Triangle> Triangles;
  std::vector<std::size_t> Loops;
};

/**
 * Fills loops as outlines and holes, seen along the sum of their areas. Each edge of a loop gets
 * one triangle, each other edge of a cap two. If the surface already has such an edge, it is split
 * in the middle.
 * @param surface Receives the new points.
 * @param found SplitEdges receives the ends of split edges, Chords the edges of the caps.
 * @param group Indices of loops. Those that cannot be filled are in no cap.
 */
std::vector<Cap> FillLoops(Surface& surface, BoundaryLoops& found,
  const std::vector<std::size_t>& group, const ContourTriangulator& triangulate);
}

#endif
