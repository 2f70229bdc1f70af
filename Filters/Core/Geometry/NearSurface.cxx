// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NearSurface.h"

#include "Base/Parallel.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
/// Pieces smaller than this fraction of the distance are not cut.
constexpr double MinRadius = 0.25;
/// Rounding in the search.
constexpr double SlackOfReach = 1.0 + 1e-9;

bool AreUsable(const Surface& surface, const Triangle& corners)
{
  return std::all_of(corners.begin(), corners.end(),
    [&](Index v)
    {
      return v >= 0 && static_cast<std::size_t>(v) < surface.Points.size() &&
        IsUsable(surface.Points[v]);
    });
}
}

//------------------------------------------------------------------------------
Surface UsableTriangles(const Surface& surface)
{
  Surface usable = { surface.Points, {} };
  std::copy_if(surface.Triangles.begin(), surface.Triangles.end(),
    std::back_inserter(usable.Triangles),
    [&](const Triangle& corners) { return AreUsable(surface, corners); });
  return usable;
}

//------------------------------------------------------------------------------
bool MayComeNear(
  const BoundingTree& surface, const std::array<Vector3, 3>& corners, double distance)
{
  const auto& [a, b, c] = corners;
  const Vector3 middle = (a + b + c) / 3.0;
  const double radius = std::sqrt(std::max(
    { (a - middle).squaredNorm(), (b - middle).squaredNorm(), (c - middle).squaredNorm() }));
  const double reach = SlackOfReach * (distance + radius);
  const BoundingTree::Nearest nearest = surface.FindNearestWithin(middle, reach * reach);
  if (nearest.Triangle == None)
  {
    return false;
  }
  if (nearest.Point.SquaredDistance <= distance * distance || radius <= MinRadius * distance)
  {
    return true;
  }
  const Vector3 ab = 0.5 * (a + b);
  const Vector3 bc = 0.5 * (b + c);
  const Vector3 ca = 0.5 * (c + a);
  return MayComeNear(surface, { ab, bc, ca }, distance) ||
    MayComeNear(surface, { a, ab, ca }, distance) ||
    MayComeNear(surface, { ab, b, bc }, distance) || MayComeNear(surface, { ca, bc, c }, distance);
}

//------------------------------------------------------------------------------
std::vector<char> TrianglesNear(
  const Surface& surface, const Surface& others, double distance, int threads)
{
  std::vector<char> are(surface.Triangles.size(), 0);
  const Surface usable = UsableTriangles(others);
  if (usable.Triangles.empty())
  {
    return are;
  }
  const BoundingTree tree(usable, threads);
  ForEachId(are.size(), threads,
    [&](std::size_t t)
    {
      const Triangle& c = surface.Triangles[t];
      if (AreUsable(surface, c))
      {
        are[t] = MayComeNear(tree,
                   { surface.Points[c[0]], surface.Points[c[1]], surface.Points[c[2]] }, distance)
          ? 1
          : 0;
      }
    });
  return are;
}
}
