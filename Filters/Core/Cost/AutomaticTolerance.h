// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AutomaticTolerance.h
 * @brief The thesis's tolerance w, chosen before simplifying.
 *
 *     f = (share of the triangles that stays - 0.1) / 0.4, no less than 0 and no more than 1
 *     w = 0.95 (1 - (1 - f)^2)
 *
 * With w near 1 flat edges cost next to nothing whatever their length, so that few large triangles take the place of flat
 * parts: right while most of the surface may stay. With w = 0 an edge costs area times length whatever the angle, so that
 * triangles stay evenly large: right when few are left, where angles are those of noise. Documentation/thesis-tolerance.md
 * has the measurements.
 */
#ifndef BoneDecimate_Core_Cost_AutomaticTolerance_h
#define BoneDecimate_Core_Cost_AutomaticTolerance_h

#include <algorithm>

namespace bonedecimate
{
/// @param share Of the triangles that stays, 0 to 1.
inline double AutomaticNormalTolerance(double share)
{
  constexpr double most = 0.95; // the thesis's default
  const double f = std::clamp((share - 0.1) / 0.4, 0.0, 1.0);
  return most * (1.0 - (1.0 - f) * (1.0 - f));
}
}

#endif
