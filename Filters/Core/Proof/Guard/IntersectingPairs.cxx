// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "IntersectingPairs.h"

#include "Base/Parallel.h"
#include "Geometry/BoundingTree.h"
#include "TrianglePair.h"

#include <algorithm>
#include <vector>

namespace bonedecimate
{
namespace
{
/// Rounding of a radius, as a ratio.
constexpr double RadiusMargin = 1e-9;

struct BoxOfCorners
{
  explicit BoxOfCorners(const TriangleCorners& corners)
    : Low(corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]))
    , High(corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]))
  {
  }

  bool Meets(const BoxOfCorners& other) const
  {
    return (this->Low.array() <= other.High.array()).all() &&
      (other.Low.array() <= this->High.array()).all();
  }

  Vector3 Low, High; // mm
};

TriangleCorners CornersOf(const Surface& surface, Index triangle)
{
  const Triangle& ids = surface.Triangles[triangle];
  return { surface.Points[ids[0]], surface.Points[ids[1]], surface.Points[ids[2]] };
}

/// Pairs with triangles of larger ids.
std::int64_t CountPairsOf(Index triangle, const Surface& surface, const BoundingTree& tree)
{
  const PlaneTriangle whole(CornersOf(surface, triangle));
  const BoxOfCorners box(whole.Corners);
  const Vector3 center = box.Low + 0.5 * (box.High - box.Low);
  const double squaredRadius =
    (box.High - center).squaredNorm() * (1.0 + RadiusMargin) + 1e-300; // mm^2
  std::int64_t pairs = 0;
  tree.VisitNear(center, squaredRadius,
    [&](Index other)
    {
      if (other > triangle)
      {
        const TriangleCorners corners = CornersOf(surface, other);
        const bool isPair = box.Meets(BoxOfCorners(corners)) &&
          Meet(
            whole, surface.Triangles[triangle], PlaneTriangle(corners), surface.Triangles[other]);
        pairs += isPair ? 1 : 0;
      }
    });
  return pairs;
}
}

std::optional<std::int64_t> CountIntersectingPairs(
  const Surface& surface, int threads, const Monitor& monitor)
{
  const BoundingTree tree(surface, threads);
  std::vector<std::int64_t> parts(NumberOfChunks(surface.Triangles.size()), 0);
  const bool isWhole = ForEachChunk(surface.Triangles.size(), threads, monitor,
    [&](std::size_t chunk, std::size_t first, std::size_t last)
    {
      for (std::size_t triangle = first; triangle < last; ++triangle)
      {
        parts[chunk] += CountPairsOf(static_cast<Index>(triangle), surface, tree);
      }
    });
  std::int64_t pairs = 0;
  for (const std::int64_t part : parts)
  {
    pairs += part;
  }
  return isWhole ? std::optional<std::int64_t>(pairs) : std::nullopt;
}
}
