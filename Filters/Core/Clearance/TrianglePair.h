// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TrianglePair.h
 * @brief Whether two triangles meet, and how far apart they are. In doubt they meet.
 *
 * Two convex bodies are apart if and only if a plane lies between them, and of two triangles one of a few does: along a
 * face, along an edge of each, or upright on a face along an edge. A plane counts only if it keeps both at a distance
 * larger than all rounding, so that "apart" is certain and "meet" may be touching. What counts where corners are shared
 * is what CGAL::Polygon_mesh_processing::self_intersections counts.
 *
 * C. Ericson, Real-Time Collision Detection, 2005, 5.1.9 (segments) and 5.2.1 (separating axes).
 */
#ifndef BoneDecimate_Core_Clearance_TrianglePair_h
#define BoneDecimate_Core_Clearance_TrianglePair_h

#include "Surface.h"

#include <array>

namespace bonedecimate
{
using TriangleCorners = std::array<Vector3, 3>; // mm

/// No corner is shared.
bool Meet(const TriangleCorners& a, const TriangleCorners& b);
/// The first corner of both is the same: whether they meet anywhere else.
bool MeetBeyondCorner(const TriangleCorners& a, const TriangleCorners& b);
/// The first two corners of both are the same: whether one is folded flat onto the other.
bool MeetBeyondEdge(const TriangleCorners& a, const TriangleCorners& b);

enum class RayAnswer
{
  Misses,
  Hits,
  Unclear
};
/// Whether a ray from p goes through the triangle; unclear where it passes within rounding of an edge or begins on it.
RayAnswer ShootRay(const Vector3& p, const Vector3& direction, const TriangleCorners& corners);

/// The shortest way between two triangles.
struct Way
{
  double SquaredLength = 0.0;         // mm^2
  Vector3 FromAToB = Vector3::Zero(); // mm
};
/// Between triangles that do not meet.
Way WayBetween(const TriangleCorners& a, const TriangleCorners& b);
}

#endif
