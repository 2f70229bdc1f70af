// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoundText.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace bonedecimate
{
namespace
{
/// Rounded to the nearest, and one step on if that is on the wrong side.
template <typename IsRight>
std::string RoundedText(double bound, int decimals, double direction, const IsRight& isRight)
{
  std::string text = FixedText(bound, decimals);
  const double step = std::pow(10.0, -decimals);
  if (std::isfinite(bound) && !isRight(std::strtod(text.c_str(), nullptr)))
  {
    text = FixedText(bound + direction * step, decimals);
  }
  return text;
}
}

std::string FixedText(double number, int decimals)
{
  char text[64];
  std::snprintf(text, sizeof(text), "%.*f", decimals, number);
  return text;
}

std::string LowerBoundText(double bound, int decimals)
{
  return RoundedText(bound, decimals, -1.0, [bound](double printed) { return printed <= bound; });
}

std::string UpperBoundText(double bound, int decimals)
{
  return RoundedText(bound, decimals, 1.0, [bound](double printed) { return printed >= bound; });
}
}
