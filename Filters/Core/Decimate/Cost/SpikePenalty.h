// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SpikePenalty.h
 * @brief The minimum cost of a collapse that leaves a distance. It keeps the tips of thin spikes.
 *
 *     penalty(D) = k n0 L^2 c / n  D^(3/2)        D of AccumulatedError.h, c of QuadricDeviation.h
 *     k          weight of the mode; 0 where every edit is proved, because a bound needs no penalty
 *     n0, n      faces before the sweep and now
 *     L          mean edge length before the first edit, units
 *
 * QuadricDeviation weighs distances by the area that moves. The tip of a thin spike has no area, so
 * every collapse on the way to it is cheap. With this penalty, a distance counts as if it moved an
 * area in proportion to the mean face, which starts at L^2.
 */
#ifndef BoneDecimate_Core_Decimate_Cost_SpikePenalty_h
#define BoneDecimate_Core_Decimate_Cost_SpikePenalty_h

#include "Geometry/Surface.h"

#include <cmath>

namespace bonedecimate
{
/// The factor k n0 L^2 c. @param length L, units.
inline double SpikeFactor(double weight, Index facesBefore, double length, float normalization)
{
  return weight * (facesBefore * length * length * normalization);
}

/// The penalty in the unit of QuadricDeviation(). @param distance D, units.
inline double SpikePenalty(double factor, Index faces, double distance)
{
  return factor / faces * distance * std::sqrt(distance);
}
}

#endif
