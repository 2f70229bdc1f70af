// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StlText.h
 * @brief Text STL: words in any case, on any number of lines, with blank lines anywhere.
 */
#ifndef BoneDecimate_Applications_StlText_h
#define BoneDecimate_Applications_StlText_h

#include <string>
#include <string_view>

namespace bonedecimate
{
class CoordinateCollector;

/// Whether text STL can begin with the word.
bool IsStlWord(std::string_view word);

/// Adds three points for each facet; returns the frame that a name of a solid says (FileFrame.h).
std::string ReadStlText(const std::string& path, CoordinateCollector& points);
}

#endif
