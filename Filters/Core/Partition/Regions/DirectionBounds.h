// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DirectionBounds.h
 * @brief A convex bound of points: between 13 pairs of parallel planes, normal to the axes and the
 * diagonals of a cube.
 *
 * J. T. Klosowski, M. Held, J. S. B. Mitchell, H. Sowizral, K. Zikan, Efficient collision detection
 * using bounding volume hierarchies of k-DOPs, 1998.
 */
#ifndef BoneDecimate_Core_Partition_Regions_DirectionBounds_h
#define BoneDecimate_Core_Partition_Regions_DirectionBounds_h

#include "Geometry/Surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace bonedecimate
{
class DirectionBounds
{
public:
  DirectionBounds()
  {
    this->Low.fill(std::numeric_limits<double>::infinity());
    this->High.fill(-std::numeric_limits<double>::infinity());
  }

  void Add(const Vector3& point)
  {
    for (std::size_t k = 0; k < Count; ++k)
    {
      const double along = Along(k, point);
      this->Low[k] = std::min(this->Low[k], along);
      this->High[k] = std::max(this->High[k], along);
    }
  }

  void Add(const DirectionBounds& other)
  {
    for (std::size_t k = 0; k < Count; ++k)
    {
      this->Low[k] = std::min(this->Low[k], other.Low[k]);
      this->High[k] = std::max(this->High[k], other.High[k]);
    }
  }

  /// False only if everything between the planes is farther away than reach, mm.
  bool MayBeNear(const DirectionBounds& other, double reach) const
  {
    bool isNear = true;
    for (std::size_t k = 0; k < Count && isNear; ++k)
    {
      isNear = this->IsNearAlong(k, other.Low[k], other.High[k], reach);
    }
    return isNear;
  }
  bool MayBeNear(const std::array<Vector3, 3>& triangle, double reach) const
  {
    bool isNear = true;
    for (std::size_t k = 0; k < Count && isNear; ++k)
    {
      const auto [low, high] =
        std::minmax({ Along(k, triangle[0]), Along(k, triangle[1]), Along(k, triangle[2]) });
      isNear = this->IsNearAlong(k, low, high, reach);
    }
    return isNear;
  }

private:
  static constexpr std::size_t Count = 13;
  static constexpr double Directions[Count][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 1, 0 }, { 1, -1, 0 }, { 1, 0, 1 }, { 1, 0, -1 }, { 0, 1, 1 }, { 0, 1, -1 }, { 1, 1, 1 },
    { 1, 1, -1 }, { 1, -1, 1 }, { -1, 1, 1 } };

  /// mm times the length of the direction.
  static double Along(std::size_t k, const Vector3& point)
  {
    const double* d = Directions[k];
    return d[0] * point[0] + d[1] * point[1] + d[2] * point[2];
  }

  bool IsNearAlong(std::size_t k, double low, double high, double reach) const
  {
    const double length = k < 3 ? 1.0 : k < 9 ? std::sqrt(2.0) : std::sqrt(3.0);
    return low <= this->High[k] + length * reach && high >= this->Low[k] - length * reach;
  }

  std::array<double, Count> Low, High;
};
}

#endif
