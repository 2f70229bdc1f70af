// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelOracle.h"

#include "BruteForce.h"
#include "Crossings.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace bonedecimate::testsupport
{
namespace
{
using Big = boost::multiprecision::cpp_int;
using BigPoint = std::array<Big, 3>;

constexpr int BitsOfFactor = 320; // of a coordinate, and of each factor of a product of two

/// value * 2^bits
Big Exact(double value, int bits)
{
  int exponent = 0;
  const auto digits = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  const int shift = exponent - 53 + bits;
  if (digits != 0 && shift < 0)
  {
    throw std::range_error("a coordinate is too small to be an integer");
  }
  return digits == 0 ? Big(0) : Big(digits) << shift;
}

BigPoint Exact(const Vector3& p)
{
  return { Exact(p[0], 2 * BitsOfFactor), Exact(p[1], 2 * BitsOfFactor),
    Exact(p[2], 2 * BitsOfFactor) };
}

BigPoint CenterOf(const VoxelGrid& grid, const std::array<Index, 3>& voxel)
{
  BigPoint center = Exact(grid.Origin);
  for (Index row = 0; row < 3; ++row)
  {
    for (Index k = 0; k < 3; ++k)
    {
      const Index at = voxel[static_cast<std::size_t>(k)];
      const Big length = k == 2 && grid.HasLayers()
        ? Exact(grid.Layers[static_cast<std::size_t>(at)], BitsOfFactor)
        : Big(Exact(grid.Spacing[k], BitsOfFactor) * at);
      center[static_cast<std::size_t>(row)] += Exact(grid.Direction(row, k), BitsOfFactor) * length;
    }
  }
  return center;
}

BigPoint Minus(const BigPoint& a, const BigPoint& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

/// Coordinate of u x v along an axis.
Big Cross(const BigPoint& u, const BigPoint& v, std::size_t axis)
{
  const std::size_t s = (axis + 1) % 3;
  const std::size_t t = (axis + 2) % 3;
  return u[s] * v[t] - u[t] * v[s];
}

/// The sign of the first coordinate of the normal if the line along the first axis through p meets
/// the triangle above p, else
/// 0. A line that meets an edge or a corner counts as a little farther along the third axis, then
///    the second.
int CrossingAbove(const std::array<const BigPoint*, 3>& corners, const BigPoint& p)
{
  int winding = 0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const BigPoint& a = *corners[k];
    const BigPoint& b = *corners[(k + 1) % 3];
    const bool rises = a[2] <= p[2] && p[2] < b[2];
    const bool falls = b[2] <= p[2] && p[2] < a[2];
    if (rises || falls)
    {
      const int side = Cross(Minus(b, a), Minus(p, a), 0).sign();
      winding += rises && side > 0 ? 1 : falls && side < 0 ? -1 : 0;
    }
  }
  if (winding == 0)
  {
    return 0;
  }
  const BigPoint u = Minus(*corners[1], *corners[0]);
  const BigPoint v = Minus(*corners[2], *corners[0]);
  const BigPoint w = Minus(p, *corners[0]);
  const Big height = Cross(u, v, 0) * w[0] + Cross(u, v, 1) * w[1] + Cross(u, v, 2) * w[2];
  return height.sign() * winding < 0 ? winding : 0;
}

using BigTriangle = std::array<BigPoint, 3>;

int Side(const BigPoint& a, const BigPoint& b, const BigPoint& c, const BigPoint& d)
{
  const BigPoint u = Minus(b, a);
  const BigPoint v = Minus(c, a);
  const BigPoint w = Minus(d, a);
  return Big(Cross(u, v, 0) * w[0] + Cross(u, v, 1) * w[1] + Cross(u, v, 2) * w[2]).sign();
}

/// Whether the inside of an edge meets the inside of a triangle in one point.
bool Pierces(const BigPoint& p, const BigPoint& q, const BigTriangle& t)
{
  if (Side(t[0], t[1], t[2], p) * Side(t[0], t[1], t[2], q) >= 0)
  {
    return false;
  }
  const int first = Side(p, q, t[0], t[1]);
  return first != 0 && Side(p, q, t[1], t[2]) == first && Side(p, q, t[2], t[0]) == first;
}

bool Pierce(const Surface& surface, const Triangle& a, const Triangle& b)
{
  BigTriangle p;
  BigTriangle q;
  for (std::size_t k = 0; k < 3; ++k)
  {
    p[k] = Exact(surface.Points[static_cast<std::size_t>(a[k])]);
    q[k] = Exact(surface.Points[static_cast<std::size_t>(b[k])]);
  }
  bool pierces = false;
  for (std::size_t k = 0; k < 3; ++k)
  {
    pierces = pierces || Pierces(p[k], p[(k + 1) % 3], q) || Pierces(q[k], q[(k + 1) % 3], p);
  }
  return pierces;
}

class ExactCounter
{
public:
  ExactCounter(const LabeledTriangles& surface, const VoxelGrid& grid, Index background)
    : Labeled(surface)
    , Grid(grid)
    , Background(background)
  {
    for (const Vector3& p : surface.Surface.Points)
    {
      this->Points.push_back(Exact(p));
    }
  }

  /// Whether the winding numbers of all labels around the center are 0, but for that label.
  bool IsIn(Index label, const std::array<Index, 3>& voxel) const
  {
    const BigPoint center = CenterOf(this->Grid, voxel);
    const Vector3 about = this->Grid.ToMillimeters({ static_cast<double>(voxel[0]),
      static_cast<double>(voxel[1]), static_cast<double>(voxel[2]) });
    std::vector<int> winding(static_cast<std::size_t>(this->Background) + 1, 0);
    winding.back() = 1; // outside of everything
    for (std::size_t t = 0; t < this->Labeled.Labels.size(); ++t)
    {
      const int sign = this->MayMeet(t, about) ? this->Crossing(t, center) : 0;
      winding[static_cast<std::size_t>(this->Labeled.Labels[t][0])] += sign;
      winding[static_cast<std::size_t>(this->Labeled.Labels[t][1])] -= sign;
    }
    --winding[static_cast<std::size_t>(label)];
    return std::all_of(winding.begin(), winding.end(), [](int w) { return w == 0; });
  }

private:
  bool MayMeet(std::size_t t, const Vector3& p) const
  {
    const double rounding = 1e-9 * (p.norm() + this->Grid.Spacing.maxCoeff());
    Vector3 low = p;
    Vector3 high = p;
    const Triangle& c = this->Labeled.Surface.Triangles[t];
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Vector3& corner = this->Labeled.Surface.Points[static_cast<std::size_t>(c[k])];
      low = k == 0 ? corner : low.cwiseMin(corner);
      high = k == 0 ? corner : high.cwiseMax(corner);
    }
    return high[0] >= p[0] - rounding && low[1] <= p[1] + rounding && high[1] >= p[1] - rounding &&
      low[2] <= p[2] + rounding && high[2] >= p[2] - rounding;
  }

  int Crossing(std::size_t t, const BigPoint& p) const
  {
    const Triangle& c = this->Labeled.Surface.Triangles[t];
    return CrossingAbove({ &this->Points[static_cast<std::size_t>(c[0])],
                           &this->Points[static_cast<std::size_t>(c[1])],
                           &this->Points[static_cast<std::size_t>(c[2])] },
      p);
  }

  const LabeledTriangles& Labeled;
  const VoxelGrid& Grid;
  Index Background;
  std::vector<BigPoint> Points;
};

/// Lines of voxel centers through the inside of the grid that are nearer to the segment than that
/// many voxels.
std::int64_t CountLinesNear(
  const Vector3& a, const Vector3& b, const VoxelGrid& grid, double voxels)
{
  std::int64_t count = 0;
  for (Index r = 0; r < 3; ++r)
  {
    const Index s = (r + 1) % 3;
    const Index t = (r + 2) % 3;
    for (Index i = 1; i + 1 < grid.Dimensions[static_cast<std::size_t>(s)]; ++i)
    {
      for (Index j = 1; j + 1 < grid.Dimensions[static_cast<std::size_t>(t)]; ++j)
      {
        const Eigen::Vector2d p(s == 2 ? grid.StepsOf(i) : i, t == 2 ? grid.StepsOf(j) : j);
        const Eigen::Vector2d from(a[s], a[t]);
        const Eigen::Vector2d along(b[s] - a[s], b[t] - a[t]);
        const double squared = std::max(along.squaredNorm(), 1e-300);
        const double at = std::clamp((p - from).dot(along) / squared, 0.0, 1.0);
        count += (from + at * along - p).norm() < voxels ? 1 : 0;
      }
    }
  }
  return count;
}
}

