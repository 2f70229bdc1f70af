// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DistanceColors.h"

#include "NumberText.h"
#include "SurfaceDistances.h"

#include "vtkMath.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>

namespace bonedecimate
{
namespace
{
// Their quarters, which the bar is labeled with, have few digits.
constexpr std::initializer_list<double> Ends = { 1.0, 1.2, 1.6, 2.0, 2.4, 3.0, 4.0, 5.0, 6.0, 8.0 };

// A surface without any distance still needs a bar with two ends.
constexpr double LeastRange = 0.001; // mm

constexpr double PartWithinTolerance = 0.25; // of the colors
}

double ColorRange(const std::vector<double>& sorted)
{
  return RoundUp(std::max(Quantile(sorted, 0.999), LeastRange), Ends);
}

ColorScale ScaleOfTolerance(double tolerance)
{
  return { tolerance * 255.0 / 128.0, tolerance };
}

Color DistanceColor(const ColorScale& scale, double distance)
{
  return scale.Tolerance <= 0.0   ? DistanceColor(distance / scale.Range)
    : distance <= scale.Tolerance ? DistanceColor(PartWithinTolerance * distance / scale.Tolerance)
                                  : DistanceColors.back();
}

Color DistanceColor(double part)
{
  constexpr std::size_t last = DistanceColors.size() - 1;
  const double position = std::clamp(part, 0.0, 1.0) * static_cast<double>(last);
  const std::size_t below = std::min(static_cast<std::size_t>(position), last - 1);
  const double along = position - static_cast<double>(below);
  Color from;
  Color to;
  vtkMath::RGBToLab(DistanceColors[below].data(), from.data());
  vtkMath::RGBToLab(DistanceColors[below + 1].data(), to.data());
  Color color;
  for (std::size_t i = 0; i < 3; ++i)
  {
    color[i] = (1.0 - along) * from[i] + along * to[i];
  }
  vtkMath::LabToRGB(color.data(), color.data());
  return color;
}
}
