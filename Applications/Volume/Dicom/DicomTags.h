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
inline const gdcm::Tag CharacterSet(0x0008, 0x0005);
inline const gdcm::Tag PaddingValue(0x0028, 0x0120);
inline const gdcm::Tag PixelData(0x7fe0, 0x0010);
inline const gdcm::Tag SharedGroups(0x5200, 0x9229);
inline const gdcm::Tag FrameGroups(0x5200, 0x9230);
inline const gdcm::Tag PlanePosition(0x0020, 0x9113);
inline const gdcm::Tag PlaneOrientation(0x0020, 0x9116);
inline const gdcm::Tag PixelMeasures(0x0028, 0x9110);
}

#endif
