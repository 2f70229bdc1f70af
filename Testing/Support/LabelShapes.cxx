// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelShapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace bonedecimate::testsupport
{
namespace
{
using Voxel = std::array<Index, 3>;

/// Marching cubes by following the segments on the faces of each cube; ambiguous faces cut off the
/// corners inside.
class Marcher
{
public:
  Marcher(const std::function<bool(const Voxel&)>& isInside)
    : IsInside(isInside)
  {
  }

  void AddCube(const Voxel& least)
  {
    this->Next.clear();
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (const Index side : { 0, 1 })
      {
        this->AddFace(least, axis, side);
      }
    }
    while (!this->Next.empty())
    {
      std::vector<Index> loop;
      for (Index at = this->Next.begin()->first; this->Next.count(at) != 0;)
      {
        const Index next = this->Next[at];
        this->Next.erase(at);
        loop.push_back(at);
        at = next;
      }
      this->AddPolygon(loop);
    }
  }

  std::vector<GridPoint> Points;
  std::vector<Triangle> Triangles;

private:
  /// Corners counter-clockwise from outside; a segment runs with the inside on its left, seen from
  /// outside.
  void AddFace(const Voxel& least, std::size_t axis, Index side)
  {
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    std::array<Voxel, 4> corners{};
    for (std::size_t i = 0; i < 4; ++i)
    {
      const std::size_t turned = side == 1 ? i : 3 - i;
      corners[i] = least;
      corners[i][axis] += side;
      corners[i][u] += turned == 1 || turned == 2 ? 1 : 0;
      corners[i][v] += turned >= 2 ? 1 : 0;
    }
    for (std::size_t i = 0; i < 4; ++i)
    {
      // Into a run of corners inside at the edge before corner i, out at the edge after its last
      // one.
      if (this->IsInside(corners[i]) && !this->IsInside(corners[(i + 3) % 4]))
      {
        std::size_t last = i;
        while (this->IsInside(corners[(last + 1) % 4]))
        {
          ++last;
        }
        const Index in = this->PointBetween(corners[(i + 3) % 4], corners[i]);
        const Index out = this->PointBetween(corners[last % 4], corners[(last + 1) % 4]);
        this->Next[in] = out;
      }
    }
  }

  Index PointBetween(const Voxel& a, const Voxel& b)
  {
    const GridPoint point = { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
    const auto [entry, isNew] = this->Ids.emplace(point, static_cast<Index>(this->Points.size()));
    if (isNew)
    {
      this->Points.push_back(point);
    }
    return entry->second;
  }

  static bool AreOnOneFace(const GridPoint& a, const GridPoint& b)
  {
    // Both on one face of the cube: an even coordinate is a corner's, and the same.
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (a[k] == b[k] && a[k] % 2 == 0)
      {
        return true;
      }
    }
    return false;
  }

  /// A fan from the corner whose diagonals lie in no face of the cube.
  void AddPolygon(const std::vector<Index>& loop)
  {
    const std::size_t size = loop.size();
    std::size_t best = 0;
    std::size_t fewest = size;
    for (std::size_t start = 0; start < size; ++start)
    {
      std::size_t inFaces = 0;
      for (std::size_t k = 2; k + 1 < size; ++k)
      {
        inFaces += AreOnOneFace(this->Points[loop[start]], this->Points[loop[(start + k) % size]]);
      }
      best = inFaces < fewest ? start : best;
      fewest = std::min(fewest, inFaces);
    }
    for (std::size_t k = 1; k + 1 < size; ++k)
    {
      this->Triangles.push_back(
        { loop[best], loop[(best + k) % size], loop[(best + k + 1) % size] });
    }
  }

  const std::function<bool(const Voxel&)>& IsInside;
  std::map<GridPoint, Index> Ids;
  std::map<Index, Index> Next; // points of the segments of a cube
};

double SignedVolumeOf(const Surface& surface)
{
  double volume = 0.0;
  for (const Triangle& c : surface.Triangles)
  {
    volume += Dot(surface.Points[c[0]], surface.Points[c[1]].cross(surface.Points[c[2]]));
  }
  return volume;
}
}

IsInsideOf BallShape(double radius)
{
  return [radius](const Vector3& p) { return p.norm() <= radius; };
}

