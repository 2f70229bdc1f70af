// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics.h"

#include "EdgeMatching.h"
#include "Geometry/TriangleGeometry.h"

#include <numeric>

namespace bonedecimate
{
namespace
{
Index Root(std::vector<Index>& parent, Index v)
{
  while (parent[v] != v)
  {
    parent[v] = parent[parent[v]];
    v = parent[v];
  }
  return v;
}

/// The root of a set is its least member.
void Join(std::vector<Index>& parent, Index a, Index b)
{
  a = Root(parent, a);
  b = Root(parent, b);
  parent[std::max(a, b)] = std::min(a, b);
}
}

Components FindComponents(const Surface& surface)
{
  std::vector<Index> parent(surface.Points.size());
  std::iota(parent.begin(), parent.end(), 0);
  std::vector<char> used(surface.Points.size(), 0);
  for (const Triangle& c : surface.Triangles)
  {
    Join(parent, c[0], c[1]);
    Join(parent, c[0], c[2]);
    used[c[0]] = used[c[1]] = used[c[2]] = 1;
  }
  Components components;
  components.OfPoint.assign(surface.Points.size(), None);
  for (std::size_t p = 0; p < parent.size(); ++p)
  {
    const Index root = Root(parent, static_cast<Index>(p));
    if (used[p] != 0)
    {
      components.OfPoint[p] =
        root == static_cast<Index>(p) ? components.Count++ : components.OfPoint[root];
    }
  }
  return components;
}

SurfaceStatistics Describe(const Surface& surface, int threads)
{
  SurfaceStatistics statistics;
  statistics.Faces = static_cast<std::int64_t>(surface.Triangles.size());
  const Components components = FindComponents(surface);
  statistics.Components = components.Count;
  for (const Index component : components.OfPoint)
  {
    statistics.Points += component != None ? 1 : 0;
  }
  const EdgeCounts edges =
    EdgeMatching(surface.Triangles, surface.Points.size(), threads).CountEdges();
  statistics.BoundaryEdges = edges.Border;
  statistics.NonManifoldEdges = edges.NonManifold;
  statistics.EulerNumber = statistics.Points - edges.Edges + statistics.Faces;
  for (const Triangle& c : surface.Triangles)
  {
    const Vector3 areaVector =
      AreaVector(surface.Points[c[0]], surface.Points[c[1]], surface.Points[c[2]]);
    statistics.Area += areaVector.norm();
    statistics.Volume += areaVector.dot(surface.Points[c[0]]) / 3.0;
  }
  return statistics;
}
}
