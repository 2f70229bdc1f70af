// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Result.h
 * @brief What a run made of a surface.
 */
#ifndef BoneDecimate_Core_Run_Output_Result_h
#define BoneDecimate_Core_Run_Output_Result_h

#include "Labels/LabelMap/VoxelGrid.h"
#include "Run/Report/Report.h"

#include <array>
#include <vector>

namespace bonedecimate
{
/// Correspondence between output and input. Empty unless requested. If the triangles are those of the input, as after smoothing
/// alone, each point and triangle corresponds to itself, even if another one is nearer.
struct SurfaceOrigins
{
  std::vector<Index> NearestTriangle; ///< Input triangle nearest to each output point.
  std::vector<std::array<double, 3>>
    Barycentric;                   ///< Coordinates of the nearest point in that triangle, sum 1.
  std::vector<Index> NearestPoint; ///< Input point nearest to each output point.
  std::vector<Index>
    TriangleAtCentroid; ///< Input triangle nearest to each output triangle's centroid; one of its label.
  std::vector<Index>
    OutputPoint; ///< The output point that each input point became part of; None if no triangle used it.
};

/// What a run made of a surface.
struct Result
{
  /// Empty if the input was rejected. Points and triangles come in the order of SpatialOrder.h; if only regions were run, in
  /// that of Partition/Regions/JoinRegions.h.
  bonedecimate::Surface Surface;
  SurfaceOrigins Origins; ///< Where the output comes from; filled on request.
  /// mm, of each output point to the input surface, or to the reference if distances are measured; filled with
  /// MeasureDistances, with Origins, and in modes that record distances along the collapses, else empty; empty,
  /// too, in a run aborted before.
  std::vector<double> Distance;
  /// mm, largest distance recorded along the collapses into each output point, or Distance if none are; filled with it.
  std::vector<double> RunningError;
  /// Labels on both sides of each output triangle; filled if the label map has them.
  std::vector<bonedecimate::BoundaryLabels> BoundaryLabels;
  std::vector<Index> PointCount; ///< Number of input points that each output point represents.
  std::vector<double>
    InputDistance; ///< mm, of each input point to the result; only with MeasureInputDistances.
  /// mm, proved: no point of the triangles around an output point is farther from the input. Empty without a proof.
  std::vector<double> ErrorBound;
  /// mm, the same of each input point, not a number where there is no triangle; only with MeasureInputDistances and
  /// without a reference.
  std::vector<double> InputErrorBound;
  bonedecimate::Report Report; ///< Status, figures and warnings of the run.
};
}

#endif
