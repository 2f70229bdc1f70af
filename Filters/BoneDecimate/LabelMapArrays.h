// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelMapArrays.h
 * @brief The arrays in which a vtkPolyData keeps from which label map it was extracted.
 *
 *     cell array    BoundaryLabels       values of the labels on both sides, two components
 *     cell array    OtherLabel           in the surface of one label: the label beyond each
 *                                        triangle; nothing reads it
 *     point array   GridPoint        int, three components, twice the voxel coordinates of a center
 *     field arrays  VoxelGridOrigin      mm, the center of the first voxel, three components
 *                   VoxelGridSpacing     mm, three components
 *                   VoxelGridDirection   row by row, nine components; the columns are the axes
 *                   VoxelGridDimensions  int, number of voxels, three components
 *                   VoxelGridLayers      mm along the third axis of each layer from the first one,
 *                                        ascending; only if their
 *                                        distance changes. The third of VoxelGridSpacing is then
 *                                          the least distance
 *                   LabelValues          the labels, ascending, and at the end the background
 *                   LabelNames           texts, in the order of LabelValues; if the image had them
 *                   LabelColors          in the order of LabelValues; if the image had them
 *
 * VoxelGrid.h describes them.
 */
#ifndef LabelMapArrays_h
#define LabelMapArrays_h

#include "Labels/LabelMap/VoxelGrid.h"
#include "SurfaceConversion.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace bonedecimate
{
constexpr const char* GridOriginName = "VoxelGridOrigin";
constexpr const char* GridSpacingName = "VoxelGridSpacing";
constexpr const char* GridDirectionName = "VoxelGridDirection";
constexpr const char* GridDimensionsName = "VoxelGridDimensions";
constexpr const char* GridLayersName = "VoxelGridLayers";
constexpr const char* BoundaryLabelsName = "BoundaryLabels";
constexpr const char* OtherLabelName = "OtherLabel";
constexpr const char* GridPointName = "GridPoint";
constexpr const char* LabelValuesName = "LabelValues";

/// Adds all arrays of the label map except those of names and colors.
void AddLabelMapArrays(const LabelMapSource& source, int threads, vtkPolyData* output);

/// Adds BoundaryLabels to a result if those of the input were not passed; vertices and lines get
/// two zeros. Removes GridPoint, because points of a result are not where they were extracted.
/// Field arrays are passed with all others.
void PassLabelMapArrays(
  const LabelMapSource& source, const std::vector<BoundaryLabels>& ofTriangle, vtkPolyData* output);

struct ReadLabelMap
{
  LabelMapSource Source;
  std::string Problem; ///< One sentence; empty if all arrays are valid. Then the source is empty.
};

/**
 * Reads the arrays back. Missing arrays are empty; without a grid its dimensions are 0. Without
 * LabelValues the values are those of BoundaryLabels, ascending, with 0 as background.
 *
 * @param converted The same surface in the core's form; says of which cell each triangle is.
 */
ReadLabelMap ReadLabelMapArrays(vtkPolyData* input, const ConvertedSurface& converted);
}

#endif
