// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Lanes.h
 * @brief Eight floats or four doubles computed side by side, with the same bits on every processor.
 *
 * Only + - * / sqrt and comparisons, which IEEE 754 fixes to the last bit; nothing is fused (-ffp-contract=off).
 * GCC and Clang turn the vector types into whatever the file is compiled for. Everything stands in an anonymous
 * namespace: each file that includes this is compiled for another processor and must not lend its code to the others.
 */
#ifndef BoneDecimate_Core_Kernels_Lanes_h
#define BoneDecimate_Core_Kernels_Lanes_h

#include <cstdint>
#include <cstring>

namespace bonedecimate
{
namespace
{
using Floats = float __attribute__((vector_size(32)));
using FloatMask = std::int32_t __attribute__((vector_size(32)));
using FourFloats = float __attribute__((vector_size(16)));
using Doubles = double __attribute__((vector_size(32)));
using DoubleMask = std::int64_t __attribute__((vector_size(32)));
constexpr int NumberOfFloats = 8;
constexpr int NumberOfDoubles = 4;

template <typename Lanes, typename Number>
inline Lanes Load(const Number* from)
{
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof(lanes));
  return lanes;
}
template <typename Lanes, typename Number>
inline void Store(const Lanes& lanes, Number* to)
{
  std::memcpy(to, &lanes, sizeof(lanes));
}
inline Floats Root(Floats x)
{
  for (int i = 0; i < NumberOfFloats; ++i)
  {
    x[i] = __builtin_sqrtf(x[i]);
  }
  return x;
}
inline Doubles Root(Doubles x)
{
  for (int i = 0; i < NumberOfDoubles; ++i)
  {
    x[i] = __builtin_sqrt(x[i]);
  }
  return x;
}
inline Floats Join(FourFloats first, FourFloats second)
{
  return __builtin_shufflevector(first, second, 0, 1, 2, 3, 4, 5, 6, 7);
}
template <typename Lanes>
inline Lanes Larger(Lanes a, Lanes b)
{
  return a > b ? a : b;
}
template <typename Lanes>
inline Lanes Smaller(Lanes a, Lanes b)
{
  return a < b ? a : b;
}
/// Turns eight rows of eight floats into eight columns.
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

/// Turns eight rows of four floats, the later four rows beside the earlier, into four columns of eight.
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

inline float LeastOf(Floats x)
{
  x = Smaller(x, __builtin_shufflevector(x, x, 4, 5, 6, 7, 0, 1, 2, 3));
  x = Smaller(x, __builtin_shufflevector(x, x, 2, 3, 0, 1, 6, 7, 4, 5));
  x = Smaller(x, __builtin_shufflevector(x, x, 1, 0, 3, 2, 5, 4, 7, 6));
  return x[0];
}
template <typename Mask>
inline bool Any(Mask mask)
{
  auto all = mask[0];
  for (int i = 1; i < static_cast<int>(sizeof(mask) / sizeof(all)); ++i)
  {
    all |= mask[i];
  }
  return all != 0;
}

template <typename Lanes>
struct Vectors
{
  Lanes X, Y, Z;
  Vectors operator-(const Vectors& o) const { return { X - o.X, Y - o.Y, Z - o.Z }; }
  Vectors operator+(const Vectors& o) const { return { X + o.X, Y + o.Y, Z + o.Z }; }
  Vectors operator*(Lanes s) const { return { X * s, Y * s, Z * s }; }
  Lanes Dot(const Vectors& o) const { return X * o.X + Y * o.Y + Z * o.Z; }
  Vectors Cross(const Vectors& o) const
  {
    return { Y * o.Z - Z * o.Y, Z * o.X - X * o.Z, X * o.Y - Y * o.X };
  }
};
template <typename Mask, typename Lanes>
inline Vectors<Lanes> Select(Mask mask, const Vectors<Lanes>& yes, const Vectors<Lanes>& no)
{
  return { mask ? yes.X : no.X, mask ? yes.Y : no.Y, mask ? yes.Z : no.Z };
}

/// A symmetric 3 x 3 matrix: xx xy xz yy yz zz.
template <typename Lanes>
struct Symmetric
{
  Lanes XX, XY, XZ, YY, YZ, ZZ;
  Vectors<Lanes> operator*(const Vectors<Lanes>& v) const
  {
    return { XX * v.X + XY * v.Y + XZ * v.Z, XY * v.X + YY * v.Y + YZ * v.Z,
      XZ * v.X + YZ * v.Y + ZZ * v.Z };
  }
  /// Determinant times the inverse.
  Symmetric Adjugate() const
  {
    return { YY * ZZ - YZ * YZ, XZ * YZ - XY * ZZ, XY * YZ - XZ * YY, XX * ZZ - XZ * XZ,
      XY * XZ - XX * YZ, XX * YY - XY * XY };
  }
  Lanes Determinant(const Symmetric& adjugate) const
  {
    return XX * adjugate.XX + XY * adjugate.XY + XZ * adjugate.XZ;
  }
};
}
}
#endif
