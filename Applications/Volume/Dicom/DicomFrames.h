// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DicomFrames.h
 * @brief The frames of an enhanced image (CT or MR), which has all slices in one file.
 */
#ifndef BoneDecimate_Applications_DicomFrames_h
#define BoneDecimate_Applications_DicomFrames_h

#include "DicomSeries.h"

#include <string>
#include <vector>

namespace bonedecimate::volume
{
/**
 * A slice for each frame.
 * @param whole What the file says of all of them.
 * @return Empty if a frame has no position, orientation or distance of pixels.
 */
std::vector<DicomSlice> FramesOf(const DicomSlice& whole);
}

#endif
