// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelPieces.h
 * @brief Small islands and cavities of the segments of a label map, and the voxels whose label
 * changes when they are removed.
 *
 *     island   a piece of a segment, connected by faces of voxels, other than the largest
 *              of the segment
 *     cavity   a piece of background, connected by faces or edges of voxels, that does not
 *              reach the end of the image and touches only one segment
 *
 * Surfaces of the map have one component for each of these pieces (LabelSurfaces.h). An island gets
 * the label with the largest part of its boundary, the background included; the end of the image
 * counts as background. A cavity gets the label of its segment.
 */
#ifndef BoneDecimate_Core_Labels_LabelMap_LabelPieces_h
#define BoneDecimate_Core_Labels_LabelMap_LabelPieces_h

#include "LabelImage.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bonedecimate
{
/// Islands below any of these are removed. 0: off.
struct IslandLimits
{
  double Size = 0.0;   ///< mm, the longest side of its box of voxels, along the axes of the image.
  double Area = 0.0;   ///< mm^2, of the faces of its voxels.
  double Volume = 0.0; ///< mm^3
};

/// Consecutive voxels that get a label.
struct VoxelRun
{
  std::size_t First = 0;
  std::size_t Count = 0;
  std::int64_t Label = 0;
};

struct SegmentPieces
{
  std::int64_t Label = 0;
  std::int64_t Pieces = 0; ///< Islands that are removed, or cavities that are filled.
  std::int64_t Voxels = 0; ///< Voxels of all these pieces.
  double Volume = 0.0;     ///< mm^3, of all of them.
  bool IsLargestTooSmall =
    false; ///< Whether even the largest piece, which is kept, is below a limit.
};

struct PieceChanges
{
  std::vector<VoxelRun> Runs;          ///< In order of the voxels.
  std::vector<SegmentPieces> Segments; ///< The requested segments, ascending.
};

/// @param segments Labels, each once, without the background.
/// @param background Label of the background.
PieceChanges FindIslands(const LabelImage& image, const std::vector<std::int64_t>& segments,
  std::int64_t background, const IslandLimits& limits);

/// Cavities of at most this volume, mm^3.
PieceChanges FindCavities(const LabelImage& image, const std::vector<std::int64_t>& segments,
  std::int64_t background, double maxVolume);
}

#endif
