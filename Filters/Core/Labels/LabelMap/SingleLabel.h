// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SingleLabel.h
 * @brief The surface of one label, extracted from the surfaces of all labels.
 */
#ifndef BoneDecimate_Core_Labels_LabelMap_SingleLabel_h
#define BoneDecimate_Core_Labels_LabelMap_SingleLabel_h

#include "Geometry/Surface.h"
#include "VoxelGrid.h"

#include <vector>

namespace bonedecimate
{
struct SingleLabelSurface
{
  /// The normals point out of the label. A vertex whose triangles are not one fan is split; no edge
  /// has more than two triangles.
  bonedecimate::Surface Surface;
  std::vector<Index> OriginalPoint;    ///< For each point, that of the surface of all labels.
  std::vector<Index> OriginalTriangle; ///< The same for triangles.
};

/**
 * The triangles between the label and any other one, in their order; points in order of their first
 * triangle.
 * @param label Index into LabelMapSource::Values.
 * @param labels One pair for each triangle of the surface.
 */
SingleLabelSurface ExtractLabel(
  const Surface& surface, const std::vector<BoundaryLabels>& labels, Index label);
}

#endif
