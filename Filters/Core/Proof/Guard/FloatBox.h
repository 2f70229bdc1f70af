// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FloatBox.h
 * @brief Boxes in single precision, half the memory, to reject most of what is not near.
 */
#ifndef BoneDecimate_Core_Proof_Guard_FloatBox_h
#define BoneDecimate_Core_Proof_Guard_FloatBox_h

#include "TrianglePair.h"

#include <array>
#include <limits>

namespace bonedecimate
{
constexpr float FloatInfinity = std::numeric_limits<float>::infinity();

/// Bounds in mm, rounded outward.
struct FloatBox
{
  std::array<float, 3> Low, High;

  /// An empty box.
  FloatBox();
  /// @param reach mm, by which the box is larger on all sides.
  explicit FloatBox(const TriangleCorners& corners, double reach = 0.0);
  void Add(const FloatBox& other);
  /// @param reach mm, by which the new box is larger on all sides.
  FloatBox Grown(double reach) const;
  double Diagonal() const; ///< mm.
  /// mm, a lower bound; 0 if the boxes meet.
  double DistanceTo(const FloatBox& other) const;
  /// Whether two boxes meet. Without branches, because most compared boxes are near each other.
  bool Meets(const FloatBox& other) const
  {
    unsigned meets = 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      meets &= static_cast<unsigned>(this->Low[axis] <= other.High[axis]);
      meets &= static_cast<unsigned>(other.Low[axis] <= this->High[axis]);
    }
    return meets != 0;
  }
};
}

#endif
