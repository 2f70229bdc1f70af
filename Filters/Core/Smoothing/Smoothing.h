// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Smoothing.h
 * @brief Smooths a surface within a bound: no point moves farther than allowed, and the
 * connectivity stays.
 *
 *     radii       the largest displacement, and what tolerances leave of it     DisplacementSets.h
 *     strength    by the discrepancy principle if the grid is known             SmoothingStrength.h
 *     solve       bounded regularized least squares                             BoundedSolver.h
 *     edges       sharp ones are found in the result; if there are
 *                 any, solve again with their rows                              SharpEdges.h
 *     round       to the precision of the output, within the bound
 *     check       no new intersection, no triangle turned over                  NewCrossings.h
 *                 otherwise half the radius there, solve again around it
 *
 * Points of equal barycentric coordinates of a triangle before and after are no farther apart than
 * its corners move. So the largest displacement bounds the distance between both surfaces in both
 * directions, and between their boundaries.
 *
 * Points stay where they were bit for bit if their radius is 0.
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
  /// mm. Finite points; corners valid and different; neighbors near each other in memory. Anything
  /// non-manifold.
  const bonedecimate::Surface& Surface;
  /// mm, of each point, how far the result may be from it; null: nothing but the radius limits. A
  /// point moves by no more than the least of its own and its neighbors' limits, so that all of a
  /// triangle keeps to the least limit of its corners.
  const std::vector<double>* Limits = nullptr;
  /// With OfPoint: octahedra and the automatic strength. With OfTriangle: junctions. Its grid has
  /// the same origin as the points. Null: not known.
  const LabelMapSource* Source = nullptr;
};

struct SmoothingSettings
{
  double Radius = 0.0;         ///< mm, the largest displacement.
  double Strength = 0.0;       ///< lambda; 0: automatic.
  double FeatureAngle = 180.0; ///< Degrees: edges that are sharper are kept; 180: none.
  /// For thick slices: in units of voxels, octahedra alone, and stronger along longer sides. Only
  /// with points of a grid.
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

/// Area, volumes, angles and displacements.
/// @param smoothEdges Two triangles of each edge that counts for the angle.
SmoothingFigures CompareSmoothed(const Surface& before, const std::vector<Vector3>& after,
  const std::vector<std::array<Index, 2>>& smoothEdges, int threads);
}

#endif
