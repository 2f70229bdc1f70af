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
/// Of the product of the lengths: below it an inner product may be rounding.
constexpr double Slack = 1e-12;
/// The same where a plane has to hold others apart that lie in it: far above the slack.
constexpr double Clear = 1e-9;
/// The sine of the least angle between two rays in one plane that are told apart.
constexpr double LeastSine = 1e-3;

/// Six corners relative to the first.
struct Six
{
  Six(const TriangleCorners& a, const TriangleCorners& b)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->A[i] = a[i] - a[0];
      this->B[i] = b[i] - a[0];
      this->Size = std::max(
        { this->Size, this->A[i].cwiseAbs().maxCoeff(), this->B[i].cwiseAbs().maxCoeff() });
    }
  }

  bool AreApart(const Vector3& axis) const
  {
    const double slack = Slack * this->Size * axis.cwiseAbs().sum();
    const std::array<double, 3> a = { 0.0, axis.dot(this->A[1]), axis.dot(this->A[2]) };
    const std::array<double, 3> b = { axis.dot(this->B[0]), axis.dot(this->B[1]),
      axis.dot(this->B[2]) };
    return std::min({ a[0], a[1], a[2] }) > std::max({ b[0], b[1], b[2] }) + slack ||
      std::min({ b[0], b[1], b[2] }) > std::max({ a[0], a[1], a[2] }) + slack;
  }

  TriangleCorners A, B; // mm
  double Size = 0.0;    // mm
};

TriangleCorners EdgesOf(const TriangleCorners& corners)
{
  return { corners[1] - corners[0], corners[2] - corners[1], corners[0] - corners[2] };
}

/// On which side of a plane through the tip a ray lies: -1, 1, 0 in it, 2 unclear.
int SideOf(const Vector3& normal, const Vector3& ray)
{
  const double height = normal.dot(ray);
  const double scale = std::sqrt(normal.squaredNorm() * ray.squaredNorm());
  return std::abs(height) <= Slack * scale ? 0
    : std::abs(height) < Clear * scale     ? 2
    : height > 0.0                         ? 1
                                           : -1;
}

bool AreApart(const Vector3& ray, const Vector3& other)
{
  const double squared = ray.squaredNorm() * other.squaredNorm();
  return ray.dot(other) < 0.0 || ray.cross(other).squaredNorm() > LeastSine * LeastSine * squared;
}

using Rays = std::array<Vector3, 2>;

/// Whether the plane lies between the angles; each may have one ray in it, if those differ.
bool AreApart(const Vector3& normal, const Rays& a, const Rays& b)
{
  const std::array<int, 2> sideA = { SideOf(normal, a[0]), SideOf(normal, a[1]) };
  const std::array<int, 2> sideB = { SideOf(normal, b[0]), SideOf(normal, b[1]) };
  const int low = std::min(sideA[0], sideA[1]);
  const int high = std::max(sideA[0], sideA[1]);
  const int lowB = std::min(sideB[0], sideB[1]);
  const int highB = std::max(sideB[0], sideB[1]);
  const bool areOpposite = (low >= 0 && highB <= 0) || (high <= 0 && lowB >= 0);
  if (high == 2 || highB == 2 || !areOpposite)
  {
    return false;
  }
  const bool allOfA = low == 0 && high == 0;
  const bool allOfB = lowB == 0 && highB == 0;
  const bool noneOfA = sideA[0] != 0 && sideA[1] != 0;
  const bool noneOfB = sideB[0] != 0 && sideB[1] != 0;
  if (noneOfA || noneOfB)
  {
    return true;
  }
  return !allOfA && !allOfB && AreApart(a[sideA[0] == 0 ? 0 : 1], b[sideB[0] == 0 ? 0 : 1]);
}

/// Between segments from p along u and from q along v.
Way WayBetweenSegments(const Vector3& p, const Vector3& u, const Vector3& q, const Vector3& v)
{
  const Vector3 w = p - q;
  const double a = u.squaredNorm();
  const double b = u.dot(v);
  const double c = v.squaredNorm();
  const double d = u.dot(w);
  const double e = v.dot(w);
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
}

