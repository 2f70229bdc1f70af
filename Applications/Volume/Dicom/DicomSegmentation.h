// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DicomSegmentation.h
 * @brief A DICOM segmentation (SEG) as a label map.
 */
#ifndef BoneDecimate_Applications_DicomSegmentation_h
#define BoneDecimate_Applications_DicomSegmentation_h

#include "LabelMaps/SegmentSelection.h"
#include "Layers/LayeredVolume.h"

#include <string>

namespace bonedecimate::volume
{
/**
 * Labels are the numbers of the segments, names and colors those that the file has for them. A
 * voxel of several segments gets the last one, which the note says. Planes without a frame are
 * background. The file is in memory while its planes are read. May end the process on damaged
 * files: to be called by an IsolatedReader.
 */
LayeredVolume OpenDicomSegmentation(const std::string& file, const SegmentSelection& selection);
}

#endif
