// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfacePiece.h"

#include "Mesh/SurfaceAssembly.h"

#include <algorithm>

namespace bonedecimate
{
bool Reaches(const std::vector<Vector3>& points, const Triangle& corners, const Zone& zone)
{
  const std::array<Vector3, 3> triangle = { points[corners[0]], points[corners[1]],
    points[corners[2]] };
  return zone.MayReach(triangle, 0.0);
}

//------------------------------------------------------------------------------
std::vector<Index> RemoveUnusedPoints(Surface& surface)
{
  const std::vector<Index> used = NumberVertices(surface.Points.size(), surface.Triangles, 1);
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    surface.Points[i] = Vector3(surface.Points[used[i]]); // ascending, so that none is read later
  }
  surface.Points.resize(used.size());
  return used;
}

//------------------------------------------------------------------------------
SurfacePiece CutBetween(const SurfacePiece& surface, const Zone& zone)
{
  SurfacePiece cut;
  for (std::size_t t = 0; t < surface.Shape.Triangles.size(); ++t)
  {
    if (Reaches(surface.Shape.Points, surface.Shape.Triangles[t], zone))
    {
      cut.Shape.Triangles.push_back(surface.Shape.Triangles[t]);
      if (!surface.Labels.empty())
      {
        cut.Labels.push_back(surface.Labels[t]);
      }
    }
  }
  const std::vector<Index> used =
    NumberVertices(surface.Shape.Points.size(), cut.Shape.Triangles, 1);
  cut.Shape.Points.reserve(used.size());
  for (const Index point : used)
  {
    cut.Shape.Points.push_back(surface.Shape.Points[point]);
  }
  return cut;
}

//------------------------------------------------------------------------------
SurfacePiece Joined(SurfacePiece first, const SurfacePiece& second)
{
  const Index shift = static_cast<Index>(first.Shape.Points.size());
  first.Shape.Points.insert(
    first.Shape.Points.end(), second.Shape.Points.begin(), second.Shape.Points.end());
  for (const Triangle& c : second.Shape.Triangles)
  {
    first.Shape.Triangles.push_back({ c[0] + shift, c[1] + shift, c[2] + shift });
  }
  first.Labels.insert(first.Labels.end(), second.Labels.begin(), second.Labels.end());
  return first;
}

//------------------------------------------------------------------------------
double MaxCoordinateOf(const Surface& surface)
{
  double largest = 0.0;
  for (const Vector3& p : surface.Points)
  {
    largest = std::max(largest, p.cwiseAbs().maxCoeff());
  }
  return largest;
}
}
