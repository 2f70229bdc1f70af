// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TrianglePair.h"

#include "Geometry/TriangleFrame.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
/// Signs of the corners of one triangle: on which side of the plane of the other they lie.
using Sides = std::array<int, 3>;

Sides SidesOf(const OrientedPlane& plane, const TriangleCorners& corners)
{
  return { plane.SideOf(corners[0]), plane.SideOf(corners[1]), plane.SideOf(corners[2]) };
}

bool AreStrictlyOnOneSide(const Sides& sides)
{
  return sides[0] != 0 && sides[0] == sides[1] && sides[0] == sides[2];
}

bool AreZero(const Sides& sides)
{
  return sides[0] == 0 && sides[1] == 0 && sides[2] == 0;
}

/// Turned so that the first corner lies alone on its side of the plane of the other triangle, the
/// positive one: the others lie in the plane or on the negative side, or the first lies in front of
/// two in the plane.
/// @return Whether the other triangle has to be taken in reverse, because the first corner was on
///   the negative side.
bool IsolateFirst(TriangleCorners& corners, const Sides& sides)
{
  for (const int side : { 1, -1 })
  {
    const auto count = std::count(sides.begin(), sides.end(), side);
    const auto opposite = std::count(sides.begin(), sides.end(), -side);
    // Alone on its side; two in the plane; or alone in the plane, with both others on the opposite
    // side.
    const int alone = count == 1 ? side : count == 0 && opposite == 2 ? 0 : 2;
    if (alone != 2)
    {
      const auto first = std::find(sides.begin(), sides.end(), alone) - sides.begin();
      std::rotate(corners.begin(), corners.begin() + first, corners.end());
      return side < 0;
    }
  }
  return false; // not called if all are on one side or in the plane
}

/// The axis along which the corners are projected to an area, and the sign of that; 0 if they lie
/// on a line.
struct Projection
{
  explicit Projection(const TriangleCorners& t)
  {
    const Vector3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
    normal.cwiseAbs().maxCoeff(&this->Axis);
    for (int i = 0; i < 3 && this->Sign == 0; ++i)
    {
      this->Axis = i == 0 ? this->Axis : (this->Axis + 1) % 3;
      this->Sign = ProjectedOrientation(t[0], t[1], t[2], this->Axis);
    }
  }

  int Of(const Vector3& a, const Vector3& b, const Vector3& c) const
  {
    return this->Sign * ProjectedOrientation(a, b, c, this->Axis);
  }

  Eigen::Index Axis = 0;
  int Sign = 0;
};

/// Whether all of b is strictly beyond an edge of a. Both triangles lie in one plane.
bool HasSeparatingEdge(
  const TriangleCorners& a, const TriangleCorners& b, const Projection& projection)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    const auto isBeyond = [&](const Vector3& p)
    { return projection.Of(a[i], a[(i + 1) % 3], p) < 0; };
    if (std::all_of(b.begin(), b.end(), isBeyond))
    {
      return true;
    }
  }
  return false;
}

/// For triangles in one plane. Convex polygons are disjoint if and only if an edge of one of them
/// separates them.
bool MeetInPlane(const TriangleCorners& a, const TriangleCorners& b)
{
  const Projection ofA(a);
  const Projection ofB(b);
  return ofA.Sign == 0 || ofB.Sign == 0 ||
    (!HasSeparatingEdge(a, b, ofA) && !HasSeparatingEdge(b, a, ofB));
}

/// The corners, rotated so that this one is the first.
TriangleCorners Turned(const TriangleCorners& corners, std::size_t first)
{
  return { corners[first], corners[(first + 1) % 3], corners[(first + 2) % 3] };
}

/// Whether the ray from a[0] through p runs in the angle at a[0] or along one of its sides.
bool IsInAngle(const TriangleCorners& a, const Vector3& p, const Projection& projection)
{
  return projection.Of(a[0], a[1], p) >= 0 && projection.Of(a[0], p, a[2]) >= 0;
}

/// For triangles in one plane whose first corners are the same.
bool AnglesOverlap(const TriangleCorners& a, const TriangleCorners& b)
{
  const Projection ofA(a);
  const Projection ofB(b);
  return ofA.Sign == 0 || ofB.Sign == 0 || IsInAngle(a, b[1], ofA) || IsInAngle(a, b[2], ofA) ||
    IsInAngle(b, a[1], ofB) || IsInAngle(b, a[2], ofB);
}

