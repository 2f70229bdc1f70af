// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DicomFolder.h
 * @brief One series of DICOM slices or a segmentation, straight from a folder, and a segmentation
 * from its file.
 */
#ifndef BoneDecimate_Applications_DicomFolder_h
#define BoneDecimate_Applications_DicomFolder_h

#include "LabelMaps/SegmentSelection.h"
#include "Layers/LayeredVolume.h"

#include <string>
#include <vector>

namespace bonedecimate::volume
{
/// Whether the four letters that follow a preamble of 128 bytes are those of DICOM.
bool IsDicomFile(const std::string& path);

/// The DICOM files that lie in the folder itself, by name.
std::vector<std::string> DicomFiles(const std::string& folder);

/// The DICOM files in the folder and in the folders below, to a depth of 8. Links to folders are
/// not followed. @param most Largest number of files.
std::vector<std::string> DicomFilesBelow(const std::string& folder, std::size_t most = 1 << 20);

/// What ChooseSeries() was called with.
const std::string& RequestedSeries();

bool HoldsDicom(const std::string& folder);

/**
 * The series that RequestedSeries() names or the one with most slices, CT before anything else; the
 * note says what was left aside. Slices are sorted by their position along the normal of the image
 * plane. Slices missing in between are a reason to reject. In a folder without slices those of the
 * folders below are taken, as on a CD. A folder without slices may hold one segmentation. May end
 * the process on damaged files: to be called by an IsolatedReader.
 */
LayeredVolume OpenDicomFolder(const std::string& folder, const SegmentSelection& selection);

/// A segmentation (SEG), which is one file; other DICOM files are rejected. To be called by an
/// IsolatedReader, too.
LayeredVolume OpenDicomFile(const std::string& file, const SegmentSelection& selection);
}

#endif
