// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BruteForce.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace bonedecimate::testsupport
{
namespace
{
using Long3 = Eigen::Matrix<long double, 3, 1>;
using Edge = std::pair<Index, Index>;

Edge Undirected(Index a, Index b)
{
  return { std::min(a, b), std::max(a, b) };
}

long double PointSegmentDistance(const Long3& p, const Long3& a, const Long3& b)
{
  const Long3 along = b - a;
  const long double length = along.norm();
  if (length == 0.0L)
  {
    return (p - a).norm();
  }
  const long double t = along.dot(p - a) / length;
  if (t <= 0.0L)
  {
    return (p - a).norm();
  }
  return t >= length ? (p - b).norm() : (p - a - along * (t / length)).norm();
}

struct Sides
{
  int Forward = 0;
  int Backward = 0;
};

std::map<Edge, Sides> CollectEdges(const Surface& surface)
{
  std::map<Edge, Sides> edges;
  for (const Triangle& t : surface.Triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Index from = t[i];
      const Index to = t[(i + 1) % 3];
      Sides& sides = edges[Undirected(from, to)];
      (from < to ? sides.Forward : sides.Backward) += 1;
    }
  }
  return edges;
}

Index Root(std::vector<Index>& parents, Index i)
{
  while (parents[i] != i)
  {
    parents[i] = parents[parents[i]];
    i = parents[i];
  }
  return i;
}

/// Whether the edges opposite to a point make one path or one cycle that meets no point twice.
bool IsOneFan(const std::vector<Edge>& opposite)
{
  std::map<Index, int> degrees;
  std::map<Index, Index> positions;
  for (const auto& [a, b] : opposite)
  {
    ++degrees[a];
    ++degrees[b];
  }
  for (const auto& entry : degrees)
  {
    if (entry.second > 2)
    {
      return false;
    }
    positions.emplace(entry.first, static_cast<Index>(positions.size()));
  }
  std::vector<Index> parents(positions.size());
  std::iota(parents.begin(), parents.end(), 0);
  std::size_t parts = parents.size();
  for (const auto& [a, b] : opposite)
  {
    const Index rootA = Root(parents, positions[a]);
    const Index rootB = Root(parents, positions[b]);
    parts -= rootA != rootB ? 1 : 0;
    parents[rootA] = rootB;
  }
  return parts == 1;
}

std::int64_t CountNonManifoldPoints(const Surface& surface)
{
  std::map<Index, std::vector<Edge>> opposite;
  for (const Triangle& t : surface.Triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      opposite[t[i]].emplace_back(t[(i + 1) % 3], t[(i + 2) % 3]);
    }
  }
  return std::count_if(
    opposite.begin(), opposite.end(), [](const auto& entry) { return !IsOneFan(entry.second); });
}
}

double PointTriangleDistance(const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c)
{
  const Long3 q = p.cast<long double>();
  const std::array<Long3, 3> corners = { a.cast<long double>(), b.cast<long double>(),
    c.cast<long double>() };
  const Long3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const long double length = normal.norm();
  bool inside = length > 0.0L;
  long double best = std::numeric_limits<long double>::infinity();
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Long3& from = corners[i];
    const Long3& to = corners[(i + 1) % 3];
    inside = inside && normal.dot((to - from).cross(q - from)) >= 0.0L;
    best = std::min(best, PointSegmentDistance(q, from, to));
  }
  if (inside)
  {
    best = std::min(best, std::abs(normal.dot(q - corners[0])) / length);
  }
  return static_cast<double>(best);
}

NearestTriangle BruteNearest(const Surface& surface, const Vector3& p)
{
  NearestTriangle best = { None, std::numeric_limits<double>::infinity() };
  for (std::size_t i = 0; i < surface.Triangles.size(); ++i)
  {
    const Triangle& t = surface.Triangles[i];
    const double distance =
      PointTriangleDistance(p, surface.Points[t[0]], surface.Points[t[1]], surface.Points[t[2]]);
    if (distance < best.Distance)
    {
      best = { static_cast<Index>(i), distance };
    }
  }
  return best;
}

Index BruteNearestPoint(const Surface& surface, const Vector3& p)
{
  Index best = None;
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& t : surface.Triangles)
  {
    for (const Index i : t)
    {
      const double squared = (surface.Points[i] - p).squaredNorm();
      if (squared < least || (squared == least && i < best))
      {
        best = i;
        least = squared;
      }
    }
  }
  return best;
}

bool Topology::operator==(const Topology& other) const
{
  return this->Points == other.Points && this->Edges == other.Edges && this->Faces == other.Faces &&
    this->Components == other.Components && this->BoundaryEdges == other.BoundaryEdges &&
    this->NonManifoldEdges == other.NonManifoldEdges &&
    this->InconsistentEdges == other.InconsistentEdges &&
    this->NonManifoldPoints == other.NonManifoldPoints && this->EulerNumber == other.EulerNumber;
}

Topology CountTopology(const Surface& surface)
{
  Topology found;
  std::set<Index> used;
  for (const Triangle& t : surface.Triangles)
  {
    used.insert(t.begin(), t.end());
  }
  const std::map<Edge, Sides> edges = CollectEdges(surface);
  for (const auto& entry : edges)
  {
    const int faces = entry.second.Forward + entry.second.Backward;
    found.BoundaryEdges += faces == 1 ? 1 : 0;
    found.NonManifoldEdges += faces > 2 ? 1 : 0;
    found.InconsistentEdges += faces == 2 && entry.second.Forward != 1 ? 1 : 0;
  }
  found.Points = static_cast<std::int64_t>(used.size());
  found.Edges = static_cast<std::int64_t>(edges.size());
  found.Faces = static_cast<std::int64_t>(surface.Triangles.size());
  found.EulerNumber = found.Points - found.Edges + found.Faces;
  const std::vector<Index> components = ComponentOfTriangles(surface);
  found.Components =
    components.empty() ? 0 : *std::max_element(components.begin(), components.end()) + 1;
  found.NonManifoldPoints = CountNonManifoldPoints(surface);
  return found;
}