/// Whether three signs are those of a line that goes through a triangle, its boundary included.
bool GoesThrough(int first, int second, int third)
{
  return std::min({ first, second, third }) >= 0 || std::max({ first, second, third }) <= 0;
}

TriangleCorners EdgesOf(const TriangleCorners& corners)
{
  return { corners[1] - corners[0], corners[2] - corners[1], corners[0] - corners[2] };
}

/// The shortest connection of the segments from p along u and from q along v.
Connection ShortestConnectionOfSegments(
  const Vector3& p, const Vector3& u, const Vector3& q, const Vector3& v)
{
  const Vector3 w = p - q;
  const double a = u.squaredNorm();
  const double b = Dot(u, v);
  const double c = v.squaredNorm();
  const double d = Dot(u, w);
  const double e = Dot(v, w);
  const double determinant = a * c - b * b;
  double s = determinant > 0.0 ? std::clamp((b * e - c * d) / determinant, 0.0, 1.0) : 0.0;
  double t = c > 0.0 ? (b * s + e) / c : 0.0;
  if (t < 0.0 || t > 1.0)
  {
    t = std::clamp(t, 0.0, 1.0);
    s = a > 0.0 ? std::clamp((b * t - d) / a, 0.0, 1.0) : 0.0;
  }
  const Vector3 way = t * v - s * u - w;
  return { way.squaredNorm(), way };
}

/// For triangles in different planes that both reach across the plane of the other: each covers an
/// interval of the line in which the planes meet (P. Guigue, O. Devillers, Fast and robust
/// triangle-triangle overlap test using orientation predicates, 2003).
bool IntervalsOverlap(
  TriangleCorners p, const Sides& sidesA, TriangleCorners q, const Sides& sidesB)
{
  const bool reverseB = IsolateFirst(p, sidesA);
  const bool reverseA = IsolateFirst(q, sidesB);
  if (reverseB)
  {
    std::swap(q[1], q[2]);
  }
  if (reverseA)
  {
    std::swap(p[1], p[2]);
  }
  return Orientation(p[0], p[1], q[0], q[1]) <= 0 && Orientation(p[0], p[2], q[2], q[0]) <= 0;
}

/// Whether an edge of a has its ends on both sides of b and passes all sides of b alike.
bool AnyEdgePierces(const PlaneTriangle& a, const PlaneTriangle& b)
{
  const TriangleCorners& p = a.Corners;
  const TriangleCorners& q = b.Corners;
  const Sides sides = SidesOf(b.Plane, p);
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t next = (i + 1) % 3;
    if (sides[i] * sides[next] < 0)
    {
      const int first = Orientation(p[i], p[next], q[0], q[1]);
      if (first != 0 && Orientation(p[i], p[next], q[1], q[2]) == first &&
        Orientation(p[i], p[next], q[2], q[0]) == first)
      {
        return true;
      }
    }
  }
  return false;
}

/// The number of the first corner that the other triangle has, or that it does not have.
std::size_t FindCorner(const Triangle& ids, const Triangle& other, bool isCommon)
{
  std::size_t i = 0;
  while (i < 2 && HasCorner(other, ids[i]) != isCommon)
  {
    ++i;
  }
  return i;
}
}

bool HasArea(const TriangleCorners& corners)
{
  return Projection(corners).Sign != 0;
}

//------------------------------------------------------------------------------
bool Meet(const PlaneTriangle& a, const PlaneTriangle& b)
{
  const Sides sidesB = SidesOf(a.Plane, b.Corners);
  if (AreStrictlyOnOneSide(sidesB))
  {
    return false;
  }
  const Sides sidesA = SidesOf(b.Plane, a.Corners);
  if (AreStrictlyOnOneSide(sidesA))
  {
    return false;
  }
  if (AreZero(sidesA) || AreZero(sidesB))
  {
    // One of them without area has no plane: in doubt it meets.
    return AreZero(sidesA) != AreZero(sidesB) || MeetInPlane(a.Corners, b.Corners);
  }
  return IntervalsOverlap(a.Corners, sidesA, b.Corners, sidesB);
}

