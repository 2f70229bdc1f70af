// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CielabColor.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate::volume
{
namespace
{
/// CIE 15: the inverse of the function from X / Xn to L*, a*, b*.
double FromCielab(double f)
{
  constexpr double bend = 6.0 / 29.0;
  return f > bend ? f * f * f : 3.0 * bend * bend * (f - 4.0 / 29.0);
}

/// IEC 61966-2-1.
double Encoded(double linear)
{
  const double value =
    linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
  return std::clamp(value, 0.0, 1.0);
}
}

std::array<double, 3> ColorOfCielab(const std::array<std::uint16_t, 3>& lab)
{
  constexpr double largest = 65535.0;
  const double f = (lab[0] * 100.0 / largest + 16.0) / 116.0;
  const double x = 0.950456 * FromCielab(f + (lab[1] * 255.0 / largest - 128.0) / 500.0);
  const double y = FromCielab(f);
  const double z = 1.088754 * FromCielab(f - (lab[2] * 255.0 / largest - 128.0) / 200.0);
  return { { Encoded(3.2404542 * x - 1.5371385 * y - 0.4985314 * z),
    Encoded(-0.9692660 * x + 1.8760108 * y + 0.0415560 * z),
    Encoded(0.0556434 * x - 0.2040259 * y + 1.0572252 * z) } };
}
}
