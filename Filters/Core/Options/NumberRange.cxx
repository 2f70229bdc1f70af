// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NumberRange.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace bonedecimate
{
std::string NumberText(double value)
{
  if (std::isnan(value))
  {
    return "NaN";
  }
  if (std::isinf(value))
  {
    return value < 0.0 ? "-infinity" : "infinity";
  }
  char digits[40];
  for (int count = 6; count <= 17; ++count)
  {
    std::snprintf(digits, sizeof(digits), "%.*g", count, value);
    if (std::strtod(digits, nullptr) == value)
    {
      break;
    }
  }
  std::string text = digits;
  std::replace(text.begin(), text.end(), ',', '.'); // of the locale
  return text;
}

std::string SentenceNumber(double value)
{
  std::string text = NumberText(value);
  const std::size_t plus = text.find('+');
  return plus == std::string::npos ? text : text.erase(plus, 1);
}

std::string EndsText(const NumberRange& range)
{
  return SentenceNumber(range.Minimum) + " to " + SentenceNumber(range.Maximum);
}

std::string RangeText(const NumberRange& range)
{
  return (range.IsWhole ? "a whole number from " : "a number from ") + EndsText(range) +
    (range.Unit.empty() ? "" : " " + range.Unit);
}

bool IsInRange(const NumberRange& range, double value)
{
  const bool isBetween = value >= range.Minimum && value <= range.Maximum;
  return isBetween && (!range.IsWhole || value == std::floor(value));
}

std::string CheckNumber(const std::string& name, const NumberRange& range, double value)
{
  return IsInRange(range, value)
    ? std::string()
    : name + " takes " + RangeText(range) + ", not " + SentenceNumber(value);
}
}
