// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SmoothingRuns.h
 * @brief Calls of the smoothing for tests.
 */
#ifndef BoneDecimate_Testing_SmoothingRuns_h
#define BoneDecimate_Testing_SmoothingRuns_h

#include "BruteForce.h"
#include "LabelShapes.h"
#include "Options/Options.h"
#include "Shapes.h"
#include "Smoothing/Smoothing.h"

#include <utility>
#include <vector>

namespace bonedecimate::testsupport
{
inline const Vector3 Cubic(0.5, 0.5, 0.5);

/// A run that smooths first.
inline Options Smoothed(double millimeters, Options options)
{
  options.Smoothing = millimeters;
  return options;
}

inline SmoothingSettings Within(double radius)
{
  SmoothingSettings settings;
  settings.Radius = radius;
  return settings;
}

inline SmoothedSurface SmoothBinary(const BinarySurface& binary, const SmoothingSettings& settings,
  const std::vector<double>* limits = nullptr)
{
  return Smooth({ binary.Surface, limits, &binary.Source }, settings);
}

inline Surface WithPoints(Surface surface, std::vector<Vector3> points)
{
  surface.Points = std::move(points);
  return surface;
}
}

#endif
