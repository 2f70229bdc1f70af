// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FanLanes.h
 * @brief A part of KernelSet.h: the corners and faces of a fan, four at a time.
 */
#ifndef BoneDecimate_Core_Decimate_Kernels_FanLanes_h
#define BoneDecimate_Core_Decimate_Kernels_FanLanes_h

#include "Lanes.h"

#include <cstdint>

namespace bonedecimate
{
namespace
{
inline Vectors<Doubles> LoadVectors(double* const (&from)[3], int at)
{
  return { Load<Doubles>(from[0] + at), Load<Doubles>(from[1] + at), Load<Doubles>(from[2] + at) };
}
inline void StoreVectors(const Vectors<Doubles>& v, double* const (&to)[3], int at)
{
  Store(v.X, to[0] + at);
  Store(v.Y, to[1] + at);
  Store(v.Z, to[2] + at);
}
inline Vectors<Doubles> All(const double (&v)[3])
{
  const Doubles zero = {};
  return { zero + v[0], zero + v[1], zero + v[2] };
}
/// Marks the lanes that hold a face of the fan.
inline DoubleMask IsFace(int at, int faces)
{
  const DoubleMask lane = { 0, 1, 2, 3 };
  return lane < static_cast<std::int64_t>(faces - at);
}
}
}

#endif
