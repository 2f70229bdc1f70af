// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlugDistance.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace bonedecimate
{
namespace
{
using PlugCorners = std::array<Vector3, 3>; // mm

/// A piece of a triangle.
struct PlugPiece
{
  PlugPiece(const PlugCorners& corners, const BoundingTree& surface)
    : Corners(corners)
  {
    const Vector3 center = (corners[0] + corners[1] + corners[2]) / 3.0;
    this->Distance = std::sqrt(surface.FindNearest(center).Point.SquaredDistance);
    for (const Vector3& corner : corners)
    {
      this->Radius = std::max(this->Radius, (corner - center).norm());
    }
  }

  double Bound() const { return this->Distance + this->Radius; }
  bool operator<(const PlugPiece& other) const { return this->Bound() < other.Bound(); }

  PlugCorners Corners;
  double Distance = 0.0; // mm, of the centroid
  double Radius = 0.0;   // mm, from there to the farthest corner
};
}

double MaxDistanceTo(const BoundingTree& surface, const Surface& triangles)
{
  constexpr double excess = 1.02;
  constexpr double least = 0.01;         // of the largest radius
  std::priority_queue<PlugPiece> pieces; // the largest bound first
  double lower = 0.0;                    // mm
  double radius = 0.0;                   // mm, the largest of a triangle
  for (const Triangle& corners : triangles.Triangles)
  {
    const PlugPiece piece({ triangles.Points[static_cast<std::size_t>(corners[0])],
                            triangles.Points[static_cast<std::size_t>(corners[1])],
                            triangles.Points[static_cast<std::size_t>(corners[2])] },
      surface);
    lower = std::max(lower, piece.Distance);
    radius = std::max(radius, piece.Radius);
    pieces.push(piece);
  }
  while (!pieces.empty() && pieces.top().Bound() > excess * lower + least * radius)
  {
    const PlugCorners c = pieces.top().Corners;
    pieces.pop();
    const Vector3 ab = 0.5 * (c[0] + c[1]);
    const Vector3 bc = 0.5 * (c[1] + c[2]);
    const Vector3 ca = 0.5 * (c[2] + c[0]);
    for (const PlugCorners& part : { PlugCorners{ c[0], ab, ca }, PlugCorners{ ab, c[1], bc },
           PlugCorners{ ca, bc, c[2] }, PlugCorners{ ab, bc, ca } })
    {
      const PlugPiece piece(part, surface);
      lower = std::max(lower, piece.Distance);
      pieces.push(piece);
    }
  }
  return pieces.empty() ? 0.0 : pieces.top().Bound();
}
}
