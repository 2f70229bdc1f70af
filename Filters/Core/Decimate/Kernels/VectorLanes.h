// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VectorLanes.h
 * @brief Lanes as vector types of GCC and Clang.
 */
#ifndef BoneDecimate_Core_Decimate_Kernels_VectorLanes_h
#define BoneDecimate_Core_Decimate_Kernels_VectorLanes_h

#include <cstdint>

namespace bonedecimate
{
namespace
{
using Floats = float __attribute__((vector_size(32)));
using FloatMask = std::int32_t __attribute__((vector_size(32)));
using FourFloats = float __attribute__((vector_size(16)));
using Doubles = double __attribute__((vector_size(32)));
using DoubleMask = std::int64_t __attribute__((vector_size(32)));

inline Floats Select(FloatMask mask, Floats yes, Floats no)
{
  return mask ? yes : no;
}
inline Doubles Select(DoubleMask mask, Doubles yes, Doubles no)
{
  return mask ? yes : no;
}
inline FourFloats ToFloats(Doubles x)
{
  return __builtin_convertvector(x, FourFloats);
}
inline Floats Root(Floats x)
{
  for (int i = 0; i < 8; ++i)
  {
    x[i] = __builtin_sqrtf(x[i]);
  }
  return x;
}
inline Doubles Root(Doubles x)
{
  for (int i = 0; i < 4; ++i)
  {
    x[i] = __builtin_sqrt(x[i]);
  }
  return x;
}
inline Floats Join(FourFloats first, FourFloats second)
{
  return __builtin_shufflevector(first, second, 0, 1, 2, 3, 4, 5, 6, 7);
}
inline double Root(double x)
{
  return __builtin_sqrt(x);
}
inline Floats Least(Floats a, Floats b)
{
  return a < b ? a : b;
}
/// Transposes eight rows of eight floats.
inline void Transpose(Floats (&r)[8])
{
  Floats a[8];
  for (int i = 0; i < 8; i += 2)
  {
    a[i] = __builtin_shufflevector(r[i], r[i + 1], 0, 8, 1, 9, 4, 12, 5, 13);
    a[i + 1] = __builtin_shufflevector(r[i], r[i + 1], 2, 10, 3, 11, 6, 14, 7, 15);
  }
  Floats b[8];
  for (int i = 0; i < 8; i += 4)
  {
    b[i] = __builtin_shufflevector(a[i], a[i + 2], 0, 1, 8, 9, 4, 5, 12, 13);
    b[i + 1] = __builtin_shufflevector(a[i], a[i + 2], 2, 3, 10, 11, 6, 7, 14, 15);
    b[i + 2] = __builtin_shufflevector(a[i + 1], a[i + 3], 0, 1, 8, 9, 4, 5, 12, 13);
    b[i + 3] = __builtin_shufflevector(a[i + 1], a[i + 3], 2, 3, 10, 11, 6, 7, 14, 15);
  }
  for (int i = 0; i < 4; ++i)
  {
    r[i] = __builtin_shufflevector(b[i], b[i + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    r[i + 4] = __builtin_shufflevector(b[i], b[i + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
}

/// Transposes eight rows of four floats into four columns of eight.
inline void TransposeHalves(Floats (&r)[4])
{
  const Floats a = __builtin_shufflevector(r[0], r[1], 0, 8, 1, 9, 4, 12, 5, 13);
  const Floats b = __builtin_shufflevector(r[0], r[1], 2, 10, 3, 11, 6, 14, 7, 15);
  const Floats c = __builtin_shufflevector(r[2], r[3], 0, 8, 1, 9, 4, 12, 5, 13);
  const Floats d = __builtin_shufflevector(r[2], r[3], 2, 10, 3, 11, 6, 14, 7, 15);
  r[0] = __builtin_shufflevector(a, c, 0, 1, 8, 9, 4, 5, 12, 13);
  r[1] = __builtin_shufflevector(a, c, 2, 3, 10, 11, 6, 7, 14, 15);
  r[2] = __builtin_shufflevector(b, d, 0, 1, 8, 9, 4, 5, 12, 13);
  r[3] = __builtin_shufflevector(b, d, 2, 3, 10, 11, 6, 7, 14, 15);
}

inline float MinOf(Floats x)
{
  x = Least(x, __builtin_shufflevector(x, x, 4, 5, 6, 7, 0, 1, 2, 3));
  x = Least(x, __builtin_shufflevector(x, x, 2, 3, 0, 1, 6, 7, 4, 5));
  x = Least(x, __builtin_shufflevector(x, x, 1, 0, 3, 2, 5, 4, 7, 6));
  return x[0];
}
}
}

#endif
