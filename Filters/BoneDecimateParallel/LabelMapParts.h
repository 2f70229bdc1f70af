// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelMapParts.h
 * @brief Whether the parts of a surface are of one label map: equal voxel grids, equal lists of
 * labels, the same arrays.
 */
#ifndef LabelMapParts_h
#define LabelMapParts_h

class vtkDataObject;
class vtkMultiProcessController;

namespace bonedecimate
{
struct LabelMapOfParts
{
  bool IsOne = true;      ///< False if the parts differ.
  double VoxelSize = 0.0; ///< mm, the smallest spacing; 0: there is no grid.
};

/// Parts without triangles do not count. Every process must call this, and all get the same result.
/// @param input A polydata, or polydata in a composite data set.
/// @param controller Null: one process.
LabelMapOfParts CompareLabelMaps(vtkDataObject* input, vtkMultiProcessController* controller);
}

#endif