std::int64_t CountWrongExactly(const LabeledTriangles& surface, const VoxelGrid& grid,
  const std::vector<Index>& voxels, Index background)
{
  const ExactCounter counter(surface, grid, background);
  std::int64_t wrong = 0;
  std::size_t at = 0;
  for (Index z = 0; z < grid.Dimensions[2]; ++z)
  {
    for (Index y = 0; y < grid.Dimensions[1]; ++y)
    {
      for (Index x = 0; x < grid.Dimensions[0]; ++x)
      {
        wrong += counter.IsIn(voxels[at++], { x, y, z }) ? 0 : 1;
      }
    }
  }
  return wrong;
}

//------------------------------------------------------------------------------
std::int64_t CountNearCenters(const Surface& surface, const VoxelGrid& grid, double voxels)
{
  std::int64_t count = 0;
  for (const Triangle& t : surface.Triangles)
  {
    std::array<Vector3, 3> c;
    for (std::size_t k = 0; k < 3; ++k)
    {
      c[k] = grid.ToSteps(surface.Points[static_cast<std::size_t>(t[k])]);
    }
    const Vector3 low = c[0].cwiseMin(c[1]).cwiseMin(c[2]) - Vector3::Constant(voxels);
    const Vector3 high = c[0].cwiseMax(c[1]).cwiseMax(c[2]) + Vector3::Constant(voxels);
    for (double x = std::ceil(low[0]); x <= high[0]; ++x)
    {
      for (double y = std::ceil(low[1]); y <= high[1]; ++y)
      {
        for (double z = std::ceil(grid.LayerAt(low[2]) - 1e-9); grid.StepsOf(z) <= high[2]; ++z)
        {
          const Vector3 center(x, y, grid.StepsOf(z));
          count += PointTriangleDistance(center, c[0], c[1], c[2]) < voxels ? 1 : 0;
        }
      }
    }
  }
  return count;
}

