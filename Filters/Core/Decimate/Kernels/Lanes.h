// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Lanes.h
 * @brief Vectors of eight floats or four doubles, with the same bits on every processor.
 *
 * The operations are + - * / sqrt and comparisons, which IEEE 754 defines to the last bit; none are
 * fused (-ffp-contract=off). Everything is in an anonymous namespace: each including file is
 * compiled for another processor, and the linker must not merge their functions.
 */
#ifndef BoneDecimate_Core_Decimate_Kernels_Lanes_h
#define BoneDecimate_Core_Decimate_Kernels_Lanes_h

#ifndef __has_builtin
#define __has_builtin(name) 0
#endif
#if !defined(BONEDECIMATE_PLAIN_LANES) && __has_builtin(__builtin_shufflevector)
#include "VectorLanes.h"
#else
#include "PlainLanes.h"
#endif

#include <cstring>

namespace bonedecimate
{
namespace
{
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
template <typename Lanes>
inline Lanes Larger(Lanes a, Lanes b)
{
  return Select(a > b, a, b);
}
template <typename Lanes>
inline Lanes Smaller(Lanes a, Lanes b)
{
  return Select(a < b, a, b);
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
  return { Select(mask, yes.X, no.X), Select(mask, yes.Y, no.Y), Select(mask, yes.Z, no.Z) };
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
  /// The inverse times the determinant.
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
