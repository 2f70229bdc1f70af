// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OrientedBox.h
 * @brief A box along the longest edge of triangles that lie side by side, such as the needles of a
 * fan.
 */
#ifndef BoneDecimate_Core_Geometry_OrientedBox_h
#define BoneDecimate_Core_Geometry_OrientedBox_h

#include "TriangleGeometry.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bonedecimate
{
struct OrientedBox
{
  Vector3 Center = Vector3::Zero(); // mm
  std::array<Vector3, 3> Axes;      // unit vectors, the first one along the box
  std::array<double, 3> Half = {};  // mm, slightly enlarged

  /// The box of the points that visitPoints(add) passes to add.
  /// @param along The first axis; not 0.  @param normal The second axis is perpendicular to it.
  template <typename VisitPoints>
  OrientedBox(const Vector3& along, const Vector3& normal, const VisitPoints& visitPoints)
  {
    const Vector3 across = normal.cross(along);
    this->Axes[0] = along.normalized();
    this->Axes[1] =
      across.squaredNorm() > 0.0 ? across.normalized() : this->Axes[0].unitOrthogonal();
    this->Axes[2] = this->Axes[0].cross(this->Axes[1]);
    visitPoints([this](const Vector3& p) { this->Center = p; }); // any point serves as origin
    Vector3 low = Vector3::Zero();
    Vector3 high = Vector3::Zero();
    visitPoints(
      [&](const Vector3& p)
      {
        const Vector3 at = this->Coordinates(p);
        low = low.cwiseMin(at);
        high = high.cwiseMax(at);
      });
    constexpr double rounding = 1e-12;
    const double size = this->Center.cwiseAbs().maxCoeff() + (high - low).maxCoeff();
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto axis = static_cast<Eigen::Index>(i);
      this->Center += 0.5 * (low[axis] + high[axis]) * this->Axes[i];
      this->Half[i] = 0.5 * (high[axis] - low[axis]) + rounding * size;
    }
  }

  /// Whether the box is thin enough to be tighter than an axis-aligned one.
  bool IsThin() const { return 4.0 * std::max(this->Half[1], this->Half[2]) < this->Half[0]; }

  Vector3 Coordinates(const Vector3& p) const
  {
    const Vector3 offset = p - this->Center;
    return { Dot(offset, this->Axes[0]), Dot(offset, this->Axes[1]), Dot(offset, this->Axes[2]) };
  }

  double SquaredDistance(const Vector3& p) const // mm^2
  {
    const Vector3 half(this->Half[0], this->Half[1], this->Half[2]);
    return (this->Coordinates(p).cwiseAbs() - half).cwiseMax(0.0).squaredNorm();
  }

  /// mm, the length at which the ray enters the box; infinite if it misses the box.
  double EntryOf(const Vector3& from, const Vector3& direction) const
  {
    constexpr double least = 1e-30;
    const Vector3 at = this->Coordinates(from);
    double enters = 0.0;
    double leaves = Infinity;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double along = std::copysign(
        std::max(least, std::abs(Dot(direction, this->Axes[i]))), Dot(direction, this->Axes[i]));
      const double middle = -at[static_cast<Eigen::Index>(i)] / along;
      const double half = this->Half[i] / std::abs(along);
      enters = std::max(enters, middle - half);
      leaves = std::min(leaves, middle + half);
    }
    return enters <= leaves ? enters : Infinity;
  }
};
}

#endif
