// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Tubes.h"

#include "BruteForce.h"
#include "Shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <queue>
#include <tuple>
#include <utility>

namespace bonedecimate::testsupport
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

Vector3 Perpendicular(const Vector3& v, const Vector3& tangent)
{
  return (v - v.dot(tangent) * tangent).normalized();
}

Vector3 AnyPerpendicular(const Vector3& tangent)
{
  Eigen::Index least = 0;
  tangent.cwiseAbs().minCoeff(&least);
  return Perpendicular(Vector3::Unit(least), tangent);
}

std::vector<Vector3> Tangents(const Loop& loop)
{
  std::vector<Vector3> tangents;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Vector3& next = loop[(i + 1) % loop.size()];
    const Vector3& last = loop[(i + loop.size() - 1) % loop.size()];
    tangents.push_back((next - last).normalized());
  }
  return tangents;
}

/// A normal at each point, turned as little as possible from point to point, the rest spread over
/// all.
std::vector<Vector3> FrameNormals(const std::vector<Vector3>& tangents)
{
  std::vector<Vector3> normals = { AnyPerpendicular(tangents[0]) };
  for (std::size_t i = 1; i < tangents.size(); ++i)
  {
    normals.push_back(Perpendicular(normals.back(), tangents[i]));
  }
  const Vector3 back = Perpendicular(normals.back(), tangents[0]);
  // radians
  const double twist = std::atan2(back.cross(normals[0]).dot(tangents[0]), back.dot(normals[0]));
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    const double turn = twist * static_cast<double>(i) / static_cast<double>(normals.size());
    normals[i] =
      (std::cos(turn) * normals[i] + std::sin(turn) * tangents[i].cross(normals[i])).eval();
  }
  return normals;
}

/// Two triangles of the quadrilateral that begins with the edge from a to b.
void AddQuadrilateral(Surface& surface, Index a, Index b, Index c, Index d)
{
  surface.Triangles.push_back({ a, b, c });
  surface.Triangles.push_back({ a, c, d });
}

/// Steradians, of the triangle seen from the origin, with the sign of its side (A. van Oosterom, J.
/// Strackee, 1983).
double SolidAngle(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const double x = a.norm();
  const double y = b.norm();
  const double z = c.norm();
  return 2.0 *
    std::atan2(a.dot(b.cross(c)), x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y);
}

/// Radians, by which the direction from an axis turns along a segment.
double Turn(const Axis& axis, const Vector3& from, const Vector3& to)
{
  const Vector3 a = from - axis.Point;
  const Vector3 b = to - axis.Point;
  const Vector3& n = axis.Direction;
  return std::atan2(a.cross(b).dot(n), a.dot(b) - a.dot(n) * b.dot(n));
}

/// The angle around an axis, radians.
double AngleAround(const Axis& axis, const Vector3& p)
{
  return Turn(axis, axis.Point + AnyPerpendicular(axis.Direction), p);
}

/// A vertex, and how often a path to it has crossed the direction of angle pi around each axis.
using State = std::pair<Index, std::vector<int>>;

class LoopSearch
{
public:
  LoopSearch(const Surface& surface, const std::vector<Axis>& axes)
    : Mesh(surface)
    , Axes(axes)
    , Neighbors(surface.Points.size())
  {
    for (const Triangle& t : surface.Triangles)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        this->Neighbors[t[k]].push_back(t[(k + 1) % 3]);
        this->Neighbors[t[(k + 1) % 3]].push_back(t[k]);
      }
    }
  }

  Loop Find(Index start)
  {
    const State from = { start, std::vector<int>(this->Axes.size(), 0) };
    State end = from;
    end.second[0] = 1;
    this->Length[from] = 0.0;
    this->Open.emplace(0.0, from);
    while (!this->Open.empty() && this->Open.top().second != end)
    {
      const auto [length, state] = this->Open.top();
      this->Open.pop();
      if (length <= this->Length[state])
      {
        this->Visit(state, length);
      }
    }
    Loop loop;
    for (State at = end; this->Before.count(at) != 0 && at != from; at = this->Before[at])
    {
      loop.push_back(this->Mesh.Points[at.first]);
    }
    return loop;
  }

private:
  using Item = std::pair<double, State>;

  void Visit(const State& state, double length)
  {
    const Vector3& p = this->Mesh.Points[state.first];
    for (const Index next : this->Neighbors[state.first])
    {
      const Vector3& q = this->Mesh.Points[next];
      State to = { next, state.second };
      bool isFar = false;
      for (std::size_t i = 0; i < this->Axes.size(); ++i)
      {
        const Axis& axis = this->Axes[i];
        // radians
        const double whole = AngleAround(axis, p) + Turn(axis, p, q) - AngleAround(axis, q);
        to.second[i] += static_cast<int>(std::lround(whole / (2.0 * Pi)));
        isFar = isFar || std::abs(to.second[i]) > 1;
      }
      const double along = length + (q - p).norm();
      const auto found = this->Length.find(to);
      if (!isFar && (found == this->Length.end() || along < found->second))
      {
        this->Length[to] = along;
        this->Before[to] = state;
        this->Open.emplace(along, to);
      }
    }
  }

  const Surface& Mesh;
  const std::vector<Axis>& Axes;
  std::vector<std::vector<Index>> Neighbors;
  std::map<State, double> Length; // mm
  std::map<State, State> Before;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> Open;
};
}

