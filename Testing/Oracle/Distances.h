// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Distances.h
 * @brief Distance of one surface to another over its area and its points, by CGAL's AABB tree.
 */
#ifndef BoneDecimate_Testing_Oracle_Distances_h
#define BoneDecimate_Testing_Oracle_Distances_h

#include "TriangleFile.h"

#include <cstddef>
#include <vector>

/// All in mm. Figures of the area are over samples of equal weight; a sampled maximum is a lower
/// bound of the true one.
struct Distances
{
  double Average = 0.0;
  double RootMeanSquare = 0.0;
  double Maximum = 0.0; ///< Over the area samples and the points.
  double PointAverage = 0.0;
  double PointRootMeanSquare = 0.0;
  double PointMaximum = 0.0;
  double PointSecond = 0.0; ///< The second largest distance of a point.
  /// Distances of the area samples that 0, 1, ... 100 % of the area do not exceed.
  std::vector<double> Percentiles;
};

/// One sample in each of `samples` strips of equal area; the same samples for any number of
/// threads.
Distances MeasureDistances(
  const Triangles& from, const Triangles& to, std::size_t samples, unsigned threads);

#endif
