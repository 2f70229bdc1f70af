// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TrianglePair.h
 * @brief Whether two triangles intersect, decided exactly, and how far apart they are.
 *
 *     no common corner:     they intersect if they have a point in common, even if they only touch
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

/// Whether the corners do not lie exactly on a line.
bool HasArea(const TriangleCorners& corners);

/// For triangles without a common corner.
bool Meet(const PlaneTriangle& a, const PlaneTriangle& b);
/// For triangles with one common corner, given by its number (0 to 2) in each.
bool MeetBeyondCorner(
  const PlaneTriangle& a, std::size_t cornerOfA, const PlaneTriangle& b, std::size_t cornerOfB);
/// For triangles with a common edge, given by their third corners; that of a by its number.
bool MeetBeyondEdge(const PlaneTriangle& a, std::size_t thirdOfA, const Vector3& thirdOfB);

/// Whether a triangle of ids has this one.
inline bool HasCorner(const Triangle& ids, Index id)
{
  return ids[0] == id || ids[1] == id || ids[2] == id;
}

/// How many ids of a are ids of b.
int CountCommon(const Triangle& a, const Triangle& b);

/// Whether two triangles intersect, given the ids of their corners. Triangles of the same corners
/// do.
bool Meet(
  const PlaneTriangle& a, const Triangle& idsOfA, const PlaneTriangle& b, const Triangle& idsOfB);

/// Whether an edge of one passes through the interior of the other, so that a small motion does not
/// part them.
bool Pierce(const PlaneTriangle& a, const PlaneTriangle& b);

enum class RayResult
{
  Misses,
  Hits,
  Unclear
};
/// Whether the segment from p to a distant point passes through the triangle. Unclear if it passes
/// exactly through an edge or begins on the triangle.
RayResult ShootRay(const Vector3& p, const Vector3& farPoint, const PlaneTriangle& triangle);

/// A segment between two triangles.
struct Connection
{
  double SquaredLength = 0.0;         // mm^2
  Vector3 FromAToB = Vector3::Zero(); // mm
};
/// For triangles that do not meet.
Connection ShortestConnection(const TriangleCorners& a, const TriangleCorners& b);
}

#endif
