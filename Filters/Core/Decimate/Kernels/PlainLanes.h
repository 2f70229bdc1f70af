// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlainLanes.h
 * @brief Lanes in plain C++, for compilers without vector types; the same bits as theirs.
 */
#ifndef BoneDecimate_Core_Decimate_Kernels_PlainLanes_h
#define BoneDecimate_Core_Decimate_Kernels_PlainLanes_h

#include <cmath>
#include <cstdint>
#include <type_traits>

namespace bonedecimate
{
namespace
{
template <typename Number, int Size>
struct Pack
{
  using Mask = Pack<std::conditional_t<sizeof(Number) == 4, std::int32_t, std::int64_t>, Size>;
  Number At[Size];

  Number& operator[](int i) { return this->At[i]; }
  Number operator[](int i) const { return this->At[i]; }

  static Pack All(Number number)
  {
    Pack all;
    for (Number& at : all.At)
    {
      at = number;
    }
    return all;
  }
  template <typename Result = Pack, typename Operation>
  static Result Each(const Pack& a, const Pack& b, const Operation& operation)
  {
    Result result;
    for (int i = 0; i < Size; ++i)
    {
      result.At[i] = operation(a.At[i], b.At[i]);
    }
    return result;
  }
  template <typename Comparison>
  static Mask Where(const Pack& a, const Pack& b, const Comparison& comparison)
  {
    return Each<Mask>(a, b, [&](Number x, Number y) { return comparison(x, y) ? -1 : 0; });
  }
  friend Pack operator+(const Pack& a, const Pack& b)
  {
    return Each(a, b, [](Number x, Number y) { return x + y; });
  }
  friend Pack operator+(const Pack& a, Number b) { return a + All(b); }
  friend Pack operator+(Number a, const Pack& b) { return All(a) + b; }
  friend Pack operator-(const Pack& a, const Pack& b)
  {
    return Each(a, b, [](Number x, Number y) { return x - y; });
  }
  friend Pack operator-(const Pack& a, Number b) { return a - All(b); }
  friend Pack operator-(Number a, const Pack& b) { return All(a) - b; }
  friend Pack operator*(const Pack& a, const Pack& b)
  {
    return Each(a, b, [](Number x, Number y) { return x * y; });
  }
  friend Pack operator*(const Pack& a, Number b) { return a * All(b); }
  friend Pack operator*(Number a, const Pack& b) { return All(a) * b; }
  friend Pack operator/(const Pack& a, const Pack& b)
  {
    return Each(a, b, [](Number x, Number y) { return x / y; });
  }
  friend Pack operator/(const Pack& a, Number b) { return a / All(b); }
  friend Pack operator/(Number a, const Pack& b) { return All(a) / b; }
  friend Mask operator<(const Pack& a, const Pack& b)
  {
    return Where(a, b, [](Number x, Number y) { return x < y; });
  }
  friend Mask operator<(const Pack& a, Number b) { return a < All(b); }
  friend Mask operator<=(const Pack& a, const Pack& b)
  {
    return Where(a, b, [](Number x, Number y) { return x <= y; });
  }
  friend Mask operator<=(const Pack& a, Number b) { return a <= All(b); }
  friend Mask operator>(const Pack& a, const Pack& b)
  {
    return Where(a, b, [](Number x, Number y) { return x > y; });
  }
  friend Mask operator>(const Pack& a, Number b) { return a > All(b); }
  friend Mask operator>=(const Pack& a, const Pack& b)
  {
    return Where(a, b, [](Number x, Number y) { return x >= y; });
  }
  friend Mask operator>=(const Pack& a, Number b) { return a >= All(b); }
  friend Mask operator==(const Pack& a, const Pack& b)
  {
    return Where(a, b, [](Number x, Number y) { return x == y; });
  }
  friend Mask operator==(const Pack& a, Number b) { return a == All(b); }
  friend Mask operator!=(const Pack& a, const Pack& b)
  {
    return Where(a, b, [](Number x, Number y) { return x != y; });
  }
  friend Mask operator!=(const Pack& a, Number b) { return a != All(b); }
  friend Pack operator&(const Pack& a, const Pack& b)
  {
    return Each(a, b, [](Number x, Number y) { return x & y; });
  }
  friend Pack operator|(const Pack& a, const Pack& b)
  {
    return Each(a, b, [](Number x, Number y) { return x | y; });
  }
  friend Pack operator~(const Pack& a)
  {
    return Each(a, a, [](Number x, Number) { return ~x; });
  }
  Pack& operator+=(const Pack& b) { return *this = *this + b; }
  Pack& operator|=(const Pack& b) { return *this = *this | b; }
};

using Floats = Pack<float, 8>;
using FloatMask = Floats::Mask;
using FourFloats = Pack<float, 4>;
using Doubles = Pack<double, 4>;
using DoubleMask = Doubles::Mask;

template <typename Number, int Size>
inline Pack<Number, Size> Select(const typename Pack<Number, Size>::Mask& mask,
  const Pack<Number, Size>& yes, const Pack<Number, Size>& no)
{
  Pack<Number, Size> result;
  for (int i = 0; i < Size; ++i)
  {
    result.At[i] = mask.At[i] != 0 ? yes.At[i] : no.At[i];
  }
  return result;
}
inline FourFloats ToFloats(const Doubles& x)
{
  return { { static_cast<float>(x.At[0]), static_cast<float>(x.At[1]), static_cast<float>(x.At[2]),
    static_cast<float>(x.At[3]) } };
}
template <typename Number, int Size>
inline Pack<Number, Size> Root(Pack<Number, Size> x)
{
  for (Number& at : x.At)
  {
    at = std::sqrt(at);
  }
  return x;
}
inline double Root(double x)
{
  return std::sqrt(x);
}
inline Floats Join(const FourFloats& first, const FourFloats& second)
{
  Floats joined;
  for (int i = 0; i < 4; ++i)
  {
    joined.At[i] = first.At[i];
    joined.At[i + 4] = second.At[i];
  }
  return joined;
}
/// Transposes eight rows of eight floats.
inline void Transpose(Floats (&r)[8])
{
  for (int i = 0; i < 8; ++i)
  {
    for (int k = 0; k < i; ++k)
    {
      const float swapped = r[i].At[k];
      r[i].At[k] = r[k].At[i];
      r[k].At[i] = swapped;
    }
  }
}
/// Transposes eight rows of four floats into four columns of eight.
inline void TransposeHalves(Floats (&r)[4])
{
  Floats columns[4];
  for (int i = 0; i < 4; ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      columns[k].At[i] = r[i].At[k];
      columns[k].At[i + 4] = r[i].At[k + 4];
    }
  }
  for (int k = 0; k < 4; ++k)
  {
    r[k] = columns[k];
  }
}
inline float MinOf(const Floats& x)
{
  float least = x.At[0];
  for (const float at : x.At)
  {
    least = at < least ? at : least;
  }
  return least;
}
}
}

#endif
