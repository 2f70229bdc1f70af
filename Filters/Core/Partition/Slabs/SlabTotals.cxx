// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SlabTotals.h"

#include "Mesh/Statistics.h"
#include "Mesh/TriangleShapes.h"
#include "Run/Output/ListLeftOut.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
/// mm^3, signed, of the tetrahedra between the triangles and the origin.
double SignedVolume(const Surface& surface)
{
  double volume = 0.0;
  for (const Triangle& c : surface.Triangles)
  {
    volume += Dot(surface.Points[c[0]], surface.Points[c[1]].cross(surface.Points[c[2]])) / 6.0;
  }
  return volume;
}
}

double MeanEdge(const Surface& surface)
{
  double sum = 0.0;
  double area = 0.0;
  for (const Triangle& c : surface.Triangles)
  {
    const Vector3& p = surface.Points[c[0]];
    const double twice = (surface.Points[c[1]] - p).cross(surface.Points[c[2]] - p).norm();
    sum += twice * std::sqrt(2.0 * twice / std::sqrt(3.0)); // the edge of an equilateral one
    area += twice;
  }
  return area > 0.0 ? sum / area : 0.0;
}

//------------------------------------------------------------------------------
Index SlabTotals::RootOf(Index component) const
{
  while (this->Parents[component] != component)
  {
    component = this->Parents[component];
  }
  return component;
}

//------------------------------------------------------------------------------
void SlabTotals::Add(const Slab& slab, const CleanSurface& clean,
  const std::vector<char>& isInLower, const std::vector<char>& isInUpper, int threads)
{
  const SurfaceStatistics statistics = Describe(clean.Surface, threads);
  this->Sum.Faces += statistics.Faces;
  this->Sum.Area += statistics.Area;
  this->Sum.Volume += SignedVolume(slab.Surface);
  AddShapes(statistics.Shape, this->Sum.Shape);
  this->Cleaning.TrianglesRead += clean.Statistics.TrianglesRead;
  this->Cleaning.PointsRead += clean.Statistics.PointsRead;
  this->Cleaning.MergedPoints += clean.Statistics.MergedPoints;
  this->Cleaning.UnusedPoints += clean.Statistics.UnusedPoints;
  this->Cleaning.DroppedTriangles += clean.Statistics.DroppedTriangles;
  if (clean.Statistics.DroppedTriangles > 0)
  {
    const std::vector<std::array<Vector3, 3>> dropped =
      ShapesOf(slab.Surface.Points, KeptPart(slab.Surface, clean).LeftOut, true);
    this->Dropped.insert(this->Dropped.end(), dropped.begin(), dropped.end());
  }

  const Components found = FindComponents(clean.Surface);
  const Index first = static_cast<Index>(this->Parents.size());
  for (Index i = 0; i < found.Count; ++i)
  {
    this->Parents.push_back(first + i);
  }
  std::map<Coordinates, Index> inPlane;
  for (std::size_t v = 0; v < clean.Surface.Points.size(); ++v)
  {
    const Index point = clean.InputPoint[v];
    const Vector3& p = slab.Surface.Points[point];
    const Coordinates key = { p[0], p[1], p[2] };
    const Index component = first + found.OfPoint[v];
    const auto below = isInLower[point] != 0 ? this->InPlane.find(key) : this->InPlane.end();
    if (below != this->InPlane.end())
    {
      const auto [low, high] =
        std::minmax({ this->RootOf(below->second), this->RootOf(component) });
      this->Parents[high] = low;
    }
    if (isInUpper[point] != 0)
    {
      inPlane.emplace(key, component);
    }
  }
  this->InPlane = std::move(inPlane);
}

//------------------------------------------------------------------------------
std::vector<LeftOutShape> SlabTotals::LeftOut() const
{
  const std::int64_t count = this->Cleaning.DroppedTriangles;
  return count > 0 ? std::vector<LeftOutShape>{ TrianglesWithoutArea(count, -1, this->Dropped) }
                   : std::vector<LeftOutShape>{};
}

//------------------------------------------------------------------------------
std::int64_t SlabTotals::NumberOfComponents() const
{
  std::int64_t count = 0;
  for (std::size_t i = 0; i < this->Parents.size(); ++i)
  {
    count += this->Parents[i] == static_cast<Index>(i) ? 1 : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
void SlabTotals::Write(Report& report) const
{
  report.Input = this->Sum;
  report.Input.Components = this->NumberOfComponents();
  report.Cleaning = this->Cleaning;
}
}
