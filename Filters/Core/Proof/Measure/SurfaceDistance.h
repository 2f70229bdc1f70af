// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceDistance.h
 * @brief Measures the distance of one surface to another at its points and at samples of its area
 * (AreaSamples.h). The figures are the same on every system.
 */
#ifndef BoneDecimate_Core_Proof_Measure_SurfaceDistance_h
#define BoneDecimate_Core_Proof_Measure_SurfaceDistance_h

#include "Base/Monitor.h"
#include "Figures/DistanceFigures.h"
#include "Geometry/BoundingTree.h"
#include "Geometry/Surface.h"

#include <cstdint>
#include <vector>

namespace bonedecimate
{
/// Number of samples for a surface of that many triangles: two for each, at least 200,000 and at
/// most 1,000,000.
std::int64_t NumberOfSamples(std::size_t triangles);

/// Distance of each point to the triangles of the tree, mm. Empty after an abort.
std::vector<double> PointDistances(
  const std::vector<Vector3>& points, const BoundingTree& to, int threads, const Monitor& monitor);

/**
 * @param pointDistances mm, of each point of `from`.
 * @param samples Their number; every triangle of `from` must have valid corners.
 * @return The statistics; Samples is 0 after an abort.
 */
DistanceStatistics MeasureDistance(const Surface& from, const std::vector<double>& pointDistances,
  const BoundingTree& to, std::int64_t samples, int threads, const Monitor& monitor);
}

#endif
