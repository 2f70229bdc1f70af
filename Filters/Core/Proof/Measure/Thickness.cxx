// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Thickness.h"

#include "AreaSamples.h"
#include "Base/Parallel.h"
#include "Geometry/TriangleGeometry.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{

/// Lengths of lines of one direction through a solid.
class Crossings
{
public:
  Crossings(const SolidSurface& surface, Index solid, const Vector3& direction)
    : Container(surface)
    , Solid(solid)
    , Direction(direction)
  {
  }

  /// mm, from a point to the first triangle through which the line leaves the solid; infinite:
  /// none.
  double LengthFrom(const Vector3& from) const
  {
    double length = Infinity;
    this->Container.Tree.VisitAlong(from, this->Direction, length,
      [&](Index triangle)
      {
        if (this->Outwards(triangle) > 0.0)
        {
          length = std::min(length, this->DistanceTo(triangle, from));
        }
      });
    return length;
  }

  /// The nearest point at which a line of the direction may enter the solid.
  Vector3 NearestEntry(const Vector3& to) const
  {
    double squared = Infinity;
    Vector3 nearest = to;
    this->Container.Tree.VisitNear(to, squared,
      [&](Index triangle)
      {
        if (this->Outwards(triangle) < 0.0)
        {
          const auto [a, b, c] = this->CornersOf(triangle);
          const PointOnTriangle point = NearestOnTriangle(to, a, b, c);
          nearest = point.SquaredDistance < squared ? point.Position : nearest;
          squared = std::min(squared, point.SquaredDistance);
        }
      });
    return nearest;
  }

private:
  std::array<Vector3, 3> CornersOf(Index triangle) const
  {
    const Triangle& c = this->Container.Surface.Triangles[triangle];
    const std::vector<Vector3>& points = this->Container.Surface.Points;
    return { points[c[0]], points[c[1]], points[c[2]] };
  }

  /// Positive where the direction leads out of the solid, negative where it leads into it, 0 where
  /// it does neither.
  double Outwards(Index triangle) const
  {
    const PartSides sides = this->Container.Sides != nullptr ? (*this->Container.Sides)[triangle]
                                                             : PartSides{ this->Solid, None };
    if (sides[0] != this->Solid && sides[1] != this->Solid)
    {
      return 0.0;
    }
    const auto [a, b, c] = this->CornersOf(triangle);
    const double along = Dot(AreaVector(a, b, c), this->Direction);
    return sides[0] == this->Solid ? along : -along;
  }

  /// mm along the direction; infinite if the line does not meet the triangle. The triangle is
  /// enlarged a little so that no line passes between two of them.
  double DistanceTo(Index triangle, const Vector3& from) const
  {
    constexpr double beside = -1e-9;
    const auto [a, b, c] = this->CornersOf(triangle);
    const Vector3 normal = (b - a).cross(c - a);
    const double along = Dot(normal, this->Direction);
    const double distance = Dot(normal, a - from) / along;
    const Vector3 p = from + distance * this->Direction - a;
    const double whole = normal.squaredNorm();
    const double u = Dot((b - a).cross(p), normal) / whole;
    const double v = Dot(p.cross(c - a), normal) / whole;
    const bool isHit = distance >= 0.0 && u >= beside && v >= beside && u + v <= 1.0 - beside;
    return isHit ? distance : Infinity;
  }

  const SolidSurface& Container;
  Index Solid;
  Vector3 Direction;
};

/// The value below which this fraction of the values lies.
double QuantileOf(std::vector<double>& values, double fraction)
{
  const auto at = values.begin() + std::lround(fraction * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

ThicknessFigures FiguresOf(std::vector<double> lengths)
{
  return lengths.empty() ? ThicknessFigures{}
                         : ThicknessFigures{ QuantileOf(lengths, 0.5), QuantileOf(lengths, 0.05) };
}
}

ThicknessChange CompareThickness(const SolidSurface& before, const SolidSurface& after,
  const std::vector<Triangle>& triangles, Index solid, std::size_t samples, int threads)
{
  const std::vector<Vector3>& points = after.Surface.Points;
  const AreaSamples placed(points, triangles, samples);
  std::vector<std::array<double, 2>> lengths(placed.Count());
  ForEachChunk(placed.Count(), threads, Monitor(),
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      placed.Visit(first, last,
        [&](std::size_t sample, std::size_t triangle, const Vector3& position)
        {
          const Triangle& c = triangles[triangle];
          const Vector3 inwards =
            -AreaVector(points[c[0]], points[c[1]], points[c[2]]).normalized();
          const Crossings inInput(before, solid, inwards);
          lengths[sample] = { inInput.LengthFrom(inInput.NearestEntry(position)),
            Crossings(after, solid, inwards).LengthFrom(position) };
        });
    });
  std::vector<double> ofBefore;
  std::vector<double> ofAfter;
  for (const auto& [lengthBefore, lengthAfter] : lengths)
  {
    if (std::isfinite(lengthBefore) && std::isfinite(lengthAfter))
    {
      ofBefore.push_back(lengthBefore);
      ofAfter.push_back(lengthAfter);
    }
  }
  return { FiguresOf(std::move(ofBefore)), FiguresOf(std::move(ofAfter)) };
}
}
