// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Smoothing.h"

#include "Base/Parallel.h"
#include "Geometry/Angle.h"
#include "Geometry/TriangleGeometry.h"
#include "Mesh/SurfaceParts.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
struct Displacements
{
  double Squares = 0.0; // mm^2
  double Max = 0.0;     // mm^2

  Displacements& operator+=(const Displacements& other)
  {
    this->Squares += other.Squares;
    this->Max = std::max(this->Max, other.Max);
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
  return edges.empty() ? 0.0 : DegreesPerRadian * sum / static_cast<double>(edges.size());
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

/// Sums over the closed components.
void CompareVolumes(
  const Surface& before, const std::vector<Vector3>& after, SmoothingFigures& figures)
{
  const SurfaceParts parts = ComponentsAsParts(before);
  const std::vector<PartExtent> first = MeasureParts(before.Points, before.Triangles, parts);
  const std::vector<PartExtent> last = MeasureParts(after, before.Triangles, parts);
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    figures.VolumeBefore += first[i].IsClosed ? first[i].Volume : 0.0;
    figures.VolumeAfter += first[i].IsClosed ? last[i].Volume : 0.0;
  }
}
}

SmoothingFigures CompareSmoothed(const Surface& before, const std::vector<Vector3>& after,
  const std::vector<std::array<Index, 2>>& smoothEdges, int threads)
{
  SmoothingFigures figures;
  const Displacements moved = DisplacementsOf(before.Points, after, threads);
  figures.MaxDisplacement = std::sqrt(moved.Max);
  figures.RmsDisplacement =
    before.Points.empty() ? 0.0 : std::sqrt(moved.Squares / static_cast<double>(after.size()));
  std::vector<Vector3> areas = AreaVectors(before.Points, before.Triangles, threads);
  figures.AreaBefore = TotalOf(areas, threads);
  figures.AngleBefore = MeanAngle(areas, smoothEdges, threads);
  areas = AreaVectors(after, before.Triangles, threads);
  figures.AreaAfter = TotalOf(areas, threads);
  figures.AngleAfter = MeanAngle(areas, smoothEdges, threads);
  CompareVolumes(before, after, figures);
  return figures;
}
}
