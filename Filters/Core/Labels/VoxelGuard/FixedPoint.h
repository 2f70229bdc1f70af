// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FixedPoint.h
 * @brief Steps of a grid (VoxelGrid.h) as integers of 2^-30 step, so that voxel centers, sums and
 * differences are exact.
 */
#ifndef BoneDecimate_Core_Labels_VoxelGuard_FixedPoint_h
#define BoneDecimate_Core_Labels_VoxelGuard_FixedPoint_h

#include "Labels/LabelMap/VoxelGrid.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace bonedecimate
{
constexpr int FractionBits = 30;
constexpr std::int64_t UnitsOfVoxel = std::int64_t{ 1 } << FractionBits;

using FixedPoint = std::array<std::int64_t, 3>;
using FixedTriangle = std::array<FixedPoint, 3>;

/// The index of the first voxel center at or above a coordinate.
inline std::int64_t CenterAtOrAbove(std::int64_t coordinate)
{
  return (coordinate + UnitsOfVoxel - 1) >> FractionBits;
}

/// The index of the last voxel center at or below a coordinate.
inline std::int64_t CenterAtOrBelow(std::int64_t coordinate)
{
  return coordinate >> FractionBits;
}

/// Converts positions in mm.
class FixedPointFrame
{
public:
  FixedPointFrame() = default;
  explicit FixedPointFrame(const VoxelGrid& grid)
    : Origin(grid.Origin)
    , UnitsPerMillimeter(
        (static_cast<double>(UnitsOfVoxel) * grid.Spacing.cwiseInverse()).asDiagonal() *
        grid.InverseDirection())
  {
  }

  /// Positions farther away than 2^31 voxels are moved to this distance, between voxel centers.
  FixedPoint Convert(const Vector3& position) const
  {
    constexpr double farthest =
      static_cast<double>(UnitsOfVoxel) * UnitsOfVoxel * 2.0 + 0.5 * UnitsOfVoxel;
    const Vector3 units = this->UnitsPerMillimeter * (position - this->Origin);
    FixedPoint fixed;
    for (int k = 0; k < 3; ++k)
    {
      const double unit = std::clamp(units[k], -farthest, farthest);
      fixed[static_cast<std::size_t>(k)] =
        static_cast<std::int64_t>(unit + (unit < 0.0 ? -0.5 : 0.5));
    }
    return fixed;
  }

private:
  Vector3 Origin = Vector3::Zero(); // mm
  Eigen::Matrix3d UnitsPerMillimeter = Eigen::Matrix3d::Identity();
};

/// The bounding box of points.
struct FixedBox
{
  FixedPoint Low{};
  FixedPoint High{};

  explicit FixedBox(const FixedPoint& point)
    : Low(point)
    , High(point)
  {
  }
  void Add(const FixedPoint& point)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      this->Low[k] = std::min(this->Low[k], point[k]);
      this->High[k] = std::max(this->High[k], point[k]);
    }
  }
  void Add(const FixedBox& box)
  {
    this->Add(box.Low);
    this->Add(box.High);
  }
  void Grow(std::int64_t by)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      this->Low[k] -= by;
      this->High[k] += by;
    }
  }
  /// Length of the longest side.
  std::int64_t Size() const
  {
    return std::max(
      { this->High[0] - this->Low[0], this->High[1] - this->Low[1], this->High[2] - this->Low[2] });
  }
};
}

#endif
