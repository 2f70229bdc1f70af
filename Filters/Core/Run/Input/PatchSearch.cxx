// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatchSearch.h"

#include "Base/Parallel.h"
#include "Geometry/BoundingTree.h"
#include "Mesh/SurfaceAssembly.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace bonedecimate
{
namespace
{
/// How far inside of its patch a point is searched, as a fraction of the distance to the middle of
/// its triangles.
constexpr double FromVertex = 0.25;

/// The pair of labels of a triangle and the name of its label, as far as there are any.
using Key = std::pair<BoundaryLabels, std::string>;

Key KeyOf(const SurfaceOfPatches& surface, std::size_t triangle)
{
  const auto input = static_cast<std::size_t>(surface.Clean.InputTriangle[triangle]);
  Key key = { { None, None }, {} };
  if (surface.Map != nullptr && !surface.Map->OfTriangle.empty())
  {
    key.first = surface.Map->OfTriangle[input];
  }
  if (surface.OfInput != nullptr)
  {
    key.second =
      surface.OfInput->Names[static_cast<std::size_t>(surface.OfInput->OfTriangle[input])];
  }
  return key;
}

/// The triangles of one key.
struct Group
{
  Surface Triangles;
  std::vector<Index> Ids;
  BoundingTree Tree = BoundingTree({});
};

using Groups = std::map<Key, Group>;

Groups GroupsOf(const SurfaceOfPatches& surface, int threads)
{
  Groups groups;
  for (std::size_t t = 0; t < surface.Clean.Surface.Triangles.size(); ++t)
  {
    Group& group = groups[KeyOf(surface, t)];
    group.Triangles.Triangles.push_back(surface.Clean.Surface.Triangles[t]);
    group.Ids.push_back(static_cast<Index>(t));
  }
  for (auto& [key, group] : groups)
  {
    for (const Index point :
      NumberVertices(surface.Clean.Surface.Points.size(), group.Triangles.Triangles, 1))
    {
      group.Triangles.Points.push_back(surface.Clean.Surface.Points[point]);
    }
    group.Tree = BoundingTree(group.Triangles, threads);
    group.Triangles = {};
  }
  return groups;
}

/// The group of the triangles at each vertex; null if there is none of their key.
std::vector<const Group*> GroupOfVertices(const SurfaceOfPatches& surface, const Groups& groups)
{
  std::vector<const Group*> ofVertex(surface.Clean.Surface.Points.size(), nullptr);
  for (std::size_t t = 0; t < surface.Clean.Surface.Triangles.size(); ++t)
  {
    const auto found = groups.find(KeyOf(surface, t));
    for (const Index corner : surface.Clean.Surface.Triangles[t])
    {
      ofVertex[corner] = found == groups.end() ? nullptr : &found->second;
    }
  }
  return ofVertex;
}

/// The points, but duplicates inside of their patch, because patches meet at the points themselves.
std::vector<Vector3> InsideOfPatches(const CleanSurface& clean, double farthest)
{
  std::vector<Vector3> points = clean.Surface.Points;
  const std::vector<Index>& originals = clean.ManifoldPatches.OriginalVertices;
  std::vector<char> isSplit(points.size(), 0);
  for (std::size_t v = 0; v < originals.size(); ++v)
  {
    if (originals[v] != static_cast<Index>(v))
    {
      isSplit[v] = isSplit[static_cast<std::size_t>(originals[v])] = 1;
    }
  }
  std::vector<Vector3> sums(originals.empty() ? 0 : points.size(), Vector3::Zero());
  std::vector<double> counts(sums.size(), 0.0);
  for (const Triangle& c : clean.Surface.Triangles)
  {
    const Vector3 middle =
      (clean.Surface.Points[c[0]] + clean.Surface.Points[c[1]] + clean.Surface.Points[c[2]]) / 3.0;
    for (std::size_t i = 0; i < 3 && !sums.empty(); ++i)
    {
      sums[c[i]] += middle;
      counts[c[i]] += 1.0;
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v)
  {
    if (isSplit[v] != 0 && counts[v] > 0.0)
    {
      const Vector3 step = FromVertex * (sums[v] / counts[v] - points[v]);
      points[v] += std::min(1.0, farthest / std::max(step.norm(), farthest)) * step;
    }
  }
  return points;
}

/// The nearest of all groups.
Index NearestOfAll(const Vector3& p, const Groups& groups)
{
  Index nearest = None;
  double least = 0.0; // squared
  for (const auto& [key, group] : groups)
  {
    const BoundingTree::Nearest found = group.Tree.FindNearest(p);
    if (nearest == None || found.Point.SquaredDistance < least)
    {
      nearest = group.Ids[static_cast<std::size_t>(found.Triangle)];
      least = found.Point.SquaredDistance;
    }
  }
  return nearest;
}
}

std::vector<Index> NearestInPatch(
  const SurfaceOfPatches& from, const SurfaceOfPatches& to, double farthest, int threads)
{
  const Groups groups = GroupsOf(to, threads);
  const std::vector<const Group*> ofVertex = GroupOfVertices(from, groups);
  const std::vector<Vector3> points = InsideOfPatches(from.Clean, farthest);
  std::vector<Index> nearest(points.size());
  ForEachId(points.size(), threads,
    [&](std::size_t i)
    {
      const Group* group = ofVertex[i];
      nearest[i] = group == nullptr
        ? NearestOfAll(points[i], groups)
        : group->Ids[static_cast<std::size_t>(group->Tree.FindNearest(points[i]).Triangle)];
    });
  return nearest;
}
}
