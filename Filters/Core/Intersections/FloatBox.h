// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FloatBox.h
 * @brief Boxes of half the memory, to reject most of what is not near.
 */
#ifndef BoneDecimate_Core_Intersections_FloatBox_h
#define BoneDecimate_Core_Intersections_FloatBox_h

#include "TrianglePair.h"

#include <array>
#include <limits>

namespace bonedecimate
{
constexpr float FloatInfinity = std::numeric_limits<float>::infinity();

/// mm, a little too large.
struct FloatBox
{
  std::array<float, 3> Low, High;

  /// Empty.
  FloatBox();
  /// @param reach mm, by which the box is larger.
  explicit FloatBox(const TriangleCorners& corners, double reach = 0.0);
  void Add(const FloatBox& other);
  bool Meets(const FloatBox& other) const
  {
    return this->Low[0] <= other.High[0] && other.Low[0] <= this->High[0] &&
      this->Low[1] <= other.High[1] && other.Low[1] <= this->High[1] &&
      this->Low[2] <= other.High[2] && other.Low[2] <= this->High[2];
  }
};
}

#endif
