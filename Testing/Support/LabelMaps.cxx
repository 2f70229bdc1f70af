// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelMaps.h"

#include "Random.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>

namespace bonedecimate::testsupport
{
LabelMap MakeLabelMap(const std::array<Index, 3>& size, const LabelOf& labelOf)
{
  LabelMap map;
  map.Grid.Dimensions = size;
  for (Index z = 0; z < size[2]; ++z)
  {
    for (Index y = 0; y < size[1]; ++y)
    {
      for (Index x = 0; x < size[0]; ++x)
      {
        map.Labels.push_back(labelOf({ x, y, z }));
      }
    }
  }
  return map;
}

//------------------------------------------------------------------------------
LabelMap NoiseLabels(const std::array<Index, 3>& size, int labels, std::uint64_t seed)
{
  Random random(seed);
  return MakeLabelMap(size, [&](const std::array<Index, 3>&) { return random.Below(labels); });
}

//------------------------------------------------------------------------------
LabelMap EllipsoidLabels(const std::array<Index, 3>& size)
{
  return MakeLabelMap(size,
    [&](const std::array<Index, 3>& voxel)
    {
      double squared = 0.0;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double half = 0.5 * (size[axis] - 1);
        squared += std::pow((voxel[axis] - half) / (half - 1.0), 2);
      }
      const bool isLeft = voxel[0] < size[0] / 2;
      return squared < 0.2 ? 3 : squared >= 1.0 ? 0 : isLeft ? 1 : 2;
    });
}

//------------------------------------------------------------------------------
VoxelGrid ObliqueGrid(const std::array<Index, 3>& size, bool isMirrored)
{
  VoxelGrid grid;
  grid.Dimensions = size;
  grid.Origin = { -31.5, 12.25, 704.0 };
  grid.Spacing = { 0.7, 0.45, 1.25 };
  grid.Direction = (Eigen::AngleAxisd(0.3, Vector3::UnitX()) *
    Eigen::AngleAxisd(-0.8, Vector3::UnitY()) * Eigen::AngleAxisd(2.1, Vector3::UnitZ()))
                     .toRotationMatrix();
  if (isMirrored)
  {
    grid.Direction.col(2) *= -1.0;
  }
  return grid;
}

VoxelGrid ShearedGrid(const std::array<Index, 3>& size, bool isMirrored)
{
  VoxelGrid grid = ObliqueGrid(size, isMirrored);
  Vector3 tilted =
    grid.Direction.col(2) + 0.4 * grid.Direction.col(1) - 0.1 * grid.Direction.col(0);
  grid.Direction.col(2) = tilted.normalized();
  return grid;
}

VoxelGrid Uneven(VoxelGrid grid)
{
  static constexpr std::array<double, 3> ratios = { 1.0, 1.75, 3.0 };
  const Index count = grid.Dimensions[2];
  grid.Layers = { 0.0 };
  for (Index k = 1; k < count; ++k)
  {
    const auto part = static_cast<std::size_t>(3 * (k - 1) / (count - 1));
    grid.Layers.push_back(grid.Layers.back() + ratios[part] * grid.Spacing[2]);
  }
  return grid;
}

namespace
{
/// A line passes a triangle and goes from one label to another.
struct Crossing
{
  double Height; ///< Spacings along the axis.
  Index From;
  Index To;
};

class LabelVoxelizer
{
public:
  LabelVoxelizer(const VoxelGrid& grid, Index background, std::size_t axis)
    : Grid(grid)
    , Background(background)
    , Axes{ axis, (axis + 1) % 3, (axis + 2) % 3 }
    , Columns(static_cast<std::size_t>(this->Size(1)) * static_cast<std::size_t>(this->Size(2)))
  {
    this->ToVoxels = (grid.Direction * grid.Spacing.asDiagonal()).inverse();
    this->Turn = this->ToVoxels.determinant() < 0.0 ? -1.0 : 1.0;
  }

  void Add(const Surface& surface, const std::vector<BoundaryLabels>& labels)
  {
    for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
    {
      std::array<Vector3, 3> corners;
      for (std::size_t k = 0; k < 3; ++k)
      {
        const auto id = static_cast<std::size_t>(surface.Triangles[t][k]);
        corners[k] = this->Turned(this->ToVoxels * (surface.Points[id] - this->Grid.Origin));
      }
      this->AddTriangle(corners, labels[t]);
    }
  }

