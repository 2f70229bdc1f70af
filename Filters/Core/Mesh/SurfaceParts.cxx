// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceParts.h"

#include "Geometry/TriangleGeometry.h"
#include "SplitMix.h"
#include "Statistics.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// The term of a half-edge in the sum of its part.
std::uint64_t TermOf(Index from, Index to)
{
  const auto [least, most] = std::minmax(from, to);
  const std::uint64_t mixed =
    SplitMix((static_cast<std::uint64_t>(least) << 32U) | static_cast<std::uint64_t>(most));
  return from < to ? mixed : std::uint64_t{ 0 } - mixed;
}

void Add(const std::array<Vector3, 3>& corners, double sign, PartExtent& extent)
{
  const Vector3 area = AreaVector(corners[0], corners[1], corners[2]);
  if (extent.Triangles++ == 0)
  {
    extent.Low = extent.High = corners[0];
  }
  extent.Area += area.norm();
  extent.Volume += sign * Dot(area, corners[0]) / 3.0;
  for (const Vector3& corner : corners)
  {
    extent.Low = extent.Low.cwiseMin(corner);
    extent.High = extent.High.cwiseMax(corner);
  }
}
}

SurfaceParts ComponentsAsParts(const Surface& surface)
{
  const Components components = FindComponents(surface);
  SurfaceParts parts;
  parts.Count = components.Count;
  parts.OfTriangle.reserve(surface.Triangles.size());
  for (const Triangle& c : surface.Triangles)
  {
    parts.OfTriangle.push_back({ components.OfPoint[c[0]], None });
  }
  return parts;
}

std::vector<PartExtent> MeasureParts(const std::vector<Vector3>& points,
  const std::vector<Triangle>& triangles, const SurfaceParts& parts)
{
  std::vector<PartExtent> extents(static_cast<std::size_t>(parts.Count));
  std::vector<std::uint64_t> sums(extents.size(), 0);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const Triangle& c = triangles[t];
    const std::uint64_t term = TermOf(c[0], c[1]) + TermOf(c[1], c[2]) + TermOf(c[2], c[0]);
    const auto& [front, back] = parts.OfTriangle[t];
    const std::array<Vector3, 3> corners = { points[c[0]], points[c[1]], points[c[2]] };
    if (front != None)
    {
      Add(corners, 1.0, extents[front]);
      sums[front] += term;
    }
    if (back != None)
    {
      Add(corners, -1.0, extents[back]);
      sums[back] -= term;
    }
  }
  std::transform(sums.begin(), sums.end(), extents.begin(), extents.begin(),
    [](std::uint64_t sum, PartExtent extent)
    {
      extent.IsClosed = sum == 0;
      return extent;
    });
  return extents;
}
}
