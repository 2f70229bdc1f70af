// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics.h"

#include "Base/DisjointSets.h"
#include "Base/Parallel.h"
#include "Geometry/TriangleGeometry.h"
#include "TriangleShapes.h"

#include <algorithm>

namespace bonedecimate
{
Components FindComponents(const Surface& surface, const std::vector<Index>& originals)
{
  DisjointSets<Index> sets(surface.Points.size());
  std::vector<char> used(surface.Points.size(), 0);
  for (const Triangle& c : surface.Triangles)
  {
    sets.Join(c[0], c[1]);
    sets.Join(c[0], c[2]);
    used[c[0]] = used[c[1]] = used[c[2]] = 1;
  }
  for (std::size_t p = 0; p < originals.size(); ++p)
  {
    sets.Join(static_cast<Index>(p), originals[p]);
  }
  Components components;
  components.OfPoint.assign(surface.Points.size(), None);
  for (std::size_t p = 0; p < sets.Size(); ++p)
  {
    const Index root = sets.Root(static_cast<Index>(p));
    if (used[p] != 0)
    {
      components.OfPoint[p] =
        root == static_cast<Index>(p) ? components.Count++ : components.OfPoint[root];
    }
  }
  return components;
}

namespace
{
struct Extent
{
  double Area = 0.0;   // mm^2
  double Volume = 0.0; // mm^3

  Extent& operator+=(const Extent& other)
  {
    this->Area += other.Area;
    this->Volume += other.Volume;
    return *this;
  }
};

Extent ExtentOf(const Surface& surface, std::size_t first, std::size_t last)
{
  Extent extent;
  for (std::size_t f = first; f < last; ++f)
  {
    const Triangle& c = surface.Triangles[f];
    const Vector3 areaVector =
      AreaVector(surface.Points[c[0]], surface.Points[c[1]], surface.Points[c[2]]);
    extent += { areaVector.norm(), Dot(areaVector, surface.Points[c[0]]) / 3.0 };
  }
  return extent;
}
}

SurfaceStatistics Describe(const Surface& surface, int threads)
{
  const Components components = FindComponents(surface);
  const std::int64_t points = std::count_if(components.OfPoint.begin(), components.OfPoint.end(),
    [](Index component) { return component != None; });
  const EdgeCounts edges =
    EdgeMatching(surface.Triangles, surface.Points.size(), threads).CountEdges();
  return Describe(surface, { points, components.Count, edges }, threads);
}

SurfaceStatistics Describe(const Surface& surface, const SurfaceCounts& counts, int threads)
{
  SurfaceStatistics statistics;
  statistics.Faces = static_cast<std::int64_t>(surface.Triangles.size());
  statistics.Points = counts.Points;
  statistics.Components = counts.Components;
  statistics.BoundaryEdges = counts.Edges.Boundary;
  statistics.NonManifoldEdges = counts.Edges.NonManifold;
  statistics.EulerNumber = counts.Points - counts.Edges.Edges + statistics.Faces;
  const Extent extent = SumOverBlocks(surface.Triangles.size(), threads,
    [&](std::size_t first, std::size_t last) { return ExtentOf(surface, first, last); });
  statistics.Area = extent.Area;
  statistics.Volume = extent.Volume;
  statistics.Shape = DescribeShapes(surface, threads);
  return statistics;
}
}
