// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VoxelCheck.h
 * @brief Counts the voxels whose label a surface changes, compared with the label map or with
 * another surface.
 *
 * The surface is voxelized (VoxelRows.h) with exact ties. Extraction, smoothing and VoxelGuard have
 * no code in common with this check. Open surfaces have no inside at the ends of the grid: there,
 * the outermost voxels are not compared.
 */
#ifndef BoneDecimate_Core_Labels_LabelMap_VoxelCheck_h
#define BoneDecimate_Core_Labels_LabelMap_VoxelCheck_h

#include "Base/Monitor.h"
#include "LabelImage.h"
#include "VoxelRows.h"

#include <cstdint>
#include <vector>

namespace bonedecimate
{
/// Voxels that changed, by label.
struct LabelChanges
{
  std::int64_t Voxels = 0; ///< With this label in the reference.
  std::int64_t Lost = 0;   ///< With this label in the reference and another in the result.
  std::int64_t Gained = 0; ///< The reverse.
};

struct VoxelChanges
{
  bool IsDone = false;       ///< False after an abort.
  std::int64_t Compared = 0; ///< Voxels.
  std::int64_t Changed = 0;
  /// Voxel indices along x, y and z of the first in the order of the map; if Changed.
  std::array<std::int64_t, 3> FirstChanged = { 0, 0, 0 };
  std::vector<LabelChanges> OfLabel; ///< By index of the label.
};

/// Comparison of the voxels of the result with those of the input.
struct VoxelReport
{
  bool WereGuarded = false; ///< Whether edits that change a voxel were rejected.
  bool WasChecked = false;  ///< If false, what follows is meaningless.
  VoxelChanges Changes;
  std::vector<std::int64_t> Values; ///< Labels by index; the background is the last.
};

struct VoxelCheckSettings
{
  VoxelGrid Grid;
  Index NumberOfLabels = 2; ///< The background is the last.
  int Threads = 0;          ///< 0: one per processor. Has no effect on the result.
};

/// Compares the voxels of the image of the grid, and those outside of it that a surface encloses.
/// If the image is not known: all voxels of the box around both surfaces.
VoxelChanges CompareVoxels(const LabeledSurface& reference, const LabeledSurface& result,
  const VoxelCheckSettings& settings, const Monitor& monitor = {});

/// Compares the voxels of the image, and those outside of it that the surface encloses, which are
/// background.
/// @param image Its grid is used, not that of the settings.
/// @param values The values of the labels by index, the background last; other values count as
///   background. Empty: all labels but 0 have index 0.
VoxelChanges CompareVoxels(const LabelImage& image, const std::vector<std::int64_t>& values,
  const LabeledSurface& result, const VoxelCheckSettings& settings, const Monitor& monitor = {});
}

#endif
