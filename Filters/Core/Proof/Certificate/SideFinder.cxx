// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SideFinder.h"

#include "Base/Parallel.h"
#include "Geometry/TriangleGeometry.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate::certificate
{
double AngleBetween(const Vector3& a, const Vector3& b)
{
  const double sine = a.cross(b).norm();
  const double cosine = Dot(a, b);
  const double length = std::sqrt(sine * sine + cosine * cosine);
  if (!(length > 0.0))
  {
    return 0.0;
  }
  // The tangent of half the angle, of a quarter, an eighth, a sixteenth: at most tan(pi / 16), or a
  // half for the first.
  const bool isObtuse = cosine < 0.0;
  double tangent = isObtuse ? (length + cosine) / sine : sine / (length + cosine);
  tangent = sine > 0.0 ? tangent : 0.0;
  for (int i = 0; i < 3; ++i)
  {
    tangent /= 1.0 + std::sqrt(1.0 + tangent * tangent);
  }
  const double square = tangent * tangent;
  const double sixteenth =
    tangent * (1.0 - square * (1.0 / 3.0 - square * (0.2 - square * (1.0 / 7.0 - square / 9.0))));
  constexpr double pi = 3.14159265358979324;
  return isObtuse ? pi - 16.0 * sixteenth : 16.0 * sixteenth;
}

//------------------------------------------------------------------------------
SideFinder::SideFinder(const Simplices& surface)
  : Surface(surface)
  , Sides(*surface.Sides)
{
}

//------------------------------------------------------------------------------
std::array<Vector3, 3> SideFinder::CornersOf(Index triangle) const
{
  const Triangle& corners = this->Surface.Corners[triangle];
  const std::vector<Vector3>& points = this->Surface.Points;
  return { points[corners[0]], points[corners[1]], points[corners[2]] };
}

//------------------------------------------------------------------------------
Vector3 SideFinder::UnitNormal(Index triangle) const
{
  const auto [a, b, c] = this->CornersOf(triangle);
  const Vector3 normal = AreaVector(a, b, c);
  const double length = normal.norm();
  return length > 0.0 ? Vector3(normal / length) : Vector3(0.0, 0.0, 0.0);
}

//------------------------------------------------------------------------------
int SideFinder::CornerAt(Index triangle, const Vector3& position) const
{
  const std::array<Vector3, 3> corners = this->CornersOf(triangle);
  return static_cast<int>(std::find(corners.begin(), corners.end(), position) - corners.begin());
}

//------------------------------------------------------------------------------
bool SideFinder::AddEdge(Index triangle, int side, Vector3& normal) const
{
  const Index other = this->Sides[triangle][side];
  if (other < 0)
  {
    return false;
  }
  normal = this->UnitNormal(triangle) + this->UnitNormal(other);
  return true;
}

//------------------------------------------------------------------------------
/// Sums up all triangles around the corner; false if they do not close.
bool SideFinder::AddFan(Index triangle, int corner, Vector3& normal) const
{
  const Vector3 tip = this->CornersOf(triangle)[corner];
  Index at = triangle;
  int here = corner;
  for (std::size_t i = 0; i < this->Sides.size(); ++i)
  {
    const std::array<Vector3, 3> corners = this->CornersOf(at);
    normal += AngleBetween(corners[(here + 1) % 3] - tip, corners[(here + 2) % 3] - tip) *
      this->UnitNormal(at);
    at = this->Sides[at][here];
    if (at < 0 || at == triangle)
    {
      return at == triangle;
    }
    here = this->CornerAt(at, tip);
  }
  return false;
}

//------------------------------------------------------------------------------
int SideFinder::SideOf(const Vector3& p, Index nearestTriangle) const
{
  const std::array<Vector3, 3> corners = this->CornersOf(nearestTriangle);
  const PointOnTriangle nearest = NearestOnTriangle(p, corners[0], corners[1], corners[2]);
  const std::array<double, 3>& weights = nearest.Weights;
  Vector3 normal = Vector3::Zero();
  bool isKnown = true;
  const auto one = std::find(weights.begin(), weights.end(), 1.0);
  const auto none = std::find(weights.begin(), weights.end(), 0.0);
  if (one != weights.end())
  {
    isKnown = this->AddFan(nearestTriangle, static_cast<int>(one - weights.begin()), normal);
  }
  else if (none != weights.end()) // on the side that begins at the corner after that one
  {
    isKnown =
      this->AddEdge(nearestTriangle, static_cast<int>(none - weights.begin() + 1) % 3, normal);
  }
  else
  {
    normal = this->UnitNormal(nearestTriangle);
  }
  const double along = isKnown ? Dot(normal, p - nearest.Position) : 0.0;
  return along > 0.0 ? 1 : along < 0.0 ? -1 : 0;
}

//------------------------------------------------------------------------------
std::vector<signed char> FindSides(const std::vector<Vector3>& points,
  const std::vector<Index>& nearest, const Simplices& surface, int threads)
{
  const SideFinder finder(surface);
  std::vector<signed char> sides(points.size(), 0);
  ForEachId(points.size(), threads,
    [&](std::size_t i)
    {
      if (nearest[i] != None)
      {
        sides[i] = static_cast<signed char>(finder.SideOf(points[i], nearest[i]));
      }
    });
  return sides;
}
}