//------------------------------------------------------------------------------
std::int64_t CountRimsNearLines(
  const LabeledTriangles& surface, const VoxelGrid& grid, double voxels)
{
  std::map<std::tuple<Index, Index, Index>, int> sums; // of label, low and high end of an edge
  for (std::size_t i = 0; i < surface.Labels.size(); ++i)
  {
    const Triangle& t = surface.Surface.Triangles[i];
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto [low, high] = std::minmax({ t[k], t[(k + 1) % 3] });
      const int sign = low == t[k] ? 1 : -1;
      sums[{ surface.Labels[i][0], low, high }] += sign;
      sums[{ surface.Labels[i][1], low, high }] -= sign;
    }
  }
  std::int64_t count = 0;
  for (const auto& [edge, sum] : sums)
  {
    const auto point = [&](Index id)
    { return grid.ToSteps(surface.Surface.Points[static_cast<std::size_t>(id)]); };
    count += sum == 0
      ? 0
      : CountLinesNear(point(std::get<1>(edge)), point(std::get<2>(edge)), grid, voxels);
  }
  return count;
}

//------------------------------------------------------------------------------
std::int64_t CountIntersections(const Surface& surface)
{
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const Triangle& t : surface.Triangles)
  {
    boxes.emplace_back();
    for (const Index corner : t)
    {
      boxes.back().extend(surface.Points[static_cast<std::size_t>(corner)]);
    }
  }
  std::int64_t count = 0;
  for (std::size_t i = 0; i < surface.Triangles.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const Triangle& a = surface.Triangles[i];
      const Triangle& b = surface.Triangles[j];
      const bool mayPierce = boxes[i].intersects(boxes[j]) && Cross(surface, a, b);
      count += mayPierce && Pierce(surface, a, b) ? 1 : 0;
    }
  }
  return count;
}

//------------------------------------------------------------------------------
bool AreWallsShared(const LabeledTriangles& surface, Index numberOfLabels)
{
  for (Index label = 0; label < numberOfLabels; ++label)
  {
    std::map<std::pair<Index, Index>, int> sums;
    for (const Triangle& t : SurfaceOfLabel(surface, label).Triangles)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Index a = t[k];
        const Index b = t[(k + 1) % 3];
        sums[std::minmax(a, b)] += a < b ? 1 : -1;
      }
    }
    if (std::any_of(sums.begin(), sums.end(), [](const auto& sum) { return sum.second != 0; }))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
Surface SurfaceOfLabel(const LabeledTriangles& surface, Index label)
{
  Surface part;
  part.Points = surface.Surface.Points;
  for (std::size_t t = 0; t < surface.Labels.size(); ++t)
  {
    const Triangle& c = surface.Surface.Triangles[t];
    if (surface.Labels[t][0] == label)
    {
      part.Triangles.push_back(c);
    }
    if (surface.Labels[t][1] == label)
    {
      part.Triangles.push_back({ c[0], c[2], c[1] });
    }
  }
  return part;
}
}
