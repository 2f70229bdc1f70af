// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Crossings.h"

#include "BruteForce.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace bonedecimate::testsupport
{
namespace
{
using Real = long double;
using Vector = Eigen::Matrix<Real, 3, 1>;
using Corners = std::array<Vector3, 3>;

/// 0 where the coordinates, which are rounded to double, may have either sign.
int SignOf(Real x, Real scale)
{
  constexpr Real slack = 1e-13L;
  return (x > slack * scale ? 1 : 0) - (x < -slack * scale ? 1 : 0);
}

/// On which side of the plane a b c the point d lies.
int Side(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  const Vector ad = (a - d).cast<Real>();
  const Vector bd = (b - d).cast<Real>();
  const Vector cd = (c - d).cast<Real>();
  return SignOf(ad.dot(bd.cross(cd)), ad.norm() * bd.norm() * cd.norm());
}

/// A point projected along one axis.
using Flat = std::array<Real, 2>;

int Side(const Flat& a, const Flat& b, const Flat& c)
{
  const Flat ab = { b[0] - a[0], b[1] - a[1] };
  const Flat ac = { c[0] - a[0], c[1] - a[1] };
  return SignOf(ab[0] * ac[1] - ab[1] * ac[0],
    (std::abs(ab[0]) + std::abs(ab[1])) * (std::abs(ac[0]) + std::abs(ac[1])));
}

bool IsOn(const Flat& a, const Flat& b, const Flat& p)
{
  return Side(a, b, p) == 0 && std::min(a[0], b[0]) <= p[0] && p[0] <= std::max(a[0], b[0]) &&
    std::min(a[1], b[1]) <= p[1] && p[1] <= std::max(a[1], b[1]);
}

bool SegmentsMeet(const Flat& a, const Flat& b, const Flat& c, const Flat& d)
{
  return (Side(a, b, c) * Side(a, b, d) < 0 && Side(c, d, a) * Side(c, d, b) < 0) ||
    IsOn(a, b, c) || IsOn(a, b, d) || IsOn(c, d, a) || IsOn(c, d, b);
}

bool MeetInPlane(const Vector3& p, const Vector3& q, const Corners& t)
{
  Eigen::Index drop = 0;
  (t[1] - t[0]).cross(t[2] - t[0]).cwiseAbs().maxCoeff(&drop);
  const auto flatten = [drop](const Vector3& x) {
    return Flat{ x[(drop + 1) % 3], x[(drop + 2) % 3] };
  };
  const std::array<Flat, 3> c = { flatten(t[0]), flatten(t[1]), flatten(t[2]) };
  const Flat from = flatten(p);
  const Flat to = flatten(q);
  const int sum = Side(c[0], c[1], from) + Side(c[1], c[2], from) + Side(c[2], c[0], from);
  return sum == 3 || sum == -3 || SegmentsMeet(from, to, c[0], c[1]) ||
    SegmentsMeet(from, to, c[1], c[2]) || SegmentsMeet(from, to, c[2], c[0]);
}

bool SegmentMeets(const Vector3& p, const Vector3& q, const Corners& t)
{
  const int above = Side(t[0], t[1], t[2], p);
  const int below = Side(t[0], t[1], t[2], q);
  if (above == 0 && below == 0)
  {
    return MeetInPlane(p, q, t);
  }
  if (above == below)
  {
    return false;
  }
  const std::array<int, 3> turns = { Side(p, q, t[0], t[1]), Side(p, q, t[1], t[2]),
    Side(p, q, t[2], t[0]) };
  const int least = *std::min_element(turns.begin(), turns.end());
  const int most = *std::max_element(turns.begin(), turns.end());
  return least == 0 && most == 0 ? MeetInPlane(p, q, t) : least >= 0 || most <= 0;
}

Corners CornersOf(const Surface& surface, const Triangle& t)
{
  return { surface.Points[t[0]], surface.Points[t[1]], surface.Points[t[2]] };
}

bool BoxesMeet(const Corners& a, const Corners& b, double reach)
{
  const auto low = [](const Corners& c) { return c[0].cwiseMin(c[1]).cwiseMin(c[2]).eval(); };
  const auto high = [](const Corners& c) { return c[0].cwiseMax(c[1]).cwiseMax(c[2]).eval(); };
  return (low(a) - high(b)).maxCoeff() <= reach && (low(b) - high(a)).maxCoeff() <= reach;
}

bool Meet(const Corners& a, const Corners& b)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (SegmentMeets(a[i], a[(i + 1) % 3], b) || SegmentMeets(b[i], b[(i + 1) % 3], a))
    {
      return true;
    }
  }
  return false;
}

