// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Zone.h
 * @brief The space between two parallel planes.
 */
#ifndef BoneDecimate_Core_Geometry_Zone_h
#define BoneDecimate_Core_Geometry_Zone_h

#include "Surface.h"

#include <algorithm>
#include <array>

namespace bonedecimate
{
struct Zone
{
  Vector3 Direction = Vector3::UnitZ(); ///< Unit vector.
  double Low = 0.0;                     ///< mm along the direction
  double High = 0.0;                    ///< mm

  /// Whether the position lies strictly between the planes.
  bool Contains(const Vector3& position) const
  {
    const double along = Dot(this->Direction, position);
    return along > this->Low && along < this->High;
  }

  /// Whether a part of the convex hull of the points is within the distance of the zone.
  /// @param distance mm
  template <std::size_t Count>
  bool MayReach(const std::array<Vector3, Count>& points, double distance) const
  {
    double low = Dot(this->Direction, points[0]);
    double high = low;
    for (const Vector3& p : points)
    {
      const double along = Dot(this->Direction, p);
      low = std::min(low, along);
      high = std::max(high, along);
    }
    return high >= this->Low - distance && low <= this->High + distance;
  }
};
}

#endif
