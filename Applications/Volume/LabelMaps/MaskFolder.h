// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MaskFolder.h
 * @brief A folder with a mask for each structure, as segmentation networks write it: one label map.
 */
#ifndef BoneDecimate_Applications_MaskFolder_h
#define BoneDecimate_Applications_MaskFolder_h

#include "SegmentSelection.h"
#include "Volume.h"

#include <string>

namespace bonedecimate::volume
{
/**
 * Whether all visible files of a folder, and at least two, are volumes on one grid whose names
 * differ by more than numbers, and the first of them that is not empty, of at most three, has one
 * value besides 0. Names that differ by numbers alone are those of patients.
 */
bool HoldsMasks(const std::string& folder);

/**
 * The masks in the order of their names with the labels from 1 on; the name of a structure is that
 * of its file. Of several masks the last one counts, as in a segmentation; a note has the number
 * of such voxels. Rejected if a mask has more than one value besides 0, or another grid.
 * @param selection Masks that are not wanted are not read.
 */
Volume ReadMasks(const std::string& folder, const SegmentSelection& selection = {});
}

#endif
