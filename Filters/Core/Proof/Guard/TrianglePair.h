// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TrianglePair.h
 * @brief Whether two triangles intersect, decided exactly, and how far apart they are.
 *
 *     no common corner:     they intersect if they have a point in common: also if they only touch
 *     one common corner:    if they have another point in common
 *     one common edge:      if they lie in one plane on the same side of the edge
 *
 * So neighbors in one plane do not intersect unless they overlap. This is what
 * CGAL::Polygon_mesh_processing::self_intersections counts. Every sign is that of an exact
 * predicate (Geometry/ExactPredicates.h): there is no tolerance. A triangle whose corners lie
 * exactly on a line counts as intersecting wherever its plane would have to decide.
 *
 * C. Ericson, Real-Time Collision Detection, 2005, 5.1.9: the distance of segments.
 */
#ifndef BoneDecimate_Core_Proof_Guard_TrianglePair_h
#define BoneDecimate_Core_Proof_Guard_TrianglePair_h

#include "Geometry/ExactPredicates.h"

#include <array>

namespace bonedecimate
{
using TriangleCorners = std::array<Vector3, 3>; // mm

/// A triangle with its plane, for many pairs.
struct PlaneTriangle
{
  PlaneTriangle() = default;
  explicit PlaneTriangle(const TriangleCorners& corners)
    : Corners(corners)
    , Plane(corners[0], corners[1], corners[2])
  {
  }

  TriangleCorners Corners; // mm
  OrientedPlane Plane;
};

/// Whether the corners do not lie on a line, exactly.
bool HasArea(const TriangleCorners& corners);

/// No corner is shared.
bool Meet(const PlaneTriangle& a, const PlaneTriangle& b);
/// One corner of each is the same; they are named by their numbers, 0 to 2.
bool MeetBeyondCorner(
  const PlaneTriangle& a, std::size_t cornerOfA, const PlaneTriangle& b, std::size_t cornerOfB);
/// Both have an edge in common, and each a third corner beside it, that of a named by its number.
bool MeetBeyondEdge(const PlaneTriangle& a, std::size_t thirdOfA, const Vector3& thirdOfB);

/// Whether the inside of an edge of one goes through the inside of the other, so that a small
/// motion does not part them.
bool Pierce(const PlaneTriangle& a, const PlaneTriangle& b);

enum class RayResult
{
  Misses,
  Hits,
  Unclear
};
/// Whether the segment from p to a point far away goes through the triangle; unclear where it
/// passes exactly through an edge or begins on the triangle.
RayResult ShootRay(const Vector3& p, const Vector3& farPoint, const PlaneTriangle& triangle);

/// The shortest way between two triangles.
struct Way
{
  double SquaredLength = 0.0;         // mm^2
  Vector3 FromAToB = Vector3::Zero(); // mm
};
/// The shortest way between triangles that do not meet.
Way WayBetween(const TriangleCorners& a, const TriangleCorners& b);
}

#endif
