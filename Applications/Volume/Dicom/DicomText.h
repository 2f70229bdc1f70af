// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DicomText.h
 * @brief Names in DICOM files, whose character set is one of many, as UTF-8.
 */
#ifndef BoneDecimate_Applications_DicomText_h
#define BoneDecimate_Applications_DicomText_h

#include <string>

namespace bonedecimate::volume
{
/**
 * @param characterSet The attribute Specific Character Set, "ISO_IR 100" for example. Of several
 *   values the first counts. Without one it is Latin 1.
 * @return The text in UTF-8. Characters that it does not have, and those of unknown character sets
 *   outside of ASCII, are question marks.
 */
std::string Utf8Of(const std::string& text, const std::string& characterSet);
}

#endif
