// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RimLines.h"

#include <cmath>
#include <utility>

namespace bonedecimate
{
namespace
{
using Plane = std::array<double, 2>; // voxels

/// The part of a segment from a to b, by its parameter, that is nearer to the origin than the margin; empty: first > second.
std::pair<double, double> PartNear(const Plane& a, const Plane& b, double margin)
{
  const Plane along = { b[0] - a[0], b[1] - a[1] };
  const double squared = along[0] * along[0] + along[1] * along[1];
  const double middle = squared == 0.0 ? 0.0 : -(a[0] * along[0] + a[1] * along[1]) / squared;
  const Plane nearest = { a[0] + middle * along[0], a[1] + middle * along[1] };
  const double rest = margin * margin - nearest[0] * nearest[0] - nearest[1] * nearest[1];
  if (rest <= 0.0)
  {
    return { 1.0, 0.0 };
  }
  const double half = squared == 0.0 ? 1.0 : std::sqrt(rest / squared);
  return { std::max(0.0, middle - half), std::min(1.0, middle + half) };
}

double InVoxels(std::int64_t coordinate, std::int64_t center)
{
  return static_cast<double>(coordinate - center * UnitsOfVoxel) /
    static_cast<double>(UnitsOfVoxel);
}
}

void AddEdgesNear(
  const FixedPoint& from, const FixedPoint& to, double margin, std::vector<GridEdge>& edges)
{
  FixedBox box(from);
  box.Add(to);
  box.Grow(static_cast<std::int64_t>(std::ceil(margin * static_cast<double>(UnitsOfVoxel))));
  for (std::size_t r = 0; r < 3; ++r)
  {
    const std::size_t s = (r + 1) % 3;
    const std::size_t t = (r + 2) % 3;
    for (std::int64_t i = CenterAtOrAbove(box.Low[s]); i <= CenterAtOrBelow(box.High[s]); ++i)
    {
      for (std::int64_t j = CenterAtOrAbove(box.Low[t]); j <= CenterAtOrBelow(box.High[t]); ++j)
      {
        const auto [first, last] = PartNear({ InVoxels(from[s], i), InVoxels(from[t], j) },
          { InVoxels(to[s], i), InVoxels(to[t], j) }, margin);
        if (first > last)
        {
          continue;
        }
        const double height = InVoxels(from[r], 0);
        const double rise = InVoxels(to[r], 0) - height;
        const auto [low, high] = std::minmax({ height + first * rise, height + last * rise });
        for (double below = std::floor(low); below <= high; ++below)
        {
          GridEdge edge = { r, {} };
          edge.From[r] = static_cast<std::int64_t>(below);
          edge.From[s] = i;
          edge.From[t] = j;
          edges.push_back(edge);
        }
      }
    }
  }
}
}
