// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ModelGrid.h
 * @brief The grid on which a network made a label map that was copied to the voxels of a scan
 * afterwards.
 *
 *     count the changes of labels between neighboring layers, along each axis (ChangePlanes)
 *     per axis: the coarsest cells that explain all changes (AxisCells); else each layer is a cell
 *     read the label of each cell at its middle voxel: the model's map
 *     copy it back and compare: no voxel differs, or few do
 *
 * If not all changes are explained, the search is repeated without the layers with the fewest
 * changes. Documentation/explanation/model-grid.md says when a grid is claimed, and why.
 */
#ifndef BoneDecimate_Core_Labels_ModelGrid_ModelGrid_h
#define BoneDecimate_Core_Labels_ModelGrid_ModelGrid_h

#include "AxisCells.h"
#include "Labels/LabelMap/LabelImage.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace bonedecimate
{
struct ModelGridRequest
{
  /// mm, spacing of the model along the axes of the image. If it is given, no evidence is required,
  /// and an axis whose layers are no closer stays as it is.
  std::optional<Vector3> Spacing = std::nullopt;
  int Threads = 0; ///< 0: one per processor. Has no effect on the result.
};

/// How the labels of a map follow from those of a coarser one.
struct ModelGrid
{
  bool IsFound = false;
  VoxelGrid Grid; ///< Grid of the samples of the model, in the frame of the image.
  std::array<AxisCells, 3> Axes;
  double Chance = 1.0; ///< Product of the axes.
  /// Number of voxels of the image whose label is not that of their cell, and the first of them
  /// along z, y, x.
  std::int64_t Different = 0;
  std::array<Index, 3> FirstDifferent = { 0, 0, 0 };

  /// The model's map, of the type of the image. Valid while this object exists.
  LabelImage Map() const { return { this->Labels.data(), this->Type, this->Grid }; }

  LabelType Type = LabelType::UInt8;
  std::vector<std::uint64_t> Labels; ///< Memory of Map().
};

ModelGrid FindModelGrid(const LabelImage& image, const ModelGridRequest& request = {});
}

#endif
