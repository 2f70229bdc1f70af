// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelMapInput.h
 * @brief The label map of an input: whether its voxels are guarded, the patches between its
 * labels, and what a run changed of it.
 */
#ifndef BoneDecimate_Core_Run_Input_LabelMapInput_h
#define BoneDecimate_Core_Run_Input_LabelMapInput_h

#include "Figures/InputFigures.h"
#include "Figures/InputStatus.h"
#include "Labels/LabelMap/VoxelCheck.h"
#include "Labels/LabelMap/VoxelGrid.h"
#include "Mesh/Cleaning.h"
#include "Options/Options.h"

#include <vector>

namespace bonedecimate
{
struct Labels;

/// Good, BadLabelMap, or NoVoxelGrid if the voxels are to be kept and there is no grid.
InputStatus CheckLabelMap(
  const LabelMapSource* source, const Surface& input, const Options& options);

/// Whether a surface can be voxelized on the grid: nothing is wrong with it, and it is near the
/// grid. It may be empty.
InputStatus CheckForVoxels(
  const Surface& surface, const VoxelGrid& grid, int threads, CleaningStatistics& found);

/// KeepVoxels On; Automatic: if there is a grid, and no largest error or one of at most half a
/// voxel.
/// @param options With the largest error of the preset.
bool GuardsVoxels(const LabelMapSource* source, const Options& options);

/// Whether triangles differ in their pairs of labels.
bool HasSeveralPairs(const LabelMapSource* source);

/// For each triangle of the cleaned surface a number that differs where its label or its pair of
/// labels does. Empty without either.
std::vector<Index> PatchLabels(
  const CleanSurface& clean, const Labels* labels, const LabelMapSource* source);

/// Labels of each triangle of the cleaned surface; empty if the source has none.
std::vector<BoundaryLabels> BoundaryLabelsOf(
  const CleanSurface& clean, const LabelMapSource& source);

/// Voxelizes input and result.
/// @param resultLabels For each triangle of the result; empty if the source has none.
VoxelReport CompareWithInput(const Surface& input, const Surface& result,
  const std::vector<BoundaryLabels>& resultLabels, const LabelMapSource& source, int threads,
  const Monitor& monitor);
}

#endif