IsInsideOf TorusShape(double ring, double tube)
{
  return [=](const Vector3& p)
  {
    const double beside = std::sqrt(p[0] * p[0] + p[1] * p[1]) - ring;
    return beside * beside + p[2] * p[2] <= tube * tube;
  };
}

IsInsideOf BoxShape(const Vector3& half)
{
  return [half](const Vector3& p) { return (half - p.cwiseAbs()).minCoeff() >= 0.0; };
}

IsInsideOf Oblique(IsInsideOf shape)
{
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.5, Vector3(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  const Vector3 shift(0.13, 0.21, 0.37);
  return [=](const Vector3& p) { return shape(turn * (p - shift)); };
}

BinarySurface MarchedShape(const IsInsideOf& shape, double half, const Vector3& spacing)
{
  BinarySurface marched;
  VoxelGrid& grid = marched.Source.Grid;
  grid.Spacing = spacing;
  grid.Origin = Vector3::Constant(-half) - spacing;
  for (std::size_t k = 0; k < 3; ++k)
  {
    grid.Dimensions[k] = static_cast<Index>(std::ceil(2.0 * half / spacing[k])) + 3;
  }
  // no structured binding: lambdas of C++17 do not capture those
  const Index nx = grid.Dimensions[0];
  const Index ny = grid.Dimensions[1];
  const Index nz = grid.Dimensions[2];
  for (Index z = 0; z < nz; ++z)
  {
    for (Index y = 0; y < ny; ++y)
    {
      for (Index x = 0; x < nx; ++x)
      {
        const bool isInner = std::min({ x, y, z }) > 0 && x + 1 < nx && y + 1 < ny && z + 1 < nz;
        marched.Voxels.push_back(isInner && shape(grid.ToMillimeters(Vector3(x, y, z))) ? 1 : 0);
      }
    }
  }
  const std::function<bool(const Voxel&)> isInside = [&](const Voxel& v)
  {
    return marched.Voxels[v[0] +
             static_cast<std::size_t>(nx) * (v[1] + static_cast<std::size_t>(ny) * v[2])] != 0;
  };
  Marcher marcher(isInside);
  for (Index z = 0; z + 1 < nz; ++z)
  {
    for (Index y = 0; y + 1 < ny; ++y)
    {
      for (Index x = 0; x + 1 < nx; ++x)
      {
        marcher.AddCube({ x, y, z });
      }
    }
  }
  for (const GridPoint& p : marcher.Points)
  {
    marched.Surface.Points.push_back(grid.ToMillimeters(0.5 * Vector3(p[0], p[1], p[2])));
  }
  marched.Surface.Triangles = marcher.Triangles;
  if (SignedVolumeOf(marched.Surface) < 0.0)
  {
    for (Triangle& c : marched.Surface.Triangles)
    {
      std::swap(c[1], c[2]);
    }
  }
  marched.Source.OfPoint = marcher.Points;
  return marched;
}

std::int64_t CountChangedVoxels(const BinarySurface& binary, const Surface& surface)
{
  const VoxelGrid& grid = binary.Source.Grid;
  const auto [nx, ny, nz] = grid.Dimensions;
  // Crossings of the row of voxels at (y, z), a little beside the centers.
  const Vector3 beside(0.0, 1.37e-7, 0.73e-7);
  std::map<std::pair<Index, Index>, std::vector<double>> crossings;
  for (const Triangle& c : surface.Triangles)
  {
    std::array<Vector3, 3> p;
    for (std::size_t i = 0; i < 3; ++i)
    {
      p[i] = grid.ToVoxels(surface.Points[c[i]]) - beside;
    }
    const Vector3 low = p[0].cwiseMin(p[1]).cwiseMin(p[2]);
    const Vector3 high = p[0].cwiseMax(p[1]).cwiseMax(p[2]);
    const double whole =
      (p[1][1] - p[0][1]) * (p[2][2] - p[0][2]) - (p[1][2] - p[0][2]) * (p[2][1] - p[0][1]);
    for (auto y = static_cast<Index>(std::ceil(low[1])); y <= high[1]; ++y)
    {
      for (auto z = static_cast<Index>(std::ceil(low[2])); z <= high[2]; ++z)
      {
        std::array<double, 3> areas{};
        for (std::size_t i = 0; i < 3; ++i)
        {
          const Vector3& a = p[(i + 1) % 3];
          const Vector3& b = p[(i + 2) % 3];
          areas[i] = (a[1] - y) * (b[2] - z) - (a[2] - z) * (b[1] - y);
        }
        const auto [least, most] = std::minmax_element(areas.begin(), areas.end());
        if (whole != 0.0 && (*least >= 0.0 || *most <= 0.0))
        {
          crossings[{ y, z }].push_back(
            (areas[0] * p[0][0] + areas[1] * p[1][0] + areas[2] * p[2][0]) /
            (areas[0] + areas[1] + areas[2]));
        }
      }
    }
  }
  std::int64_t changed = 0;
  for (Index z = 0; z < nz; ++z)
  {
    for (Index y = 0; y < ny; ++y)
    {
      const std::vector<double>& row = crossings[{ y, z }];
      for (Index x = 0; x < nx; ++x)
      {
        const auto before =
          std::count_if(row.begin(), row.end(), [x](double at) { return at < x; });
        const bool isInside = before % 2 != 0;
        const std::size_t voxel =
          x + static_cast<std::size_t>(nx) * (y + static_cast<std::size_t>(ny) * z);
        changed += isInside != (binary.Voxels[voxel] != 0) ? 1 : 0;
      }
    }
  }
  return changed;
}

namespace
{
/// Collects the sides between voxels.
class BlockBuilder
{
public:
  /// The upper side along the axis of a voxel with its label and that of the next one.
  void AddSide(const Voxel& voxel, std::size_t axis, Index below, Index above)
  {
    std::array<Index, 4> corners{};
    for (std::size_t i = 0; i < 4; ++i)
    {
      Voxel corner = voxel;
      ++corner[axis];
      corner[(axis + 1) % 3] += i == 1 || i == 2 ? 1 : 0;
      corner[(axis + 2) % 3] += i >= 2 ? 1 : 0;
      corners[i] = this->PointAt(corner);
    }
    // The normal points from the first label to the second: along the axis if the lower voxel has
    // the first one.
    const bool isAlong = above == 0 || (below != 0 && below < above);
    if (!isAlong)
    {
      std::swap(corners[1], corners[3]);
    }
    std::vector<Triangle>& triangles = this->Complex.Surface.Triangles;
    triangles.push_back({ corners[0], corners[1], corners[2] });
    triangles.push_back({ corners[0], corners[2], corners[3] });
    const BoundaryLabels labels =
      isAlong ? BoundaryLabels{ below, above } : BoundaryLabels{ above, below };
    this->Complex.Labels.insert(this->Complex.Labels.end(), 2, labels);
  }

  BlockComplex Complex;

private:
  Index PointAt(const Voxel& corner)
  {
    std::vector<Vector3>& points = this->Complex.Surface.Points;
    const auto [entry, isNew] = this->Ids.emplace(corner, static_cast<Index>(points.size()));
    if (isNew)
    {
      points.emplace_back(corner[0], corner[1], corner[2]);
    }
    return entry->second;
  }

  std::map<Voxel, Index> Ids;
};
}

BlockComplex BlocksOf(
  const std::array<Index, 3>& size, const std::function<Index(const Voxel& voxel)>& labelOf)
{
  BlockBuilder builder;
  const auto labelAt = [&](const Voxel& v)
  {
    const bool isInside =
      std::min({ v[0], v[1], v[2] }) >= 0 && v[0] < size[0] && v[1] < size[1] && v[2] < size[2];
    return isInside ? labelOf(v) : 0;
  };
  for (Index z = -1; z < size[2]; ++z)
  {
    for (Index y = -1; y < size[1]; ++y)
    {
      for (Index x = -1; x < size[0]; ++x)
      {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          const Voxel lower = { x, y, z };
          Voxel upper = lower;
          ++upper[axis];
          if (labelAt(lower) != labelAt(upper))
          {
            builder.AddSide(lower, axis, labelAt(lower), labelAt(upper));
          }
        }
      }
    }
  }
  return builder.Complex;
}
}
