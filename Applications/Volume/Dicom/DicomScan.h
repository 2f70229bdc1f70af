// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DicomScan.h
 * @brief What DICOM files are: slices, images of several frames, segmentations, or damaged.
 */
#ifndef BoneDecimate_Applications_DicomScan_h
#define BoneDecimate_Applications_DicomScan_h

#include "DicomChoice.h"
#include "DicomSeries.h"

#include <cstddef>
#include <string>
#include <vector>

namespace bonedecimate::volume
{
/// What the DICOM files of a folder are.
struct ScannedFiles
{
  std::vector<DicomSlice> Slices;
  std::vector<std::string> Segmentations;
  std::vector<SeriesEntry> SegmentationEntries;
  /// Files of several frames that do not say where each lies.
  std::vector<std::string> FramesOfImages;
  std::vector<std::string> Damaged;
  std::size_t Images = 0; ///< Files that have slices.
};

/// @param folder The folder that is read; the files may lie below.
ScannedFiles ScanFiles(const std::vector<std::string>& files, const std::string& folder);
}

#endif
