// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DicomReaders.h
 * @brief The entry of the library that calls GDCM, whose dictionary alone takes as long to load as
 * the rest of the program.
 */
#ifndef BoneDecimate_Applications_DicomReaders_h
#define BoneDecimate_Applications_DicomReaders_h

#include "LabelMaps/SegmentSelection.h"
#include "Layers/LayeredVolume.h"

#include <string>

namespace bonedecimate::volume
{
/// What DicomFolder.h declares.
struct DicomReaders
{
  LayeredVolume (*OpenFolder)(
    const std::string& folder, const SegmentSelection& selection, const std::string& series);
  LayeredVolume (*OpenFile)(const std::string& file, const SegmentSelection& selection);
};
}

extern "C" const bonedecimate::volume::DicomReaders BoneDecimateDicomReaders;

#endif
