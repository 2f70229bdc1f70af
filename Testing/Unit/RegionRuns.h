// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RegionRuns.h
 * @brief Runs with a brush: a tolerance in balls and 0 outside of them.
 */
#ifndef BoneDecimate_Testing_RegionRuns_h
#define BoneDecimate_Testing_RegionRuns_h

#include "Partition/Regions/RegionCache.h"
#include "Runs.h"

#include <algorithm>
#include <vector>

namespace bonedecimate::testsupport
{
using Map = std::vector<double>;

/// A tolerance in a ball, 0 outside of it.
inline Map Brush(const Surface& surface, const Vector3& center, double radius, double tolerance)
{
  Map map;
  for (const Vector3& p : surface.Points)
  {
    map.push_back((p - center).norm() <= radius ? tolerance : 0.0);
  }
  return map;
}

inline Map Both(Map a, const Map& b)
{
  std::transform(
    a.begin(), a.end(), b.begin(), a.begin(), [](double x, double y) { return std::max(x, y); });
  return a;
}

inline Result Stroke(
  const Surface& input, const Options& options, const Map& map, RegionCache* cache = nullptr)
{
  RunInputs inputs = { false, true, &map };
  inputs.Regions = cache;
  return Decimate(input, options, {}, inputs);
}

/// The stroke as a run of the whole surface.
inline Result StrokeOfWhole(const Surface& input, Options options, const Map& map)
{
  options.DiagnoseInput = true;
  return Stroke(input, options, map);
}

inline Options Fast(double error)
{
  return InMode(Mode::Fast, Error(error));
}

/// Radius 20; brushes of a few millimeters cover a few hundred of its triangles.
inline Surface Ball(int levels = 5)
{
  return BumpySphere(levels, 20.0, 0.004, 3);
}
inline const Vector3 Pole(0.0, 0.0, 20.0);
inline const Vector3 OtherPole(0.0, 0.0, -20.0);
}

#endif
