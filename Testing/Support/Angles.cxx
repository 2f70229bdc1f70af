// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Angles.h"

#include <cmath>

namespace bonedecimate::testsupport
{
namespace
{
/// A sum of two doubles, the second at most half of the last bit of the first.
/// T. J. Dekker, A floating-point technique for extending the available precision, 1971.
struct Double2
{
  double High, Low;
};

Double2 TwoSum(double a, double b)
{
  const double sum = a + b;
  const double second = sum - a;
  return { sum, (a - (sum - second)) + (b - second) };
}

Double2 Split(double a)
{
  const double scaled = 134217729.0 * a; // 2^27 + 1
  const double high = scaled - (scaled - a);
  return { high, a - high };
}

Double2 TwoProduct(double a, double b)
{
  const double product = a * b;
  const Double2 x = Split(a);
  const Double2 y = Split(b);
  return { product,
    ((x.High * y.High - product) + x.High * y.Low + x.Low * y.High) + x.Low * y.Low };
}

Double2 operator+(const Double2& a, const Double2& b)
{
  const Double2 sum = TwoSum(a.High, b.High);
  return TwoSum(sum.High, sum.Low + (a.Low + b.Low));
}

Double2 operator*(const Double2& a, const Double2& b)
{
  const Double2 product = TwoProduct(a.High, b.High);
  return TwoSum(product.High, product.Low + (a.High * b.Low + a.Low * b.High));
}

Double2 operator/(const Double2& a, double b)
{
  const double quotient = a.High / b;
  const Double2 back = TwoProduct(quotient, b);
  return TwoSum(quotient, ((a.High - back.High) - back.Low + a.Low) / b);
}

/// The Taylor series from x^first / first! on, for |x| up to pi / 4.
double Series(const Double2& x, int first)
{
  Double2 term = first == 0 ? Double2{ 1.0, 0.0 } : x;
  Double2 sum = term;
  const Double2 square = x * x;
  for (int i = first + 2; i < 32; i += 2)
  {
    term = term * square / (-1.0 * i * (i - 1));
    sum = sum + term;
  }
  return sum.High;
}

/// Sine of the angle plus so many right angles.
double SineOf(double angle, int rightAngles)
{
  // pi / 2 in three parts
  constexpr double parts[3] = { 0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54,
    -0x1.f1976b7ed8fbcp-110 };
  const double turns = std::floor(angle / parts[0] + 0.5);
  Double2 rest = { angle, 0.0 };
  for (const double part : parts)
  {
    rest = rest + TwoProduct(-turns, part);
  }
  const int quarter = (static_cast<int>(turns) + rightAngles) & 3;
  const double value = Series(rest, quarter % 2 == 0 ? 1 : 0);
  return quarter < 2 ? value : -value;
}
}

//------------------------------------------------------------------------------
double Cosine(double angle)
{
  return SineOf(angle, 1);
}

//------------------------------------------------------------------------------
double Sine(double angle)
{
  return SineOf(angle, 0);
}
}
