// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Surface.h
 * @brief A triangle surface as two flat arrays: the input and the output of the core.
 */
#ifndef BoneDecimate_Core_Geometry_Surface_h
#define BoneDecimate_Core_Geometry_Surface_h

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace bonedecimate
{
/// A position or a direction; positions are in millimeters.
using Vector3 = Eigen::Vector3d;

/// The dot product, with the order of additions of Eigen 3. Eigen 5 uses another order, which would
/// change results.
inline double Dot(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + (a[1] * b[1] + a[2] * b[2]);
}

/// Larger than every distance, limit and cost.
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// mm, along each axis. Beyond it, products of areas would overflow.
constexpr double MaxCoordinate = 1e30;

/// Whether all coordinates are finite and not beyond MaxCoordinate.
inline bool IsUsable(const Vector3& point)
{
  return std::abs(point[0]) <= MaxCoordinate && std::abs(point[1]) <= MaxCoordinate &&
    std::abs(point[2]) <= MaxCoordinate;
}

/// Index of a point, a triangle or a half-edge; -1 means none.
using Index = std::int32_t;
/// No point, triangle or half-edge.
constexpr Index None = -1;

/// Three point indices, counter-clockwise as seen from outside of the bone.
using Triangle = std::array<Index, 3>;

/// Triangles with their points.
struct Surface
{
  std::vector<Vector3> Points;     ///< mm
  std::vector<Triangle> Triangles; ///< Each with indices of Points.
};
}

#endif
