// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "InputSize.h"

#include "Mesh/BoneSize.h"
#include "Options/NumberRange.h"
#include "Tolerances.h"

#include <algorithm>
#include <cstdio>

namespace bonedecimate
{
namespace
{
constexpr double LargestRatio = 0.25;  // of an error to the diagonal
constexpr double SmallestRatio = 1e-6; // the same

/// mm
double DiagonalOf(const std::vector<Vector3>& points)
{
  if (points.empty())
  {
    return 0.0;
  }
  Vector3 least = points.front();
  Vector3 most = points.front();
  for (const Vector3& p : points)
  {
    least = least.cwiseMin(p);
    most = most.cwiseMax(p);
  }
  return (most - least).norm();
}

std::string Millimeters(double length)
{
  char text[40];
  std::snprintf(text, sizeof(text), "%.6g mm", length);
  return text;
}

/// "the largest error of 50 mm"
std::string ErrorText(const SizeFigures& size)
{
  const std::string number = SentenceNumber(size.LargestError);
  return size.Point < 0
    ? "the largest error of " + number + " mm"
    : "the tolerance of " + number + " mm of point " + std::to_string(size.Point);
}
}

SizeFigures MeasureSize(
  const CleanSurface& clean, const Options& options, const std::vector<double>* tolerances)
{
  SizeFigures size;
  size.Diagonal = DiagonalOf(clean.Surface.Points);
  size.LargestError = options.MaximumError;
  if (options.MaximumError == 0.0 && tolerances != nullptr)
  {
    const std::vector<double> ofPoints = TolerancesOf(clean, *tolerances);
    const auto largest = std::max_element(ofPoints.begin(), ofPoints.end());
    if (largest != ofPoints.end() && *largest > 0.0)
    {
      size.LargestError = *largest;
      size.Point = clean.InputPoint[static_cast<std::size_t>(largest - ofPoints.begin())];
    }
  }
  size.ErrorBound = std::min(size.LargestError, size.Diagonal);
  return size;
}

//------------------------------------------------------------------------------
InputStatus CheckSize(const SizeFigures& size, const Options& options)
{
  if (size.LargestError > LargestRatio * size.Diagonal && !options.AllowLargeError)
  {
    return InputStatus::ErrorBeyondSize;
  }
  const bool isTooSmall =
    options.BoundsError() && size.Point < 0 && size.LargestError < SmallestRatio * size.Diagonal;
  return isTooSmall ? InputStatus::ErrorBelowSize : InputStatus::Good;
}

//------------------------------------------------------------------------------
std::string SizeMessage(const SizeFigures& size, InputStatus status)
{
  const std::string diagonal =
    " of the diagonal of the input's bounding box, " + Millimeters(size.Diagonal);
  return status == InputStatus::ErrorBeyondSize
    ? ErrorText(size) + " is more than a quarter" + diagonal +
      "; the coordinates may not be in millimeters (AllowLargeError runs anyway)"
    : ErrorText(size) + " is less than a millionth" + diagonal + "; rounding alone exceeds it";
}

//------------------------------------------------------------------------------
std::vector<std::string> SizeWarnings(const SizeFigures& size)
{
  std::vector<std::string> warnings;
  if (size.Diagonal > 0.0 && !IsBoneSize(size.Diagonal))
  {
    warnings.push_back("the diagonal of the input's bounding box is " + Millimeters(size.Diagonal) +
      ", which is not the size of a bone; the coordinates may not be in millimeters");
  }
  if (size.ErrorBound < size.LargestError)
  {
    warnings.push_back(ErrorText(size) +
      " is more than the diagonal of the input's bounding box; " + Millimeters(size.ErrorBound) +
      " was used");
  }
  return warnings;
}
}
