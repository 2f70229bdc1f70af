// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Tolerances.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
constexpr double NoLimit = -1.0;
/// mm; the certificate judges nothing beyond.
constexpr double Largest = 1e30;
}

InputStatus CheckTolerances(const std::vector<double>& given, std::size_t numberOfPoints, Mode mode,
  CleaningStatistics& found)
{
  for (std::size_t i = 0; i < given.size(); ++i)
  {
    if (!(std::fabs(given[i]) <= Largest) && found.BadTolerances++ == 0)
    {
      found.FirstBadTolerance = static_cast<std::int64_t>(i);
    }
  }
  if (given.size() != numberOfPoints || found.BadTolerances > 0)
  {
    return InputStatus::BadTolerances;
  }
  const bool areProved = std::any_of(given.begin(), given.end(), [](double t) { return t > 0.0; });
  return areProved && mode == Mode::Thesis ? InputStatus::TolerancesInThesis : InputStatus::Good;
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
  const std::vector<Index>& sites = clean.Sheets.Sites;
  for (std::size_t v = 0; v < sites.size(); ++v)
  {
    tolerances[v] = tolerances[static_cast<std::size_t>(sites[v])];
  }
  if (!limits)
  {
    tolerances.clear();
  }
  return tolerances;
}
}
