// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Encoding.h
 * @brief Text of other encodings as UTF-8, by the system.
 */
#ifndef BoneDecimate_Applications_Encoding_h
#define BoneDecimate_Applications_Encoding_h

#include <string>

namespace bonedecimate::volume
{
/**
 * @param encoding As iconv calls it: "ISO-8859-1" for example.
 * @return What has no meaning in the encoding, and what is not ASCII if the system does not know
 *   it, are question marks.
 */
std::string Utf8From(const std::string& text, const std::string& encoding);
}

#endif
