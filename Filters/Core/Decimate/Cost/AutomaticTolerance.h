// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AutomaticTolerance.h
 * @brief The tolerance w of the thesis, chosen by the number of triangles that will remain.
 *
 *     f = (ratio of remaining to input triangles - 0.1) / 0.4, clamped to [0, 1]
 *     w = 0.95 (1 - (1 - f)^2)
 *
 * With w near 1, flat edges cost almost nothing whatever their length, and a few large triangles
 * replace flat parts. This is right while most of the triangles remain. With w = 0, an edge costs
 * area times length whatever its angle, and triangles keep similar sizes. This is right when few
 * remain, because their angles are noise. Documentation/results/thesis-tolerance.md has the
 * measurements.
 */
#ifndef BoneDecimate_Core_Decimate_Cost_AutomaticTolerance_h
#define BoneDecimate_Core_Decimate_Cost_AutomaticTolerance_h

#include <algorithm>

namespace bonedecimate
{
/// @param ratio The ratio of remaining to input triangles, 0 to 1.
inline double AutomaticNormalTolerance(double ratio)
{
  constexpr double maxTolerance = 0.95; // the default of the thesis
  const double f = std::clamp((ratio - 0.1) / 0.4, 0.0, 1.0);
  return maxTolerance * (1.0 - (1.0 - f) * (1.0 - f));
}
}

#endif
