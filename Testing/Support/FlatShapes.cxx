// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Angles.h"
#include "Shapes.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <utility>

namespace bonedecimate::testsupport
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

using Voxel = std::array<Index, 3>;
using IsInside = std::function<bool(const Voxel& voxel)>;

/// Marching tetrahedra at one half over a lattice whose values are 0 and 1: vertices are midpoints
/// of lattice edges and of diagonals, so that most triangles have coplanar neighbors. Closed and
/// manifold for any values (the cubes are cut along the diagonal from their least to their greatest
/// corner).
class BinarySurface
{
public:
  BinarySurface(IsInside isInside, const Vector3& spacing)
    : Inside(std::move(isInside))
    , Spacing(spacing)
  {
  }

  void AddCube(const Voxel& least)
  {
    Voxel axes = { 0, 1, 2 };
    do
    {
      std::array<Voxel, 4> corners = { least, least, least, least };
      for (std::size_t i = 1; i < 4; ++i)
      {
        corners[i] = corners[i - 1];
        ++corners[i][static_cast<std::size_t>(axes[i - 1])];
      }
      this->AddTetrahedron(corners);
    } while (std::next_permutation(axes.begin(), axes.end()));
  }

  Surface Built;

private:
  void AddTetrahedron(std::array<Voxel, 4> corners)
  {
    const auto isOutside = [this](const Voxel& voxel) { return !this->Inside(voxel); };
    const auto inside =
      std::stable_partition(corners.begin(), corners.end(), isOutside) - corners.begin();
    const auto edge = [&](std::size_t a, std::size_t b)
    { return this->PointBetween(corners[a], corners[b]); };
    const Vector3 outwards = this->At(corners[0]) - this->At(corners[3]);
    if (inside == 1)
    {
      this->AddTriangle({ edge(0, 1), edge(0, 2), edge(0, 3) }, outwards);
    }
    else if (inside == 3)
    {
      this->AddTriangle({ edge(3, 0), edge(3, 1), edge(3, 2) }, outwards);
    }
    else if (inside == 2)
    {
      this->AddTriangle({ edge(0, 2), edge(0, 3), edge(1, 3) }, outwards);
      this->AddTriangle({ edge(0, 2), edge(1, 3), edge(1, 2) }, outwards);
    }
  }

  void AddTriangle(Triangle corners, const Vector3& outwards)
  {
    const std::vector<Vector3>& p = this->Built.Points;
    const Vector3 normal = (p[corners[1]] - p[corners[0]]).cross(p[corners[2]] - p[corners[0]]);
    if (Dot(normal, outwards) < 0.0)
    {
      std::swap(corners[1], corners[2]);
    }
    this->Built.Triangles.push_back(corners);
  }

  Vector3 At(const Voxel& voxel) const
  {
    return Vector3(voxel[0], voxel[1], voxel[2]).cwiseProduct(this->Spacing);
  }

  Index PointBetween(const Voxel& a, const Voxel& b)
  {
    const auto next = static_cast<Index>(this->Built.Points.size());
    const auto [entry, isNew] = this->Ids.emplace(std::minmax(a, b), next);
    if (isNew)
    {
      this->Built.Points.push_back(0.5 * (this->At(a) + this->At(b)));
    }
    return entry->second;
  }

  IsInside Inside;
  Vector3 Spacing; // mm
  std::map<std::pair<Voxel, Voxel>, Index> Ids;
};

/// A regular polygon at some height, its sides in parts, and so many smaller ones inside of it down
/// to its center.
class Cap
{
public:
  Cap(Surface& surface, Index sides, Index parts, Index rings)
    : To(surface)
    , Sides(sides)
    , Parts(parts)
    , Rings(rings)
  {
  }

  Index AddRing(double radius, double height)
  {
    const auto first = static_cast<Index>(this->To.Points.size());
    for (Index side = 0; side < this->Sides; ++side)
    {
      const auto corner = [&](Index i)
      {
        const double angle = 2.0 * Pi * (i % this->Sides) / this->Sides;
        return Vector3(radius * Cosine(angle), radius * Sine(angle), height);
      };
      for (Index part = 0; part < this->Parts; ++part)
      {
        const double fraction = static_cast<double>(part) / this->Parts;
        this->To.Points.push_back(corner(side) + fraction * (corner(side + 1) - corner(side)));
      }
    }
    return first;
  }

