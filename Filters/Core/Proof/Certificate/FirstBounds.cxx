// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstBounds.h"

#include "Base/Parallel.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate::certificate
{
namespace
{
struct SourceBox
{
  Vector3 Low = Vector3::Constant(Infinity);
  Vector3 High = -Low;
};

SourceBox BoxOf(const Simplices& set)
{
  SourceBox box;
  for (std::size_t simplex = 0; simplex < set.Size(); ++simplex)
  {
    for (int i = 0; i < set.NumberOfCorners(simplex); ++i)
    {
      const Vector3& corner = set.Points[set.Corners[simplex][i]];
      box.Low = box.Low.cwiseMin(corner);
      box.High = box.High.cwiseMax(corner);
    }
  }
  return box;
}

/// The first corner of a simplex that is nearest to a position.
Vector3 NearestCorner(const Simplices& set, const Vector3& position)
{
  Vector3 nearest = set.Points[set.Corners[0][0]];
  double least = Infinity; // mm^2
  for (const Triangle& corners : set.Corners)
  {
    const double squared = (set.Points[corners[0]] - position).squaredNorm();
    nearest = squared < least ? set.Points[corners[0]] : nearest;
    least = std::min(least, squared);
  }
  return nearest;
}
}

//------------------------------------------------------------------------------
DistanceBounds FindFirstBounds(const Simplices& source, const Simplices& target, double slack)
{
  const SourceBox box = BoxOf(source);
  const Vector3 near = NearestCorner(target, box.Low + 0.5 * (box.High - box.Low));
  DistanceBounds bounds;
  bounds.Lower = 0.0;
  bounds.Upper = (box.High - near).cwiseAbs().cwiseMax((box.Low - near).cwiseAbs()).norm() + slack;
  bounds.Triangle = 0;
  bounds.Position = source.Points[source.Corners[0][0]];
  return bounds;
}

//------------------------------------------------------------------------------
double FindUpperOfParts(const Simplices& source, const Target& target, double slack, int threads)
{
  const auto upperOf = [&](std::size_t first, std::size_t last)
  {
    const Vector3& center = source.Points[source.Corners[first + (last - first) / 2][0]];
    double reach = 0.0; // mm^2
    for (std::size_t simplex = first; simplex < last; ++simplex)
    {
      for (int i = 0; i < source.NumberOfCorners(simplex); ++i)
      {
        const Vector3& corner = source.Points[source.Corners[simplex][i]];
        reach = std::max(reach, (corner - center).squaredNorm());
      }
    }
    return target.FindLeast(center, None).Value + std::sqrt(reach) + slack;
  };
  std::vector<double> uppers(NumberOfChunks(source.Size()));
  ForEachChunk(source.Size(), threads, Monitor(),
    [&](std::size_t chunk, std::size_t first, std::size_t last)
    { uppers[chunk] = upperOf(first, last); });
  return *std::max_element(uppers.begin(), uppers.end());
}
}
