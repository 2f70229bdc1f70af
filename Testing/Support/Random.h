// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Random.h
 * @brief Random numbers that are the same on every system: std::uniform_* are not.
 */
#ifndef BoneDecimate_Testing_Random_h
#define BoneDecimate_Testing_Random_h

#include "Geometry/Surface.h"

#include <cstdint>

namespace bonedecimate::testsupport
{
/// Knuth's 64-bit linear congruential generator; the high bits are used.
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : State(seed * 2862933555777941757ULL + 3037000493ULL)
  {
  }

  /// 0 to 1, 1 not included.
  double Uniform()
  {
    this->State = this->State * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(this->State >> 11) / 9007199254740992.0;
  }

  double Between(double low, double high) { return low + (high - low) * this->Uniform(); }

  /// 0 to count - 1.
  Index Below(Index count) { return static_cast<Index>(this->Uniform() * count); }

  /// In the cube from -half to +half.
  Vector3 InCube(double half)
  {
    const double x = this->Between(-half, half);
    const double y = this->Between(-half, half);
    const double z = this->Between(-half, half);
    return { x, y, z };
  }

private:
  std::uint64_t State;
};
}

#endif