  std::vector<Index> Labels()
  {
    std::vector<Index> result(this->Columns.size() * static_cast<std::size_t>(this->Size(0)));
    for (Index v = 0; v < this->Size(2); ++v)
    {
      for (Index u = 0; u < this->Size(1); ++u)
      {
        this->Walk(u, v, result);
      }
    }
    return result;
  }

  std::int64_t WrongEdges(const VoxelLabels& voxels)
  {
    std::int64_t wrong = 0;
    const Index side = voxels.IsOpen ? 1 : 0;
    for (Index v = side; v < this->Size(2) - side; ++v)
    {
      for (Index u = side; u < this->Size(1) - side; ++u)
      {
        wrong += this->WrongEdgesOf(u, v, voxels);
      }
    }
    return wrong;
  }

private:
  static constexpr double ShiftU = 1e-7; // so that lines meet no vertex and no edge
  static constexpr double ShiftV = 0.37e-7;

  Index Size(std::size_t k) const { return this->Grid.Dimensions[this->Axes[k]]; }
  /// Where voxel centers are along the k-th of the axes, in spacings; of the last one the distance
  /// goes on.
  double At(std::size_t k, Index voxel) const
  {
    const std::vector<double>& layers = this->Grid.Layers;
    if (this->Axes[k] != 2 || layers.size() < 2)
    {
      return voxel;
    }
    const Index last = static_cast<Index>(layers.size()) - 1;
    const Index lower = std::clamp(voxel, 0, last - 1);
    const double from = layers[static_cast<std::size_t>(lower)];
    const double distance = layers[static_cast<std::size_t>(lower) + 1] - from;
    return (from + (voxel - lower) * distance) / this->Grid.Spacing[2];
  }
  std::vector<Crossing>& Column(Index u, Index v)
  {
    return this->Columns[static_cast<std::size_t>(u) +
      static_cast<std::size_t>(v) * static_cast<std::size_t>(this->Size(1))];
  }
  /// The axis of the lines first.
  Vector3 Turned(const Vector3& x) const
  {
    return { x[static_cast<Index>(this->Axes[0])], x[static_cast<Index>(this->Axes[1])],
      x[static_cast<Index>(this->Axes[2])] };
  }

  void AddTriangle(const std::array<Vector3, 3>& c, const BoundaryLabels& labels)
  {
    const auto range = [&](Index axis, Index size)
    {
      if (this->Axes[static_cast<std::size_t>(axis)] == 2 && this->Grid.HasLayers())
      {
        return std::pair<Index, Index>(0, size - 1);
      }
      const auto [low, high] = std::minmax({ c[0][axis], c[1][axis], c[2][axis] });
      return std::pair(std::max(0, static_cast<Index>(std::floor(low)) - 1),
        std::min(size - 1, static_cast<Index>(std::ceil(high)) + 1));
    };
    const auto [u0, u1] = range(1, this->Size(1));
    const auto [v0, v1] = range(2, this->Size(2));
    for (Index v = v0; v <= v1; ++v)
    {
      for (Index u = u0; u <= u1; ++u)
      {
        this->AddCrossing(c, labels, u, v);
      }
    }
  }

  void AddCrossing(const std::array<Vector3, 3>& c, const BoundaryLabels& labels, Index u, Index v)
  {
    const double s = this->At(1, u) + ShiftU;
    const double t = this->At(2, v) + ShiftV;
    std::array<double, 3> areas = {}; // of the triangles of the line and an edge
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Vector3& p = c[(k + 1) % 3];
      const Vector3& q = c[(k + 2) % 3];
      areas[k] = (p[1] - s) * (q[2] - t) - (p[2] - t) * (q[1] - s);
    }
    const bool up = areas[0] > 0.0 && areas[1] > 0.0 && areas[2] > 0.0;
    const bool down = areas[0] < 0.0 && areas[1] < 0.0 && areas[2] < 0.0;
    if (up || down)
    {
      const double height = (areas[0] * c[0][0] + areas[1] * c[1][0] + areas[2] * c[2][0]) /
        (areas[0] + areas[1] + areas[2]);
      const bool along = up == (this->Turn > 0.0); // the normal points along the axis
      this->Column(u, v).push_back(
        { height, along ? labels[0] : labels[1], along ? labels[1] : labels[0] });
    }
  }

