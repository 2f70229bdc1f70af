// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceDistance.h
 * @brief Measures the distance of one surface to another at its points and at samples spread evenly
 * over its area.
 *
 * Sample i of n lies in the triangle at which the cumulative area reaches (i + 1/2) / n of the
 * whole; its position in the triangle follows the R2 sequence. The same surfaces give the same
 * figures on every system.
 * M. Roberts, The unreasonable effectiveness of quasirandom sequences, 2018: R2.
 */
#ifndef BoneDecimate_Core_Proof_Measure_SurfaceDistance_h
#define BoneDecimate_Core_Proof_Measure_SurfaceDistance_h

#include "Base/Monitor.h"
#include "Figures/DistanceFigures.h"
#include "Geometry/BoundingTree.h"
#include "Geometry/Surface.h"

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
 * @param pointDistances mm, of the points that triangles of `from` use; their maximum,
 * second, mean and RMS are reported.
 * @param samples Their number; every triangle of `from` must have valid corners.
 * @return The distances; Samples is 0 after an abort.
 */
DistanceStatistics MeasureDistance(const Surface& from, const std::vector<double>& pointDistances,
  const BoundingTree& to, std::int64_t samples, int threads, const Monitor& monitor);
}

#endif
