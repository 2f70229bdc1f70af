// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NumberText.h"

#include "Figures/BoundText.h"

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

namespace bonedecimate
{
namespace
{
constexpr int DistanceDecimals = 4;

std::string Formatted(const char* format, int digits, double value)
{
  const int length = std::snprintf(nullptr, 0, format, digits, value);
  std::string text(static_cast<std::size_t>(length) + 1, '\0');
  std::snprintf(text.data(), text.size(), format, digits, value);
  text.pop_back();
  return text;
}
}

std::string GroupedText(double value, int decimals)
{
  std::string text = Formatted("%.*f", decimals, value);
  if (!std::isfinite(value))
  {
    return text;
  }
  const std::size_t first = text[0] == '-' ? 1 : 0;
  std::size_t position = text.find('.');
  position = position == std::string::npos ? text.size() : position;
  while (position > first + 3)
  {
    position -= 3;
    text.insert(position, ",");
  }
  return text;
}

std::string MillimeterText(double millimeters)
{
  const bool isTiny = millimeters > 0.0 && millimeters < 0.0005;
  return isTiny ? "< 0.001" : GroupedText(millimeters, 3);
}

std::string MeasuredText(double millimeters)
{
  const bool isTiny = millimeters > 0.0 && millimeters < 0.0001;
  return isTiny ? "< 0.0001" : LowerBoundText(millimeters, DistanceDecimals);
}

std::string BoundText(double millimeters)
{
  return UpperBoundText(millimeters, DistanceDecimals);
}

std::string SizeText(double value)
{
  const double size = std::abs(value);
  constexpr double leastWithDecimals = 1e-9;
  if (!(size < 10.0) || !(size > 0.0))
  {
    return GroupedText(value, 1);
  }
  // Rounding to three digits first: 9.999 is 10.0 and not 10.00.
  const double rounded = std::strtod(Formatted("%.*e", 2, size).c_str(), nullptr);
  const int decimals = 2 - static_cast<int>(std::floor(std::log10(rounded)));
  return size < leastWithDecimals ? Formatted("%.*e", 2, value) : GroupedText(value, decimals);
}

std::string ShortText(double value)
{
  return Formatted("%.*g", 4, value);
}

double RoundUp(double value, std::initializer_list<double> steps)
{
  const double unit = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : steps)
  {
    // The slack keeps 0.3 at 0.3 although it is not a multiple of 0.1 in binary.
    if (value <= step * unit * (1.0 + 1e-9))
    {
      return step * unit;
    }
  }
  return 10.0 * unit;
}
}
