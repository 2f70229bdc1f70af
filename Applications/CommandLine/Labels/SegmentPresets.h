// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SegmentPresets.h
 * @brief Words that choose segments by what their names say.
 */
#ifndef BoneDecimate_Applications_SegmentPresets_h
#define BoneDecimate_Applications_SegmentPresets_h

#include <string>

namespace bonedecimate
{
/// Whether the word is one of "bones", "vertebrae", "pelvis" and "skull"; small and capital letters
/// are the same.
bool IsPreset(const std::string& word);

/// Whether a segment with this name belongs to the preset: one of the words in it is that of such a
/// bone, and none of them is that of a soft tissue. "C1" to "S5" are vertebrae.
bool IsOfPreset(const std::string& word, const std::string& name);
}

#endif
