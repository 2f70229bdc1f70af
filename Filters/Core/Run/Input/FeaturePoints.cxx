// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FeaturePoints.h"

#include "Geometry/TriangleGeometry.h"
#include "Mesh/Cleaning.h"
#include "Mesh/EdgeMatching.h"

namespace bonedecimate
{
namespace
{
/// The ends, as input points, of the edges of the cleaned surface for which isLine(triangle,
/// corner, twin) holds. The twin is None or OddEdge for an edge without one.
template <typename IsLine>
std::vector<bool> EndsOf(
  const Surface& surface, const CleanSurface& clean, int threads, IsLine isLine)
{
  std::vector<bool> found(surface.Points.size(), false);
  if (clean.Status != InputStatus::Good)
  {
    return found;
  }
  const std::vector<Triangle>& triangles = clean.Surface.Triangles;
  const EdgeMatching edges(triangles, clean.Surface.Points.size(), threads);
  std::vector<bool> isOnLine(clean.Surface.Points.size(), false);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (isLine(t, edges.Twins()[4 * t + k]))
      {
        isOnLine[static_cast<std::size_t>(triangles[t][k])] = true;
        isOnLine[static_cast<std::size_t>(triangles[t][(k + 1) % 3])] = true;
      }
    }
  }
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const Index point = clean.PointOfInput[i];
    found[i] = point != None && isOnLine[static_cast<std::size_t>(point)];
  }
  return found;
}
}

std::vector<bool> PointsOnBoundaries(const Surface& surface, int threads)
{
  return EndsOf(surface, Clean(surface, true, threads), threads,
    [](std::size_t, Index twin) { return twin == None; });
}

//------------------------------------------------------------------------------
std::vector<bool> PointsOnFolds(const Surface& surface, double cosine, int threads)
{
  const CleanSurface clean = Clean(surface, true, threads);
  const auto normal = [&clean](std::size_t triangle)
  {
    const Triangle& c = clean.Surface.Triangles[triangle];
    const std::vector<Vector3>& p = clean.Surface.Points;
    return AreaVector(p[c[0]], p[c[1]], p[c[2]]);
  };
  return EndsOf(surface, clean, threads,
    [&](std::size_t triangle, Index twin)
    {
      if (twin < 0)
      {
        return twin == OddEdge;
      }
      const Vector3 here = normal(triangle);
      const Vector3 there = normal(static_cast<std::size_t>(twin) / 4);
      return Dot(here, there) < cosine * here.norm() * there.norm();
    });
}
}
