// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Smoothing.h
 * @brief Smooths a surface within a bound: no point moves farther than allowed, and the
 * connectivity stays.
 *
 *     radii       largest displacements, from the radius and the tolerances     DisplacementSets.h
 *     strength    by the discrepancy principle if the grid is known             SmoothingStrength.h
 *     solve       bounded regularized least squares                             BoundedSolver.h
 *     edges       find sharp edges in the result; if there are any, solve
 *                 again with their rows                                         SharpEdges.h
 *     round       to the precision of the output, within the bound
 *     check       no new intersection, no triangle turned over                  NewCrossings.h
 *                 otherwise half the radius there, and solve again around it
 *
 * Points of equal barycentric coordinates of a triangle before and after are no farther apart than
 * its corners move. So the largest displacement bounds the distance between both surfaces in both
 * directions, and between their boundaries.
 *
 * Points with radius 0 keep their position bit for bit.
 */
#ifndef BoneDecimate_Core_Smoothing_Smoothing_h
#define BoneDecimate_Core_Smoothing_Smoothing_h

#include "Base/Monitor.h"
#include "Figures/SmoothingFigures.h"
#include "Geometry/Surface.h"
#include "Labels/LabelMap/VoxelGrid.h"
#include "Mesh/PointRounding.h"

#include <vector>

namespace bonedecimate
{
/// The surface and what is known of it.
struct SmoothingInput
{
  /// mm. Points must be finite, corners valid and different, and neighbors near each other in
  /// memory. May be non-manifold.
  const bonedecimate::Surface& Surface;
  /// mm, of each point, how far the result may be from it. Null: only the radius limits. A point
  /// moves by no more than the least of its own and its neighbors' limits, so every point of a
  /// triangle keeps the least limit of its corners.
  const std::vector<double>* Limits = nullptr;
  /// Null: not known. With OfPoint: octahedra and the automatic strength. With OfTriangle:
  /// junctions. Its grid has the same origin as the points.
  const LabelMapSource* Source = nullptr;
};

struct SmoothingSettings
{
  double Radius = 0.0;         ///< mm, the largest displacement.
  double Strength = 0.0;       ///< lambda; 0: automatic.
  double FeatureAngle = 180.0; ///< Degrees; sharper edges are kept. 180: none.
  /// For thick slices: units of voxels, only octahedra, and stronger smoothing along longer sides.
  /// Only with points of a grid.
  bool InVoxels = false;
  PointRounding Rounding = {};      ///< Rounding of the written positions,
  Vector3 Origin = Vector3::Zero(); ///< mm, relative to this position.
  int Threads = 1;
};

struct SmoothedSurface
{
  std::vector<Vector3> Points; ///< mm. After an abort those of the input.
  SmoothingFigures Figures;
  bool IsAborted = false;
};

/// @param monitor May be empty.
SmoothedSurface Smooth(
  const SmoothingInput& input, const SmoothingSettings& settings, const Monitor& monitor = {});

/// Compares area, volumes, angles and displacements.
/// @param smoothEdges Two triangles of each edge that counts for the angle.
SmoothingFigures CompareSmoothed(const Surface& before, const std::vector<Vector3>& after,
  const std::vector<std::array<Index, 2>>& smoothEdges, int threads);
}

#endif
