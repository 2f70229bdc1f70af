// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelSurfaces.h
 * @brief Extracts the surfaces of all labels of a label map as one complex, in which a wall between
 * two labels exists once.
 *
 * Marching cubes for several labels (CellSurface.h). The points are the midpoint of each grid edge
 * whose ends have different labels, a point on each face of a cell on which three or four labels
 * meet, and points in cells in which more than two such faces do. With two labels these are the
 * points of marching cubes.
 *
 * The surface of each label is closed and its edges are manifold; it may touch itself at points
 * inside cells. Voxelized again, every voxel has its original label, and keeps it while all points
 * stay within their octahedra (GridPoint).
 *
 * The order of points and triangles is that of LayerSweep.h, the same for any number of threads.
 */
#ifndef BoneDecimate_Core_Labels_LabelMap_LabelSurfaces_h
#define BoneDecimate_Core_Labels_LabelMap_LabelSurfaces_h

#include "Base/Monitor.h"
#include "Geometry/Surface.h"
#include "LabelImage.h"
#include "VoxelGrid.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace bonedecimate
{
struct LabelSurfaceOptions
{
  /// Labels to extract; all others count as background. Empty: all labels of the map.
  std::vector<std::int64_t> Labels;
  std::int64_t Background = 0;
  /// Adds a voxel of background on all sides, so that surfaces are closed half a voxel outside of
  /// the outermost voxel centers. False: surfaces end at these centers.
  bool Closed = true;
  int Threads = 0; ///< 0: one per processor. Has no effect on the result.
  /// The image holds a slab, these layers of a grid that has more. The last layer of a slab is the
  /// first one of the next, and both surfaces have the same points there, bit for bit. Together the
  /// triangles of all slabs are those of the whole. Closed adds voxels at the ends of the grid
  /// alone. Labels should be given, so that all slabs number them in the same way.
  std::optional<LayerRange> Slab = std::nullopt;
};

/// Besides the background: an image with more values has no labels but gray values.
constexpr std::size_t MaxLabels = 1000;

enum class LabelSurfaceStatus : int
{
  Good = 0,
  NoVoxels,        ///< The grid has no voxels, or an axis has more than 2^30 - 2.
  TooThin,         ///< Open surfaces need at least two voxels along each axis.
  BadGrid,         ///< VoxelGrid::IsValid()
  LabelOutOfRange, ///< A label beyond 2^63 - 1.
  TooManyLabels,   ///< More than MaxLabels, unless labels were chosen: gray values.
  TooLarge,        ///< More than 2^31 - 1 points or triangles.
  Aborted,         ///< By the monitor.
  BadSlab          ///< Fewer than two layers, or layers out of the grid.
};
constexpr int NumberOfLabelSurfaceStatuses = 9;

/// What is wrong, and what to do: one sentence without a period. Empty for Good.
const char* LabelSurfaceMessage(LabelSurfaceStatus status);

struct LabelSurfaces
{
  LabelSurfaceStatus Status = LabelSurfaceStatus::Good;
  bonedecimate::Surface Surface; ///< Empty unless the status is Good.
  LabelMapSource Source;
};

/**
 * @param image A direction that is orthogonal up to rounding (1e-3) is replaced by the nearest
 *   orthogonal one, which the grid of the result has. Others are sheared grids and stay as they
 *   are.
 * @throws std::bad_alloc and nothing else.
 */
LabelSurfaces ExtractLabelSurfaces(
  const LabelImage& image, const LabelSurfaceOptions& options, const Monitor& monitor = {});
}

#endif