Surface Tube(const Loop& loop, double radius, Index sides, double flatness)
{
  const std::vector<Vector3> tangents = Tangents(loop);
  const std::vector<Vector3> normals = FrameNormals(tangents);
  const auto count = static_cast<Index>(loop.size());
  Surface tube;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Vector3 across = flatness * tangents[i].cross(normals[i]);
    for (Index j = 0; j < sides; ++j)
    {
      const double angle = 2.0 * Pi * j / sides;
      tube.Points.emplace_back(
        loop[i] + radius * (std::cos(angle) * normals[i] + std::sin(angle) * across));
    }
  }
  for (Index i = 0; i < count; ++i)
  {
    const Index next = (i + 1) % count * sides;
    for (Index j = 0; j < sides; ++j)
    {
      const Index up = (j + 1) % sides;
      AddQuadrilateral(tube, i * sides + j, i * sides + up, next + up, next + j);
    }
  }
  return SignedVolume(tube) < 0.0 ? TurnedInsideOut(tube) : tube;
}

//------------------------------------------------------------------------------
Surface Bridged(
  const Surface& first, const Surface& second, const Vector3& from, const Vector3& to, double rise)
{
  constexpr Index steps = 12;
  Surface both = Together(first, second);
  const auto offset = static_cast<Index>(first.Points.size());
  const Triangle a = first.Triangles[BruteNearest(first, from).Triangle];
  Triangle b = second.Triangles[BruteNearest(second, to).Triangle];
  both.Triangles.erase(both.Triangles.begin() +
    static_cast<std::ptrdiff_t>(first.Triangles.size()) + BruteNearest(second, to).Triangle);
  both.Triangles.erase(both.Triangles.begin() + BruteNearest(first, from).Triangle);
  const auto normal = [](const Surface& s, const Triangle& t) -> Vector3
  { return (s.Points[t[1]] - s.Points[t[0]]).cross(s.Points[t[2]] - s.Points[t[0]]).normalized(); };
  const Vector3 up = rise * normal(first, a);
  const Vector3 down = rise * normal(second, b);
  std::swap(b[1], b[2]); // seen from the bridge, the rim runs the other way
  Triangle last = a;
  for (Index step = 1; step <= steps; ++step)
  {
    Triangle next = { offset + b[0], offset + b[1], offset + b[2] };
    for (std::size_t k = 0; step < steps && k < 3; ++k)
    {
      const double t = static_cast<double>(step) / steps;
      const double s = 1.0 - t;
      const Vector3& p = first.Points[a[k]];
      const Vector3& q = second.Points[b[k]];
      next[k] = static_cast<Index>(both.Points.size());
      both.Points.emplace_back(
        s * s * s * p + 3.0 * s * s * t * (p + up) + 3.0 * s * t * t * (q + down) + t * t * t * q);
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t after = (k + 1) % 3;
      AddQuadrilateral(both, last[k], last[after], next[after], next[k]);
    }
    last = next;
  }
  return both;
}

//------------------------------------------------------------------------------
Loop LoopAround(const Surface& surface, Index start, const std::vector<Axis>& axes)
{
  return LoopSearch(surface, axes).Find(start);
}

//------------------------------------------------------------------------------
double LinkingNumber(const Loop& a, const Loop& b)
{
  double sum = 0.0; // steradians
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    const Vector3& nextOfA = a[(i + 1) % a.size()];
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      const Vector3& nextOfB = b[(j + 1) % b.size()];
      const std::array<Vector3, 4> corners = { b[j] - a[i], nextOfB - a[i], nextOfB - nextOfA,
        b[j] - nextOfA };
      sum += SolidAngle(corners[0], corners[1], corners[2]) +
        SolidAngle(corners[0], corners[2], corners[3]);
    }
  }
  return sum / (4.0 * Pi);
}

//------------------------------------------------------------------------------
bool RayMeets(const Vector3& from, const Vector3& direction, const Surface& surface)
{
  return std::any_of(surface.Triangles.begin(), surface.Triangles.end(),
    [&](const Triangle& t)
    {
      const Vector3 a = surface.Points[t[0]] - from;
      const Vector3 b = surface.Points[t[1]] - from;
      const Vector3 c = surface.Points[t[2]] - from;
      const double ab = direction.dot(a.cross(b));
      const double bc = direction.dot(b.cross(c));
      const double ca = direction.dot(c.cross(a));
      const bool isInside =
        (ab >= 0.0 && bc >= 0.0 && ca >= 0.0) || (ab <= 0.0 && bc <= 0.0 && ca <= 0.0);
      const Vector3 normal = (b - a).cross(c - a);
      return isInside && a.dot(normal) * direction.dot(normal) > 0.0;
    });
}
}
