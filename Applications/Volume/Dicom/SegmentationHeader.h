// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SegmentationHeader.h
 * @brief What the header of a DICOM segmentation says, checked: PS3.3 A.51 and C.8.20.2.
 */
#ifndef BoneDecimate_Applications_SegmentationHeader_h
#define BoneDecimate_Applications_SegmentationHeader_h

#include "FrameGrid.h"
#include "LabelMaps/Segmentation.h"
#include "SegmentFrames.h"

#include <gdcmDataSet.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace bonedecimate::volume
{
struct SegmentationHeader
{
  SegmentPixels Pixels = SegmentPixels::Bits;
  std::array<std::int64_t, 2> Size{ { 0, 0 } }; ///< Columns and rows.
  std::vector<Segment> Segments;                ///< Without the background.
  std::vector<SegmentFrame> Frames;
  FrameGrid Grid;
  std::string Problem; ///< Why the file is rejected; empty if it is not.
};

SegmentationHeader ReadSegmentationHeader(const gdcm::DataSet& data);
}

#endif
