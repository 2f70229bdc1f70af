// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SmoothingPlan.h"

#include "VoxelGridSearch.h"
#include "VoxelSize.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// From this ratio of the largest to the smallest spacing on slices are thick.
constexpr double ThickSlices = 2.0;
/// Spacings are estimates, and limits lack the slack of the error bound: an error of one voxel is
/// none below it.
constexpr double RelativeAccuracy = 1e-3;

void FindSource(const Surface& input, const LabelMapSource* labelMap, SmoothingPlan& plan)
{
  using Source = SmoothingFigures::Source;
  const bool isOfInput = labelMap != nullptr && labelMap->OfPoint.size() == input.Points.size() &&
    (labelMap->OfTriangle.empty() || labelMap->OfTriangle.size() == input.Triangles.size());
  if (isOfInput)
  {
    plan.From = Source::LabelMap;
    plan.Given = labelMap;
    return;
  }
  plan.Found = FindVoxelGrid(input);
  plan.From = plan.Found                  ? Source::Binary
    : EstimateVoxelSize(input).IsFromGrid ? Source::GrayLevel
                                          : Source::Unknown;
}

void PlanByVoxels(const VoxelGrid& grid, const Options& options, SmoothingPlan& plan)
{
  const double least = grid.Spacing.minCoeff();
  const double most = grid.MaxSpacing().maxCoeff();
  const double error = options.MaximumError;
  plan.InVoxels = most >= ThickSlices * least && (error == 0.0 || error >= most);
  plan.Radius = 0.5 * (plan.InVoxels ? most : least);
  plan.SmallBelow = (1.0 - RelativeAccuracy) * least;
  if (error > 0.0)
  {
    plan.Radius = std::min(plan.Radius, plan.UsableOf(error));
  }
}
}

SmoothingPlan PlanSmoothing(
  const Surface& input, const Options& options, const LabelMapSource* labelMap)
{
  SmoothingPlan plan;
  if (!options.Smooths())
  {
    return plan;
  }
  FindSource(input, labelMap, plan);
  if (options.Smoothing > 0.0)
  {
    plan.Radius = options.MaximumError > 0.0 ? std::min(options.Smoothing, options.MaximumError)
                                             : options.Smoothing;
  }
  else if (plan.Source() != nullptr)
  {
    PlanByVoxels(plan.Source()->Grid, options, plan);
  }
  return plan;
}
}
