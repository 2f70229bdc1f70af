// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SegmentSurfaces.h
 * @brief A label map in, the surfaces of its segments out.
 */
#ifndef BoneDecimate_Applications_SegmentSurfaces_h
#define BoneDecimate_Applications_SegmentSurfaces_h

#include "Arguments.h"
#include "VoxelPieces.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace bonedecimate
{
struct SegmentSurfaces
{
  vtkSmartPointer<vtkPolyData> Surface; ///< Surface of all segments together, by vtkBoneSurfaces.
  vtkSmartPointer<vtkImageData> Map;    ///< The map as it was extracted.
  std::string Note;                     ///< Where names of labels are from; may be empty.
  PiecesOfLabels Changed; ///< What changed in the map on request; empty: nothing was requested.
};

/// Reads the label map and extracts the segments that the arguments choose. @throws
/// Failure(ExitCode::InputRejected)
SegmentSurfaces ExtractSegments(const Arguments& arguments, std::vector<std::string>& warnings);

/// The surface with the colors of its labels as the cell array Color, which formats with colors
/// write; the same without colors.
vtkSmartPointer<vtkPolyData> WithColorArray(vtkPolyData* surface);
}

#endif