bool Meet(const TriangleCorners& a, const TriangleCorners& b)
{
  const Six six(a, b);
  const TriangleCorners edgesA = EdgesOf(six.A);
  const TriangleCorners edgesB = EdgesOf(six.B);
  const Vector3 normalA = edgesA[0].cross(edgesA[1]);
  const Vector3 normalB = edgesB[0].cross(edgesB[1]);
  if (six.AreApart(normalA) || six.AreApart(normalB))
  {
    return false;
  }
  for (const Vector3& edgeA : edgesA)
  {
    for (const Vector3& edgeB : edgesB)
    {
      if (six.AreApart(edgeA.cross(edgeB)))
      {
        return false;
      }
    }
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (six.AreApart(normalA.cross(edgesA[i])) || six.AreApart(normalB.cross(edgesB[i])) ||
      six.AreApart(normalA.cross(edgesB[i])) || six.AreApart(normalB.cross(edgesA[i])))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool MeetBeyondCorner(const TriangleCorners& a, const TriangleCorners& b)
{
  const Rays raysA = { a[1] - a[0], a[2] - a[0] };
  const Rays raysB = { b[1] - a[0], b[2] - a[0] };
  const Vector3 normalA = raysA[0].cross(raysA[1]);
  const Vector3 normalB = raysB[0].cross(raysB[1]);
  if (AreApart(normalA, raysA, raysB) || AreApart(normalB, raysA, raysB))
  {
    return false;
  }
  for (const Vector3& rayA : raysA)
  {
    for (const Vector3& rayB : raysB)
    {
      if (AreApart(rayA.cross(rayB), raysA, raysB))
      {
        return false;
      }
    }
  }
  for (std::size_t i = 0; i < 2; ++i)
  {
    if (AreApart(normalA.cross(raysA[i]), raysA, raysB) ||
      AreApart(normalB.cross(raysB[i]), raysA, raysB))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool MeetBeyondEdge(const TriangleCorners& a, const TriangleCorners& b)
{
  const Vector3 edge = a[1] - a[0];
  const Vector3 upA = edge.cross(a[2] - a[0]);
  const Vector3 upB = edge.cross(b[2] - a[0]);
  const double squared = upA.squaredNorm() * upB.squaredNorm();
  return upA.dot(upB) >= 0.0 && upA.cross(upB).squaredNorm() <= Clear * Clear * squared;
}

//------------------------------------------------------------------------------
RayAnswer ShootRay(const Vector3& p, const Vector3& direction, const TriangleCorners& corners)
{
  const TriangleCorners from = { corners[0] - p, corners[1] - p, corners[2] - p };
  bool isUnclear = false;
  int sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Vector3& a = from[i];
    const Vector3& b = from[(i + 1) % 3];
    const double side = direction.dot(a.cross(b));
    const bool isSmall = std::abs(side) <=
      Slack * direction.cwiseAbs().sum() * a.cwiseAbs().sum() * b.cwiseAbs().sum();
    isUnclear = isUnclear || isSmall;
    sum += isSmall ? 0 : side > 0.0 ? 1 : -1;
  }
  if (!isUnclear && sum != 3 && sum != -3)
  {
    return RayAnswer::Misses;
  }
  const Vector3 normal = (from[1] - from[0]).cross(from[2] - from[0]);
  const double height = normal.dot(from[0]);
  if (isUnclear || std::abs(height) <= Slack * normal.cwiseAbs().sum() * from[0].cwiseAbs().sum())
  {
    return RayAnswer::Unclear;
  }
  return (height > 0.0) == (sum > 0) ? RayAnswer::Hits : RayAnswer::Misses;
}

//------------------------------------------------------------------------------
Way WayBetween(const TriangleCorners& a, const TriangleCorners& b)
{
  const TriangleFrame frameA(a[0], a[1], a[2]);
  const TriangleFrame frameB(b[0], b[1], b[2]);
  const TriangleCorners edgesA = EdgesOf(a);
  const TriangleCorners edgesB = EdgesOf(b);
  Way least;
  least.SquaredLength = std::numeric_limits<double>::infinity();
  const auto take = [&least](const Way& way)
  { least = way.SquaredLength < least.SquaredLength ? way : least; };
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Vector3 fromA = frameB.At(frameB.Nearest(a[i])) - a[i];
    const Vector3 toB = b[i] - frameA.At(frameA.Nearest(b[i]));
    take({ fromA.squaredNorm(), fromA });
    take({ toB.squaredNorm(), toB });
    for (std::size_t j = 0; j < 3; ++j)
    {
      take(WayBetweenSegments(a[i], edgesA[i], b[j], edgesB[j]));
    }
  }
  return least;
}
}