/// The triangle turned so that it begins with what both have.
Triangle Turned(const Triangle& t, const Triangle& other, bool hasTwoInCommon)
{
  const auto isShared = [&](Index v)
  { return std::find(other.begin(), other.end(), v) != other.end(); };
  Triangle turned = t;
  while (!isShared(turned[0]) || (hasTwoInCommon && !isShared(turned[1])))
  {
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
  }
  return turned;
}

bool FoldsFlat(const Corners& a, const Vector3& third)
{
  if (Side(a[0], a[1], a[2], third) != 0)
  {
    return false;
  }
  const Vector edge = (a[1] - a[0]).cast<Real>();
  const Vector up = edge.cross((a[2] - a[0]).cast<Real>());
  return up.dot(edge.cross((third - a[0]).cast<Real>())) > 0;
}

/// Where the lines of two segments come nearest, if that is inside of both; infinite if not.
double DistanceInside(const Vector3& p, const Vector3& toP, const Vector3& q, const Vector3& toQ)
{
  const Vector u = (toP - p).cast<Real>();
  const Vector v = (toQ - q).cast<Real>();
  const Vector w = (p - q).cast<Real>();
  const Real determinant = u.dot(u) * v.dot(v) - u.dot(v) * u.dot(v);
  const Real s = u.dot(v) * v.dot(w) - v.dot(v) * u.dot(w);
  const Real t = u.dot(u) * v.dot(w) - u.dot(v) * u.dot(w);
  const bool isInside = determinant > 0 && s > 0 && s < determinant && t > 0 && t < determinant;
  return isInside ? static_cast<double>((w + s / determinant * u - t / determinant * v).norm())
                  : std::numeric_limits<double>::infinity();
}

double Distance(const Corners& a, const Corners& b)
{
  if (BoxesMeet(a, b, 0.0) && Meet(a, b))
  {
    return 0.0;
  }
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i)
  {
    least = std::min({ least, PointTriangleDistance(a[i], b[0], b[1], b[2]),
      PointTriangleDistance(b[i], a[0], a[1], a[2]) });
    for (std::size_t j = 0; j < 3; ++j)
    {
      least = std::min(least, DistanceInside(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]));
    }
  }
  return least;
}
}

bool Cross(const Surface& surface, const Triangle& a, const Triangle& b)
{
  const auto shared = std::count_if(
    a.begin(), a.end(), [&b](Index v) { return std::find(b.begin(), b.end(), v) != b.end(); });
  if (shared == 0)
  {
    return Meet(CornersOf(surface, a), CornersOf(surface, b));
  }
  if (shared == 3)
  {
    return true;
  }
  const Corners p = CornersOf(surface, Turned(a, b, shared == 2));
  const Corners q = CornersOf(surface, Turned(b, a, shared == 2));
  return shared == 1 ? SegmentMeets(p[1], p[2], q) || SegmentMeets(q[1], q[2], p)
                     : FoldsFlat(p, q[2]);
}

std::int64_t CountCrossings(const Surface& surface)
{
  std::int64_t count = 0;
  for (std::size_t i = 0; i < surface.Triangles.size(); ++i)
  {
    const Corners a = CornersOf(surface, surface.Triangles[i]);
    for (std::size_t j = i + 1; j < surface.Triangles.size(); ++j)
    {
      const Triangle& other = surface.Triangles[j];
      count +=
        BoxesMeet(a, CornersOf(surface, other), 0.0) && Cross(surface, surface.Triangles[i], other)
        ? 1
        : 0;
    }
  }
  return count;
}

double LeastDistance(const Surface& surface, const IsChosen& first, const IsChosen& second)
{
  double least = std::numeric_limits<double>::infinity();
  std::vector<Corners> others;
  for (const Triangle& b : surface.Triangles)
  {
    if (second(b))
    {
      others.push_back(CornersOf(surface, b));
    }
  }
  for (const Triangle& a : surface.Triangles)
  {
    const Corners p = CornersOf(surface, a);
    for (std::size_t i = 0; first(a) && i < others.size(); ++i)
    {
      least = BoxesMeet(p, others[i], least) ? std::min(least, Distance(p, others[i])) : least;
    }
  }
  return least;
}

double LeastDistanceOfComponents(const Surface& surface)
{
  const std::vector<Index> components = ComponentOfTriangles(surface);
  std::vector<Index> ofPoint(surface.Points.size(), None);
  for (std::size_t t = 0; t < components.size(); ++t)
  {
    for (const Index point : surface.Triangles[t])
    {
      ofPoint[point] = components[t];
    }
  }
  double least = std::numeric_limits<double>::infinity();
  const Index count = *std::max_element(components.begin(), components.end()) + 1;
  for (Index component = 0; component < count; ++component)
  {
    least = std::min(least,
      LeastDistance(
        surface, [&](const Triangle& t) { return ofPoint[t[0]] == component; },
        [&](const Triangle& t) { return ofPoint[t[0]] > component; }));
  }
  return least;
}
}
