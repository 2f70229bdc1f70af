// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SmoothingPlan.h
 * @brief How far the points of an input may move when it is smoothed, and what is known of its
 * voxel grid.
 *
 *     Smoothing            that many millimeters, whatever the surface is
 *     AutomaticSmoothing   half the smallest voxel spacing of a label map or of a binary surface;
 *                          a third of a largest error or tolerance that is below that spacing;
 *                          other surfaces are not smoothed
 *     thick slices         spacings that differ by a factor of two or more, without an error below
 *                          the largest one: in units of voxels, up to half the largest spacing
 *
 * A gray-level surface holds detail below the size of a voxel:
 * smoothing moves it away from the bone.
 */
#ifndef BoneDecimate_Core_Run_Input_SmoothingPlan_h
#define BoneDecimate_Core_Run_Input_SmoothingPlan_h

#include "Figures/SmoothingFigures.h"
#include "Geometry/Surface.h"
#include "Labels/LabelMap/VoxelGrid.h"
#include "Options/Options.h"

#include <optional>

namespace bonedecimate
{
struct SmoothingPlan
{
  SmoothingFigures::Source From = SmoothingFigures::Source::NotRequested;
  double Radius = 0.0;                 ///< mm, the largest displacement; 0: no smoothing.
  bool InVoxels = false;               ///< SmoothingSettings::InVoxels.
  double SmallBelow = 0.0;             ///< mm, limits below it are divided by three; 0: none.
  std::optional<LabelMapSource> Found; ///< In the points of the surface.
  const LabelMapSource* Given = nullptr;

  /// The label map of the input; null: not known.
  const LabelMapSource* Source() const { return this->Found ? &*this->Found : this->Given; }
  /// mm, what smoothing may use of a limit, mm.
  double UsableOf(double limit) const { return limit < this->SmallBelow ? limit / 3.0 : limit; }
};

/// @param options With the largest error of the preset.  @param labelMap Null: not known.
SmoothingPlan PlanSmoothing(
  const Surface& input, const Options& options, const LabelMapSource* labelMap);
}

#endif
