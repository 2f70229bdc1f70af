// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DicomTags.h
 * @brief Attributes of images of every kind.
 */
#ifndef BoneDecimate_Applications_DicomTags_h
#define BoneDecimate_Applications_DicomTags_h

#include <gdcmTag.h>

namespace bonedecimate::volume::tags
{
inline const gdcm::Tag Modality(0x0008, 0x0060);
inline const gdcm::Tag Position(0x0020, 0x0032);
inline const gdcm::Tag Orientation(0x0020, 0x0037);
inline const gdcm::Tag Frames(0x0028, 0x0008);
inline const gdcm::Tag Rows(0x0028, 0x0010);
inline const gdcm::Tag Columns(0x0028, 0x0011);
inline const gdcm::Tag PixelSpacing(0x0028, 0x0030);
inline const gdcm::Tag Intercept(0x0028, 0x1052);
inline const gdcm::Tag Slope(0x0028, 0x1053);
}

#endif