  void Walk(Index u, Index v, std::vector<Index>& result)
  {
    std::vector<Crossing>& column = this->Column(u, v);
    std::sort(column.begin(), column.end(),
      [](const Crossing& a, const Crossing& b) { return a.Height < b.Height; });
    std::vector<int> inside(static_cast<std::size_t>(this->Background) + 1, 0);
    inside.back() = 1;
    auto next = column.begin();
    for (Index h = 0; h < this->Size(0); ++h)
    {
      for (; next != column.end() && next->Height < this->At(0, h); ++next)
      {
        --inside[static_cast<std::size_t>(next->From)];
        ++inside[static_cast<std::size_t>(next->To)];
      }
      result[this->VoxelAt(h, u, v)] = OnlyLabel(inside);
    }
  }

  std::int64_t WrongEdgesOf(Index u, Index v, const VoxelLabels& voxels)
  {
    const std::vector<Crossing>& column = this->Column(u, v);
    const Index outside = voxels.IsOpen ? 1 : 0; // edges that leave the image
    std::int64_t wrong = 0;
    for (Index h = outside; h <= this->Size(0) - outside; ++h) // the edge from h - 1 to h
    {
      std::vector<int> sums(static_cast<std::size_t>(this->Background) + 1, 0);
      for (const Crossing& crossing : column)
      {
        const bool isOnEdge = (h == outside || crossing.Height >= this->At(0, h - 1)) &&
          (h == this->Size(0) - outside || crossing.Height < this->At(0, h));
        sums[static_cast<std::size_t>(crossing.From)] -= isOnEdge ? 1 : 0;
        sums[static_cast<std::size_t>(crossing.To)] += isOnEdge ? 1 : 0;
      }
      const auto labelAt = [&](Index at)
      {
        return at < 0 || at == this->Size(0) ? voxels.Background
                                             : voxels.OfVoxel[this->VoxelAt(at, u, v)];
      };
      ++sums[static_cast<std::size_t>(labelAt(h - 1))];
      --sums[static_cast<std::size_t>(labelAt(h))];
      wrong += std::all_of(sums.begin(), sums.end(), [](int sum) { return sum == 0; }) ? 0 : 1;
    }
    return wrong;
  }

  static Index OnlyLabel(const std::vector<int>& inside)
  {
    const auto label = std::find(inside.begin(), inside.end(), 1);
    const bool isOnly =
      static_cast<std::size_t>(std::count(inside.begin(), inside.end(), 0)) + 1 == inside.size();
    return isOnly && label != inside.end() ? static_cast<Index>(label - inside.begin()) : NoLabel;
  }

  std::size_t VoxelAt(Index h, Index u, Index v) const
  {
    std::array<std::size_t, 3> at = {};
    at[this->Axes[0]] = static_cast<std::size_t>(h);
    at[this->Axes[1]] = static_cast<std::size_t>(u);
    at[this->Axes[2]] = static_cast<std::size_t>(v);
    const auto& size = this->Grid.Dimensions;
    return at[0] +
      static_cast<std::size_t>(size[0]) * (at[1] + static_cast<std::size_t>(size[1]) * at[2]);
  }

  const VoxelGrid& Grid;
  Index Background;
  std::array<std::size_t, 3> Axes;
  std::vector<std::vector<Crossing>> Columns;
  Eigen::Matrix3d ToVoxels;
  double Turn = 1.0; ///< -1: the normals point the other way in voxels.
};
}

//------------------------------------------------------------------------------
std::vector<Index> VoxelizeLabels(const Surface& surface, const std::vector<BoundaryLabels>& labels,
  const VoxelGrid& grid, Index background, std::size_t axis)
{
  LabelVoxelizer voxelizer(grid, background, axis);
  voxelizer.Add(surface, labels);
  return voxelizer.Labels();
}

//------------------------------------------------------------------------------
std::int64_t CountWrongGridEdges(const Surface& surface, const std::vector<BoundaryLabels>& labels,
  const VoxelGrid& grid, const VoxelLabels& voxels, std::size_t axis)
{
  LabelVoxelizer voxelizer(grid, voxels.Background, axis);
  voxelizer.Add(surface, labels);
  return voxelizer.WrongEdges(voxels);
}
}
