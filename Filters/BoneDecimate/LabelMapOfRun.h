// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelMapOfRun.h
 * @brief What a run knows of the label map of its input: the arrays of the surface, and the map
 * itself if it is given.
 *
 *     arrays with a voxel grid     the grid of the surface; a map that is given must have the same
 *     no grid, but a map           the grid of the map; points in the middles of its grid edges are
 *                                  known by their positions
 *     neither, KeepVoxels is On    the grid is looked for in the points
 */
#ifndef LabelMapOfRun_h
#define LabelMapOfRun_h

#include "ImageLabels.h"
#include "Labels/LabelMap/VoxelGrid.h"
#include "SurfaceConversion.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkImageData;
class vtkPolyData;

namespace bonedecimate
{
struct LabelMapOfRun
{
  LabelMapSource Source;
  ImageLabels Image;   ///< Without labels: none was given.
  std::string Problem; ///< One sentence; empty if the surface and the map suit each other.

  /// The source for RunInputs; null: no grid is known.
  const LabelMapSource* Known() const
  {
    return this->Source.Grid.Dimensions[0] > 0 ? &this->Source : nullptr;
  }

  /// Replaces the comparison of the result's voxels with those of the input by one with those of
  /// the map, if it is given.
  /// @returns Warnings.
  std::vector<std::string> CompareWithMap(
    const Surface& input, const Options& options, Result& result) const;
};

struct LabelMapRequest
{
  vtkImageData* Map = nullptr; ///< Its active scalars are the labels; null: none.
  /// What a surface without BoundaryLabels encloses; 0: the only label of the map.
  std::int64_t Label = 0;
};

/// @param options Options of the run.
LabelMapOfRun ReadLabelMapOfRun(vtkPolyData* input, const ConvertedSurface& converted,
  const LabelMapRequest& request, const Options& options);

/// Copies the field arrays of the grid and of the labels.
void CopyLabelMapFields(vtkPolyData* input, vtkPolyData* output);
}

#endif
