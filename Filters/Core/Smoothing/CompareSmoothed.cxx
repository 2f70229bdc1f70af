// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Smoothing.h"

#include "Geometry/Angle.h"
#include "Geometry/TriangleGeometry.h"
#include "Mesh/EdgeMatching.h"
#include "Mesh/Statistics.h"
#include "Parallel.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
constexpr double DegreesOfRadian = 57.29577951308232;

struct Displacements
{
  double Squares = 0.0; // mm^2
  double Largest = 0.0; // mm^2

  Displacements& operator+=(const Displacements& other)
  {
    this->Squares += other.Squares;
    this->Largest = std::max(this->Largest, other.Largest);
    return *this;
  }
};

Displacements DisplacementsOf(
  const std::vector<Vector3>& before, const std::vector<Vector3>& after, int threads)
{
  return SumOverBlocks(before.size(), threads,
    [&](std::size_t first, std::size_t last)
    {
      Displacements part;
      for (std::size_t p = first; p < last; ++p)
      {
        const double squared = (after[p] - before[p]).squaredNorm();
        part += { squared, squared };
      }
      return part;
    });
}

std::vector<Vector3> AreaVectors(
  const std::vector<Vector3>& points, const std::vector<Triangle>& triangles, int threads)
{
  std::vector<Vector3> areas(triangles.size());
  ForEachId(triangles.size(), threads,
    [&](std::size_t t)
    {
      const Triangle& c = triangles[t];
      areas[t] = AreaVector(points[c[0]], points[c[1]], points[c[2]]);
    });
  return areas;
}

/// Degrees
double MeanAngle(
  const std::vector<Vector3>& areas, const std::vector<std::array<Index, 2>>& edges, int threads)
{
  const double sum = SumOverBlocks(edges.size(), threads,
    [&](std::size_t first, std::size_t last)
    {
      double part = 0.0;
      for (std::size_t e = first; e < last; ++e)
      {
        part += AngleBetween(areas[edges[e][0]], areas[edges[e][1]]);
      }
      return part;
    });
  return edges.empty() ? 0.0 : DegreesOfRadian * sum / static_cast<double>(edges.size());
}

double TotalOf(const std::vector<Vector3>& areas, int threads)
{
  return SumOverBlocks(areas.size(), threads,
    [&](std::size_t first, std::size_t last)
    {
      double part = 0.0;
      for (std::size_t t = first; t < last; ++t)
      {
        part += areas[t].norm();
      }
      return part;
    });
}

/// The closed components of a surface, and a point of each.
class ClosedComponents
{
public:
  ClosedComponents(const Surface& surface, int threads)
    : Parts(FindComponents(surface))
    , First(static_cast<std::size_t>(this->Parts.Count), None)
    , IsClosed(static_cast<std::size_t>(this->Parts.Count), true)
  {
    const EdgeMatching matching(surface.Triangles, surface.Points.size(), threads);
    for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
    {
      const Index part = this->Of(surface.Triangles[t]);
      this->First[part] = this->First[part] == None ? surface.Triangles[t][0] : this->First[part];
      for (std::size_t k = 0; k < 3; ++k)
      {
        this->IsClosed[part] = this->IsClosed[part] && matching.Twins()[4 * t + k] >= 0;
      }
    }
  }

  /// mm^3, of each component; 0 of those that are not closed.
  std::vector<double> Volumes(
    const std::vector<Vector3>& points, const std::vector<Triangle>& triangles) const
  {
    std::vector<double> volumes(this->First.size(), 0.0);
    for (const Triangle& c : triangles)
    {
      const Index part = this->Of(c);
      if (this->IsClosed[part])
      {
        const Vector3& from = points[this->First[part]];
        volumes[part] +=
          (points[c[0]] - from).dot((points[c[1]] - from).cross(points[c[2]] - from)) / 6.0;
      }
    }
    return volumes;
  }

private:
  Index Of(const Triangle& corners) const { return this->Parts.OfPoint[corners[0]]; }

  Components Parts;
  std::vector<Index> First;
  std::vector<bool> IsClosed;
};

void CompareVolumes(
  const Surface& before, const std::vector<Vector3>& after, int threads, SmoothingFigures& figures)
{
  const ClosedComponents parts(before, threads);
  const std::vector<double> volumesBefore = parts.Volumes(before.Points, before.Triangles);
  const std::vector<double> volumesAfter = parts.Volumes(after, before.Triangles);
  for (std::size_t i = 0; i < volumesBefore.size(); ++i)
  {
    figures.VolumeBefore += volumesBefore[i];
    figures.VolumeAfter += volumesAfter[i];
    const double change = volumesBefore[i] != 0.0 ? volumesAfter[i] / volumesBefore[i] - 1.0 : 0.0;
    if (std::abs(change) > std::abs(figures.LargestVolumeChange))
    {
      figures.LargestVolumeChange = change;
    }
  }
}
}

SmoothingFigures CompareSmoothed(const Surface& before, const std::vector<Vector3>& after,
  const std::vector<std::array<Index, 2>>& smoothEdges, int threads)
{
  SmoothingFigures figures;
  const Displacements moved = DisplacementsOf(before.Points, after, threads);
  figures.LargestDisplacement = std::sqrt(moved.Largest);
  figures.RmsDisplacement =
    before.Points.empty() ? 0.0 : std::sqrt(moved.Squares / static_cast<double>(after.size()));
  std::vector<Vector3> areas = AreaVectors(before.Points, before.Triangles, threads);
  figures.AreaBefore = TotalOf(areas, threads);
  figures.AngleBefore = MeanAngle(areas, smoothEdges, threads);
  areas = AreaVectors(after, before.Triangles, threads);
  figures.AreaAfter = TotalOf(areas, threads);
  figures.AngleAfter = MeanAngle(areas, smoothEdges, threads);
  CompareVolumes(before, after, threads, figures);
  return figures;
}
}
