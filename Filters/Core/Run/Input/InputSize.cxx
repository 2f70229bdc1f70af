// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "InputSize.h"

#include "Mesh/BoneSize.h"
#include "Tolerances.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
constexpr double MinRatio = 1e-6; // of an error to the diagonal
}

SizeFigures MeasureSize(
  const CleanSurface& clean, const Options& options, const std::vector<double>* tolerances)
{
  SizeFigures size;
  size.Diagonal = DiagonalOf(clean.Surface.Points);
  size.MaxError = options.MaximumError;
  if (options.MaximumError == 0.0 && tolerances != nullptr)
  {
    const std::vector<double> ofPoints = TolerancesOf(clean, *tolerances);
    const auto largest = std::max_element(ofPoints.begin(), ofPoints.end());
    if (largest != ofPoints.end() && *largest > 0.0)
    {
      size.MaxError = *largest;
      size.Point = clean.InputPoint[static_cast<std::size_t>(largest - ofPoints.begin())];
    }
  }
  size.ErrorBound = std::min(size.MaxError, size.Diagonal);
  return size;
}

//------------------------------------------------------------------------------
InputStatus CheckSize(const SizeFigures& size, const Options& options)
{
  if (size.MaxError > LargestErrorRatio * size.Diagonal && !options.AllowLargeError)
  {
    return InputStatus::ErrorBeyondSize;
  }
  const bool isTooSmall =
    options.BoundsError() && size.Point < 0 && size.MaxError < MinRatio * size.Diagonal;
  return isTooSmall ? InputStatus::ErrorBelowSize : InputStatus::Good;
}
}
