// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SegmentSurfaces.h
 * @brief A label map in, the surfaces of its segments out.
 */
#ifndef BoneDecimate_Applications_SegmentSurfaces_h
#define BoneDecimate_Applications_SegmentSurfaces_h

#include "Arguments/Arguments.h"
#include "ImageLabels.h"
#include "VoxelPieces.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <string>
#include <vector>

namespace bonedecimate
{
struct SegmentSurfaces
{
  vtkSmartPointer<vtkPolyData> Surface; ///< Surface of all segments together, by vtkBoneSurfaces.
  vtkSmartPointer<vtkImageData> Map;    ///< The map as it was extracted.
  /// The map of the file, if the other one is that of a network from which it was copied.
  vtkSmartPointer<vtkImageData> MapOfFile;
  ModelLabels Model;                ///< How it was found.
  std::vector<std::int64_t> Chosen; ///< Labels of the segments.
  std::string Note;                 ///< Where names of labels are from; may be empty.
  PiecesOfLabels Changed; ///< What changed in the map on request; empty: nothing was requested.
};

/// Reads the label map and extracts the segments that the arguments choose. @throws
/// Failure(ExitCode::InputRejected)
SegmentSurfaces ExtractSegments(const Arguments& arguments, std::vector<std::string>& warnings);

/// How a surface of the map of a network differs from the map of the file.
struct FileComparison
{
  std::int64_t Compared = 0; ///< Voxels of the file.
  std::int64_t Changed = 0;  ///< Voxels of the file with another label in the surface.
  /// mm, proved: no point of the surface is farther from the surface of the same segments that is
  /// extracted from the file's voxels, nor the other way round.
  double Distance = 0.0;
};

FileComparison CompareWithMapOfFile(vtkPolyData* surface, const SegmentSurfaces& segments,
  const Arguments& arguments, std::vector<std::string>& warnings);

/// The surface with the colors of its labels as the cell array Color, which formats with colors
/// write; the same without colors.
vtkSmartPointer<vtkPolyData> WithColorArray(vtkPolyData* surface);
}

#endif
