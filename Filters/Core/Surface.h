// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Surface.h
 * @brief A triangle surface as two flat arrays: what goes into the core and what comes out.
 */
#ifndef BoneDecimate_Core_Surface_h
#define BoneDecimate_Core_Surface_h

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace bonedecimate
{
/// A position or a direction; positions are in millimetres.
using Vector3 = Eigen::Vector3d;

/// mm, of each axis: products of areas do not overflow up to here.
constexpr double LargestCoordinate = 1e30;

/// Finite and not beyond the largest coordinate.
inline bool IsUsable(const Vector3& point)
{
  return std::abs(point[0]) <= LargestCoordinate && std::abs(point[1]) <= LargestCoordinate &&
    std::abs(point[2]) <= LargestCoordinate;
}

/// Index of a point, a triangle or a half-edge; -1 means none.
using Index = std::int32_t;
constexpr Index None = -1;

/// Three point indices, counter-clockwise seen from outside the bone.
using Triangle = std::array<Index, 3>;

struct Surface
{
  std::vector<Vector3> Points; ///< mm
  std::vector<Triangle> Triangles;
};
}

#endif
