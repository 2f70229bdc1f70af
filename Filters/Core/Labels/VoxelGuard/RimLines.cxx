// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RimLines.h"

#include <cmath>
#include <utility>

namespace bonedecimate
{
namespace
{
using Plane = std::array<double, 2>; // steps

/// The parameters between which a segment from a to b is nearer to the origin than the margin;
/// first > second if there is no such part.
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

double InSteps(std::int64_t units)
{
  return static_cast<double>(units) / static_cast<double>(UnitsOfVoxel);
}

/// The heights of a part of a line.
struct HeightRange
{
  double Low;
  double High;
};

/// Adds the edges along the axis that meet the range.
void AddEdges(const GridEdge& first, const HeightRange& range, const CenterLattice& lattice,
  std::vector<GridEdge>& edges)
{
  const auto floorOf = [&](double height)
  {
    return lattice.IsEven(first.Axis)
      ? static_cast<std::int64_t>(std::floor(height))
      : lattice.AtOrBelow(first.Axis,
          static_cast<std::int64_t>(std::floor(height * static_cast<double>(UnitsOfVoxel))));
  };
  for (std::int64_t below = floorOf(range.Low); below <= floorOf(range.High); ++below)
  {
    edges.push_back(first);
    edges.back().From[first.Axis] = below;
  }
}
}

void AddEdgesNear(const FixedPoint& from, const FixedPoint& to, double margin,
  const CenterLattice& lattice, std::vector<GridEdge>& edges)
{
  FixedBox box(from);
  box.Add(to);
  box.Grow(static_cast<std::int64_t>(std::ceil(margin * static_cast<double>(UnitsOfVoxel))));
  for (std::size_t r = 0; r < 3; ++r)
  {
    const std::size_t s = (r + 1) % 3;
    const std::size_t t = (r + 2) % 3;
    for (std::int64_t i = lattice.AtOrAbove(s, box.Low[s]); i <= lattice.AtOrBelow(s, box.High[s]);
         ++i)
    {
      const std::int64_t atS = lattice.Coordinate(s, i);
      for (std::int64_t j = lattice.AtOrAbove(t, box.Low[t]);
           j <= lattice.AtOrBelow(t, box.High[t]); ++j)
      {
        const std::int64_t atT = lattice.Coordinate(t, j);
        const auto [first, last] = PartNear({ InSteps(from[s] - atS), InSteps(from[t] - atT) },
          { InSteps(to[s] - atS), InSteps(to[t] - atT) }, margin);
        if (first > last)
        {
          continue;
        }
        const double height = InSteps(from[r]);
        const double rise = InSteps(to[r]) - height;
        const auto [low, high] = std::minmax({ height + first * rise, height + last * rise });
        GridEdge edge = { r, {} };
        edge.From[s] = i;
        edge.From[t] = j;
        AddEdges(edge, { low, high }, lattice, edges);
      }
    }
  }
}
}
