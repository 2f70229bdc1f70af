// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PartFigures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

namespace bonedecimate
{
namespace
{
constexpr double VolumeChangeToTell = 0.1;
constexpr double ThicknessLossToTell = 0.2;

/// The fraction that was lost from `before` to `after`; 0 if one of them is not known.
double LossOf(double before, double after)
{
  return before > 0.0 && !std::isnan(after) ? 1.0 - after / before : 0.0;
}

std::string NameOf(const PartFigures& part)
{
  if (!part.Label.empty())
  {
    return "label " + part.Label;
  }
  char text[100];
  std::snprintf(text, sizeof(text), "the component at %.4g, %.4g, %.4g mm", part.Center[0],
    part.Center[1], part.Center[2]);
  return text;
}

/// "what of N components ..., most ...: by x %"; none if no part exceeds the limit.
std::vector<std::string> WarningAbout(const PartComparison& compared, const char* what,
  double toTell, const std::function<double(const PartFigures&)>& changeOf)
{
  std::int64_t count = 0;
  const PartFigures* most = nullptr;
  for (const PartFigures& part : compared.Parts)
  {
    const double change = std::abs(changeOf(part));
    if (change > toTell && !part.IsSmallerThan(compared.MinVolume))
    {
      ++count;
      most = most == nullptr || change > std::abs(changeOf(*most)) ? &part : most;
    }
  }
  if (most == nullptr)
  {
    return {};
  }
  char text[160];
  std::snprintf(text, sizeof(text), "the %s of %lld %s changed by more than %.3g %%, most that of ",
    what, static_cast<long long>(count),
    compared.Of == PartComparison::Kind::Labels ? "labels" : "components", 100.0 * toTell);
  char change[80];
  std::snprintf(change, sizeof(change), ": by %.3g %% (parts two voxels thin or less lose most)",
    100.0 * changeOf(*most));
  return { text + NameOf(*most) + change };
}
}

double PartFigures::VolumeChange() const
{
  const double before = this->Input.Volume;
  return std::abs(before) > 0.0 ? this->Output.Volume / before - 1.0 : 0.0;
}

double PartFigures::ThicknessLoss() const
{
  const ThicknessFigures& before = this->Input.Thickness;
  const ThicknessFigures& after = this->Output.Thickness;
  return std::max(
    { 0.0, LossOf(before.Median, after.Median), LossOf(before.Percentile5, after.Percentile5) });
}

bool PartFigures::IsSmallerThan(double volume) const
{
  const double ofSide = this->Input.Area / 6.0; // mm^2
  const double ofCube = ofSide * std::sqrt(ofSide);
  return (std::isnan(this->Input.Volume) ? ofCube : std::abs(this->Input.Volume)) < volume;
}

std::vector<std::string> PartWarnings(const PartComparison& compared)
{
  std::vector<std::string> warnings = WarningAbout(compared, "volume", VolumeChangeToTell,
    [](const PartFigures& part) { return part.VolumeChange(); });
  const std::vector<std::string> ofThickness = WarningAbout(compared, "thickness",
    ThicknessLossToTell, [](const PartFigures& part) { return -part.ThicknessLoss(); });
  warnings.insert(warnings.end(), ofThickness.begin(), ofThickness.end());
  return warnings;
}
}