std::vector<Index> ComponentOfTriangles(const Surface& surface)
{
  std::vector<Index> parents(surface.Points.size());
  std::iota(parents.begin(), parents.end(), 0);
  for (const Triangle& t : surface.Triangles)
  {
    parents[Root(parents, t[1])] = Root(parents, t[0]);
    parents[Root(parents, t[2])] = Root(parents, t[0]);
  }
  std::map<Index, Index> numbers;
  std::vector<Index> components;
  for (const Triangle& t : surface.Triangles)
  {
    const auto next = static_cast<Index>(numbers.size());
    components.push_back(numbers.emplace(Root(parents, t[0]), next).first->second);
  }
  return components;
}

std::vector<Surface> SplitComponents(const Surface& surface)
{
  const std::vector<Index> components = ComponentOfTriangles(surface);
  std::vector<Surface> parts;
  for (std::size_t i = 0; i < components.size(); ++i)
  {
    if (static_cast<std::size_t>(components[i]) == parts.size())
    {
      parts.push_back({ surface.Points, {} });
    }
    parts[components[i]].Triangles.push_back(surface.Triangles[i]);
  }
  return parts;
}

double SignedVolume(const Surface& surface)
{
  long double volume = 0.0L;
  for (const Triangle& t : surface.Triangles)
  {
    const Long3 a = surface.Points[t[0]].cast<long double>();
    const Long3 b = surface.Points[t[1]].cast<long double>();
    const Long3 c = surface.Points[t[2]].cast<long double>();
    volume += a.dot(b.cross(c)) / 6.0L;
  }
  return static_cast<double>(volume);
}

double TotalArea(const Surface& surface)
{
  long double area = 0.0L;
  for (const Triangle& t : surface.Triangles)
  {
    const Long3 a = surface.Points[t[0]].cast<long double>();
    const Long3 ab = surface.Points[t[1]].cast<long double>() - a;
    const Long3 ac = surface.Points[t[2]].cast<long double>() - a;
    area += 0.5L * ab.cross(ac).norm();
  }
  return static_cast<double>(area);
}

std::vector<std::pair<Index, Index>> BoundaryEdges(const Surface& surface)
{
  std::vector<Edge> boundary;
  for (const auto& [edge, sides] : CollectEdges(surface))
  {
    if (sides.Forward + sides.Backward == 1)
    {
      boundary.push_back(sides.Forward == 1 ? edge : Edge{ edge.second, edge.first });
    }
  }
  return boundary;
}

std::vector<std::int64_t> BoundaryLoopLengths(const Surface& surface)
{
  std::map<Index, Index> next;
  for (const auto& [from, to] : BoundaryEdges(surface))
  {
    next[from] = to;
  }
  std::vector<std::int64_t> lengths;
  while (!next.empty())
  {
    std::int64_t length = 0;
    for (auto at = next.begin(); at != next.end(); ++length)
    {
      const Index to = at->second;
      next.erase(at);
      at = next.find(to);
    }
    lengths.push_back(length);
  }
  return lengths;
}

std::int64_t RepeatedTriangles(const Surface& surface)
{
  std::set<Triangle> seen;
  for (Triangle t : surface.Triangles)
  {
    std::sort(t.begin(), t.end());
    seen.insert(t);
  }
  return static_cast<std::int64_t>(surface.Triangles.size() - seen.size());
}

std::string WhatIsWrong(const Surface& surface)
{
  const auto count = static_cast<Index>(surface.Points.size());
  std::vector<bool> used(surface.Points.size(), false);
  for (std::size_t i = 0; i < surface.Triangles.size(); ++i)
  {
    const Triangle& t = surface.Triangles[i];
    const bool inRange =
      std::all_of(t.begin(), t.end(), [&](Index point) { return point >= 0 && point < count; });
    if (!inRange || t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
    {
      return "triangle " + std::to_string(i) + " is not made of three points that exist";
    }
    used[t[0]] = used[t[1]] = used[t[2]] = true;
  }
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    if (!used[i] || !surface.Points[i].allFinite())
    {
      return "point " + std::to_string(i) + (used[i] ? " is not finite" : " is not used");
    }
  }
  return {};
}

bool SameInAnyOrder(const Surface& a, const Surface& b)
{
  using Coordinates = std::array<std::uint64_t, 3>;
  const auto coordinatesOf = [](const Vector3& p)
  {
    Coordinates coordinates;
    std::memcpy(coordinates.data(), p.data(), sizeof(coordinates));
    return coordinates;
  };
  const auto sorted = [&](const Surface& surface)
  {
    std::vector<std::array<Coordinates, 3>> triangles;
    for (const Triangle& t : surface.Triangles)
    {
      const std::vector<Vector3>& p = surface.Points;
      triangles.push_back(
        { coordinatesOf(p[t[0]]), coordinatesOf(p[t[1]]), coordinatesOf(p[t[2]]) });
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
  };
  return a.Points.size() == b.Points.size() && sorted(a) == sorted(b);
}

bool SameBytes(const Surface& a, const Surface& b)
{
  const std::size_t bytes = a.Points.size() * sizeof(Vector3);
  return a.Triangles == b.Triangles && a.Points.size() == b.Points.size() &&
    (bytes == 0 || std::memcmp(a.Points.data(), b.Points.data(), bytes) == 0);
}
}