//------------------------------------------------------------------------------
/// They intersect if one meets the side of the other that is opposite to the common corner.
bool MeetBeyondCorner(
  const PlaneTriangle& a, std::size_t cornerOfA, const PlaneTriangle& b, std::size_t cornerOfB)
{
  const TriangleCorners p = Turned(a.Corners, cornerOfA);
  const TriangleCorners q = Turned(b.Corners, cornerOfB);
  const std::array<int, 2> sidesQ = { a.Plane.SideOf(q[1]), a.Plane.SideOf(q[2]) };
  if (sidesQ[0] * sidesQ[1] > 0)
  {
    return false;
  }
  const std::array<int, 2> sidesP = { b.Plane.SideOf(p[1]), b.Plane.SideOf(p[2]) };
  if (sidesP[0] * sidesP[1] > 0)
  {
    return false;
  }
  const bool isFlatP = sidesP[0] == 0 && sidesP[1] == 0;
  const bool isFlatQ = sidesQ[0] == 0 && sidesQ[1] == 0;
  if (isFlatP || isFlatQ)
  {
    // One of them without area has no plane: in doubt it meets.
    return isFlatP != isFlatQ || AnglesOverlap(p, q);
  }
  // Orientations of the line through the side of one to the three sides of the other.
  const int across = Orientation(q[1], q[2], p[1], p[2]);
  return GoesThrough(sidesP[0], across, -sidesP[1]) || GoesThrough(sidesQ[0], across, -sidesQ[1]);
}

//------------------------------------------------------------------------------
bool MeetBeyondEdge(const PlaneTriangle& a, std::size_t thirdOfA, const Vector3& thirdOfB)
{
  if (a.Plane.SideOf(thirdOfB) != 0)
  {
    return false;
  }
  const TriangleCorners p = Turned(a.Corners, thirdOfA);
  const Projection projection(p);
  return projection.Sign == 0 || projection.Of(p[1], p[2], thirdOfB) >= 0;
}

//------------------------------------------------------------------------------
int CountCommon(const Triangle& a, const Triangle& b)
{
  return static_cast<int>(
    std::count_if(a.begin(), a.end(), [&b](Index id) { return HasCorner(b, id); }));
}

//------------------------------------------------------------------------------
bool Meet(
  const PlaneTriangle& a, const Triangle& idsOfA, const PlaneTriangle& b, const Triangle& idsOfB)
{
  switch (CountCommon(idsOfA, idsOfB))
  {
    case 0:
      return Meet(a, b);
    case 1:
      return MeetBeyondCorner(
        a, FindCorner(idsOfA, idsOfB, true), b, FindCorner(idsOfB, idsOfA, true));
    case 2:
      return MeetBeyondEdge(
        a, FindCorner(idsOfA, idsOfB, false), b.Corners[FindCorner(idsOfB, idsOfA, false)]);
    default:
      return true;
  }
}

//------------------------------------------------------------------------------
bool Pierce(const PlaneTriangle& a, const PlaneTriangle& b)
{
  return AnyEdgePierces(a, b) || AnyEdgePierces(b, a);
}

//------------------------------------------------------------------------------
RayResult ShootRay(const Vector3& p, const Vector3& farPoint, const PlaneTriangle& triangle)
{
  const TriangleCorners& c = triangle.Corners;
  const Sides sides = { Orientation(c[0], c[1], p, farPoint), Orientation(c[1], c[2], p, farPoint),
    Orientation(c[2], c[0], p, farPoint) };
  if (!GoesThrough(sides[0], sides[1], sides[2]))
  {
    return RayResult::Misses;
  }
  const int here = triangle.Plane.SideOf(p);
  const int there = triangle.Plane.SideOf(farPoint);
  if (here != 0 && here == there)
  {
    return RayResult::Misses;
  }
  const bool isClear = here != 0 && there != 0 && sides[0] * sides[1] * sides[2] != 0;
  return isClear ? RayResult::Hits : RayResult::Unclear;
}

//------------------------------------------------------------------------------
Connection ShortestConnection(const TriangleCorners& a, const TriangleCorners& b)
{
  const TriangleFrame frameA(a[0], a[1], a[2]);
  const TriangleFrame frameB(b[0], b[1], b[2]);
  const TriangleCorners edgesA = EdgesOf(a);
  const TriangleCorners edgesB = EdgesOf(b);
  Connection least;
  least.SquaredLength = std::numeric_limits<double>::infinity();
  const auto take = [&least](const Connection& way)
  { least = way.SquaredLength < least.SquaredLength ? way : least; };
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Vector3 fromA = frameB.At(frameB.Nearest(a[i])) - a[i];
    const Vector3 toB = b[i] - frameA.At(frameA.Nearest(b[i]));
    take({ fromA.squaredNorm(), fromA });
    take({ toB.squaredNorm(), toB });
    for (std::size_t j = 0; j < 3; ++j)
    {
      take(ShortestConnectionOfSegments(a[i], edgesA[i], b[j], edgesB[j]));
    }
  }
  return least;
}
}
