// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceDistance.h
 * @brief How far one surface is from another, by its points and by samples spread evenly over its area.
 *
 * Sample i of n lies where (i + 1/2) / n of the area, summed in the order of the triangles, is passed; its place in the
 * triangle follows the R2 sequence, so that the same surfaces give the same figures everywhere.
 * M. Roberts, The unreasonable effectiveness of quasirandom sequences, 2018: R2.
 */
#ifndef BoneDecimate_Core_Measure_SurfaceDistance_h
#define BoneDecimate_Core_Measure_SurfaceDistance_h

#include "Geometry/BoundingTree.h"
#include "Monitor.h"
#include "Report.h"
#include "Surface.h"

#include <vector>

namespace bonedecimate
{
/// How many samples measure a surface of that many triangles: two a triangle, 200,000 to 1,000,000.
std::int64_t NumberOfSamples(std::size_t triangles);

/// Distance of each point to the triangles of the tree, mm. Empty if the monitor stopped it.
std::vector<double> PointDistances(
  const std::vector<Vector3>& points, const BoundingTree& to, int threads, const Monitor& monitor);

/**
 * @param pointDistances Of the points of `from` that are used (their maximum, second, mean and RMS).
 * @param samples Spread over the area of `from`; every triangle must have valid corners.
 * @return The distances; Samples is 0 if the monitor stopped it.
 */
DistanceStatistics MeasureDistance(const Surface& from, const std::vector<double>& pointDistances,
  const BoundingTree& to, std::int64_t samples, int threads, const Monitor& monitor);
}

#endif
