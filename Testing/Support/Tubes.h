// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Tubes.h
 * @brief Thin rings: surfaces around closed curves, loops of edges that run along them, and how
 * often two loops are linked.
 */
#ifndef BoneDecimate_Testing_Tubes_h
#define BoneDecimate_Testing_Tubes_h

#include "Geometry/Surface.h"

#include <vector>

namespace bonedecimate::testsupport
{
/// Points of a closed polygon, mm; the last is connected with the first.
using Loop = std::vector<Vector3>;

/// A line that passes through the hole of a ring.
struct Axis
{
  Vector3 Point;     ///< mm
  Vector3 Direction; ///< Length 1.
};

/// The surface around a loop: around each of its points a polygon of that many sides.
/// Counter-clockwise seen from outside.
/// @param radius mm.  @param flatness How many times as wide as thick: more than 1 is a band.
Surface Tube(const Loop& loop, double radius, Index sides, double flatness = 1.0);

/// Removes a triangle of each of two surfaces and connects their rims: two rings become one
/// component of two handles.
/// @param from, to mm; the triangles are those nearest to these points.
/// @param rise mm, how far the bridge runs along the normals of the triangles before it turns.
Surface Bridged(
  const Surface& first, const Surface& second, const Vector3& from, const Vector3& to, double rise);

/**
 * The shortest loop of edges from a point that winds once around the first axis, and not around any
 * other one. Empty if there is none. No edge may pass through an axis.
 */
Loop LoopAround(const Surface& surface, Index start, const std::vector<Axis>& axes);

/// Linking number of two loops that do not meet: Gauss's integral, which is a sum of solid angles
/// of parallelograms. An integer but for rounding.
double LinkingNumber(const Loop& a, const Loop& b);

/// Whether a ray meets a triangle of a surface; near an edge it may say either.
bool RayMeets(const Vector3& from, const Vector3& direction, const Surface& surface);
}

#endif
