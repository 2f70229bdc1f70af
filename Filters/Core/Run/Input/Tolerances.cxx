// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Tolerances.h"

#include "InputSize.h"
#include "Mesh/SurfaceAssembly.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bonedecimate
{
namespace
{
constexpr double NoLimit = -1.0;
}

InputStatus CheckTolerances(const std::vector<double>& given, std::size_t numberOfPoints,
  bool provesError, CleaningStatistics& found)
{
  for (std::size_t i = 0; i < given.size(); ++i)
  {
    if (!(std::fabs(given[i]) <= MaxCoordinate) && found.BadTolerances++ == 0)
    {
      found.FirstBadTolerance = static_cast<std::int64_t>(i);
    }
  }
  if (given.size() != numberOfPoints || found.BadTolerances > 0)
  {
    return InputStatus::BadTolerances;
  }
  const bool hasPositive =
    std::any_of(given.begin(), given.end(), [](double t) { return t > 0.0; });
  return hasPositive && !provesError ? InputStatus::UnprovableTolerances : InputStatus::Good;
}

//------------------------------------------------------------------------------
InputStatus CheckRounding(const Surface& input, const CleanSurface& clean,
  const ErrorsOfPoints& errors, const PointRounding& rounding, CleaningStatistics& found)
{
  const std::vector<double> tolerances =
    errors.Tolerances != nullptr ? TolerancesOf(clean, *errors.Tolerances) : std::vector<double>();
  for (std::size_t v = 0; v < clean.InputPoint.size(); ++v)
  {
    const Index id = clean.InputPoint[v];
    const Vector3& point = input.Points[static_cast<std::size_t>(id)];
    const bool isLimited = !tolerances.empty() && tolerances[v] >= 0.0;
    const double move = (rounding.Of(point) - point).norm();
    if (move > (isLimited ? std::min(tolerances[v], errors.Largest) : errors.Largest))
    {
      found.FirstCoarsePoint = found.CoarsePoints++ == 0 ? id : found.FirstCoarsePoint;
      found.MaxRounding = std::max(found.MaxRounding, move);
    }
  }
  return found.CoarsePoints > 0 ? InputStatus::RoundingTooCoarse : InputStatus::Good;
}

//------------------------------------------------------------------------------
InputStatus CheckErrors(const Surface& input, const CleanSurface& clean,
  const std::vector<double>* given, const PointRounding& rounding, Options& options,
  CleaningStatistics& found, SizeFigures& size)
{
  InputStatus status = InputStatus::Good;
  if (given != nullptr)
  {
    status = CheckTolerances(*given, input.Points.size(), options.ProvesError(), found);
  }
  if (status != InputStatus::Good)
  {
    return status;
  }
  size = MeasureSize(clean, options, given);
  if (rounding.HasGrid() || (rounding.ToSingle && options.ProvesError()))
  {
    const double error =
      options.BoundsError() ? options.MaximumError : std::numeric_limits<double>::infinity();
    status = CheckRounding(input, clean, { error, given }, rounding, found);
  }
  status = status == InputStatus::Good ? CheckSize(size, options) : status;
  if (options.ProvesError())
  {
    options.MaximumError = std::min(options.MaximumError, size.Diagonal);
  }
  return status;
}

//------------------------------------------------------------------------------
std::vector<double> LimitedTolerances(std::vector<double> given, double limit)
{
  for (double& tolerance : given)
  {
    tolerance = std::min(tolerance, limit);
  }
  return given;
}

//------------------------------------------------------------------------------
std::vector<double> TolerancesOf(const CleanSurface& clean, const std::vector<double>& given)
{
  std::vector<double> tolerances(clean.Surface.Points.size(), NoLimit);
  bool limits = false;
  for (std::size_t i = 0; i < given.size(); ++i)
  {
    const Index point = clean.PointOfInput[i];
    if (point != None && given[i] >= 0.0)
    {
      double& least = tolerances[static_cast<std::size_t>(point)];
      least = least < 0.0 ? given[i] : std::min(least, given[i]);
      limits = true;
    }
  }
  const std::vector<Index>& originals = clean.ManifoldPatches.OriginalVertices;
  for (std::size_t v = 0; v < originals.size(); ++v)
  {
    tolerances[v] = tolerances[static_cast<std::size_t>(originals[v])];
  }
  if (!limits)
  {
    tolerances.clear();
  }
  return tolerances;
}
}