  /// The second ring lies above the first, or inside it on top.
  void Join(Index first, Index second)
  {
    const Index count = this->Sides * this->Parts;
    for (Index i = 0; i < count; ++i)
    {
      const Index next = (i + 1) % count;
      this->To.Triangles.push_back({ first + i, first + next, second + next });
      this->To.Triangles.push_back({ first + i, second + next, second + i });
    }
  }

  void Close(Index rim, double radius, double height, bool isTop)
  {
    const auto begin = this->To.Triangles.size();
    Index outer = rim;
    for (Index ring = 1; ring < this->Rings; ++ring)
    {
      const Index inner = this->AddRing(radius * (this->Rings - ring) / this->Rings, height);
      this->Join(outer, inner);
      outer = inner;
    }
    const auto center = static_cast<Index>(this->To.Points.size());
    this->To.Points.emplace_back(0.0, 0.0, height);
    const Index count = this->Sides * this->Parts;
    for (Index i = 0; i < count; ++i)
    {
      this->To.Triangles.push_back({ outer + i, outer + (i + 1) % count, center });
    }
    for (std::size_t t = begin; !isTop && t < this->To.Triangles.size(); ++t)
    {
      std::swap(this->To.Triangles[t][1], this->To.Triangles[t][2]);
    }
  }

private:
  Surface& To;
  Index Sides, Parts, Rings;
};
}

Surface Prism(Index sides, Index parts, Index layers)
{
  constexpr double radius = 5.0;
  constexpr double height = 8.0;
  constexpr Index rings = 3;
  Surface prism;
  Cap cap(prism, sides, parts, rings);
  const Index bottom = cap.AddRing(radius, 0.0);
  Index below = bottom;
  for (Index layer = 1; layer <= layers; ++layer)
  {
    const Index above = cap.AddRing(radius, height * layer / layers);
    cap.Join(below, above);
    below = above;
  }
  cap.Close(below, radius, height, true);
  cap.Close(bottom, radius, 0.0, false);
  return prism;
}

Surface CappedCylinder(Index around, Index layers)
{
  return Prism(around, 1, layers);
}

Surface LabelSurface(const Voxel& size, const Vector3& spacing, const LabelOf& labelOf, int label)
{
  const auto isInside = [&](const Voxel& voxel)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (voxel[k] < 0 || voxel[k] >= size[k])
      {
        return false;
      }
    }
    return labelOf(voxel) == label;
  };
  BinarySurface surface(isInside, spacing);
  for (Index z = -1; z < size[2]; ++z)
  {
    for (Index y = -1; y < size[1]; ++y)
    {
      for (Index x = -1; x < size[0]; ++x)
      {
        surface.AddCube({ x, y, z });
      }
    }
  }
  return surface.Built;
}

int LabelOfHalves(const Voxel& voxel)
{
  const Vector3 p(voxel[0] - 3.2, voxel[1] - 3.0, voxel[2] - 2.7);
  const bool isInside = p.cwiseQuotient(Vector3(3.3, 2.9, 2.6)).squaredNorm() < 1.0;
  const bool isCore = (p - Vector3(0.5, 0.0, 0.0)).squaredNorm() < 2.0;
  return !isInside ? 0 : isCore ? 3 : 2.0 * p[0] + p[1] < 1.0 ? 1 : 2;
}

Surface VoxelEllipsoid()
{
  return LabelSurface(
    { 7, 7, 6 }, { 0.957031, 0.957031, 1.5 },
    [](const Voxel& voxel) { return LabelOfHalves(voxel) == 0 ? 0 : 1; }, 1);
}

Surface LabeledPart(int label)
{
  return LabelSurface({ 7, 7, 6 }, { 0.5, 0.5, 0.5 }, LabelOfHalves, label);
}

Surface NearSpheres(int levels, double gap)
{
  return Together(Icosphere(levels, 5.0), TurnedInsideOut(Icosphere(levels, 5.0 - gap)));
}
}
