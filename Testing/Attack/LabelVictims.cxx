// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelVictims.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace bonedecimate::testsupport
{
namespace
{
using Voxel = std::array<Index, 3>;

constexpr Index LeastSize = 2; // voxels
constexpr Index MostSize = 10;
constexpr Index MostSizeOfNoise = 6;
constexpr Index MostLabels = 4; // besides the background

Voxel AnySize(Random& random, Index most)
{
  const auto any = [&] { return LeastSize + random.Below(most - LeastSize + 1); };
  const Index x = any();
  const Index y = any();
  return { x, y, any() };
}

Vector3 PositionOf(const Voxel& voxel)
{
  return { static_cast<double>(voxel[0]), static_cast<double>(voxel[1]),
    static_cast<double>(voxel[2]) };
}

LabelMap Noise(Random& random)
{
  const Index labels = 1 + random.Below(MostLabels);
  const double fraction = random.Between(0.05, 0.95); // of the background
  return MakeLabelMap(AnySize(random, MostSizeOfNoise),
    [&](const Voxel&) { return random.Uniform() < fraction ? 0 : 1 + random.Below(labels); });
}

/// Plates of one or two voxels along an axis or tilted, with gaps of one or two voxels or none.
LabelMap Plates(Random& random)
{
  Vector3 normal = Vector3::Unit(random.Below(3));
  normal += random.Below(2) == 0 ? Vector3(Vector3::Zero()) : random.InCube(0.5);
  const double thickness = 1 + random.Below(2);
  const double period = thickness + random.Below(3);
  const Index labels = 1 + random.Below(MostLabels);
  const double from = random.Between(0.0, 2.0);
  return MakeLabelMap(AnySize(random, MostSize),
    [&](const Voxel& voxel)
    {
      const double at = (normal.dot(PositionOf(voxel)) + 20.0 * period - from) / period;
      const double inPeriod = (at - std::floor(at)) * period;
      return inPeriod < thickness ? 1 + static_cast<Index>(std::floor(at)) % labels : 0;
    });
}

/// An ellipsoid; each voxel has the label of the nearest of some points.
LabelMap Touching(Random& random)
{
  const Voxel size = AnySize(random, MostSize);
  const Vector3 middle = 0.5 * (PositionOf(size) - Vector3::Ones());
  std::vector<Vector3> seeds(static_cast<std::size_t>(1 + random.Below(MostLabels)));
  for (Vector3& seed : seeds)
  {
    seed = middle + random.InCube(0.5).cwiseProduct(PositionOf(size));
  }
  const double reach = random.Between(0.6, 2.0);
  return MakeLabelMap(size,
    [&](const Voxel& voxel)
    {
      const Vector3 at = PositionOf(voxel);
      const bool isInside =
        (at - middle).cwiseQuotient(middle + Vector3::Constant(0.5)).squaredNorm() < reach;
      const auto nearest = std::min_element(seeds.begin(), seeds.end(),
        [&](const Vector3& a, const Vector3& b)
        { return (a - at).squaredNorm() < (b - at).squaredNorm(); });
      return isInside ? 1 + static_cast<Index>(nearest - seeds.begin()) : 0;
    });
}

/// Balls in shells: walls at one voxel's distance.
LabelMap Shells(Random& random)
{
  const Voxel size = AnySize(random, MostSize);
  const Vector3 center = 0.5 * (PositionOf(size) - Vector3::Ones()) + random.InCube(1.0);
  const double width = random.Between(0.9, 1.6);
  const Index labels = 1 + random.Below(MostLabels);
  return MakeLabelMap(size,
    [&](const Voxel& voxel)
    {
      const Index shell =
        static_cast<Index>(std::floor((PositionOf(voxel) - center).norm() / width));
      return shell % 2 == 0 ? 0 : 1 + shell / 2 % labels;
    });
}

/// A block with slits of one voxel, which are background or another label.
LabelMap Slits(Random& random)
{
  const Voxel size = AnySize(random, MostSize);
  const auto axis = static_cast<std::size_t>(random.Below(3));
  const auto other = (axis + 1) % 3;
  const Index slit = random.Below(size[axis]);
  const Index end = random.Below(size[other] + 2);
  const Index inSlit = random.Below(3);
  const Index frame = random.Below(2);
  return MakeLabelMap(size,
    [&](const Voxel& voxel)
    {
      const bool isFrame =
        std::any_of(voxel.begin(), voxel.end(), [&](Index i) { return i < frame; });
      return isFrame                                     ? 0
        : voxel[axis] == slit && voxel[other] < end      ? inSlit
        : voxel[axis] == slit + 2 && voxel[other] >= end ? 0
                                                         : 1;
    });
}

void AddNoise(Random& random, LabelMap& map)
{
  const double fraction = random.Between(0.0, 0.15);
  const Index labels = *std::max_element(map.Labels.begin(), map.Labels.end()) + 1;
  for (std::int32_t& label : map.Labels)
  {
    label = random.Uniform() < fraction ? random.Below(labels) : label;
  }
}

Vector3 AnySpacing(Random& random)
{
  switch (random.Below(3))
  {
    case 0:
      return Vector3::Ones();
    case 1:
      return Vector3::Ones() + random.InCube(0.7);
    default:
    {
      Vector3 spacing = Vector3::Ones(); // thick slices
      spacing[random.Below(3)] = random.Between(2.0, 6.0);
      return spacing;
    }
  }
}

void PutAnywhere(Random& random, VoxelGrid& grid)
{
  const double side = std::pow(10.0, random.Between(-1.0, 1.0));
  grid.Spacing = side * AnySpacing(random);
  if (random.Below(2) == 0)
  {
    const double angle = random.Between(-3.0, 3.0);
    const Vector3 axis = random.InCube(1.0) + Vector3(0.0, 0.0, 2.0);
    grid.Direction = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
  }
  if (random.Below(4) == 0)
  {
    grid.Direction.col(random.Below(3)) *= -1.0;
  }
  if (random.Below(4) == 0) // the gantry was tilted
  {
    const Vector3 tilt = 0.5 * random.InCube(1.0);
    grid.Direction.col(2) = (grid.Direction.col(2) + tilt).normalized();
  }
  if (random.Below(4) == 0 && grid.Dimensions[2] > 1)
  {
    grid.Layers = { 0.0 };
    const double most = random.Between(1.1, 4.0);
    for (Index k = 1; k < grid.Dimensions[2]; ++k)
    {
      const double ratio = random.Below(2) == 0 ? 1.0 : random.Between(1.0, most);
      grid.Layers.push_back(grid.Layers.back() + ratio * grid.Spacing[2]);
    }
  }
  if (random.Below(3) != 0)
  {
    grid.Origin = random.InCube(side * std::pow(10.0, random.Between(0.0, 5.0)));
  }
}
}

LabelMap AnyLabelMap(Random& random)
{
  static const std::array<LabelMap (*)(Random&), 5> makers = { Noise, Plates, Touching, Shells,
    Slits };
  LabelMap map =
    makers[static_cast<std::size_t>(random.Below(static_cast<Index>(makers.size())))](random);
  if (random.Below(2) == 0)
  {
    AddNoise(random, map);
  }
  PutAnywhere(random, map.Grid);
  return map;
}
}
