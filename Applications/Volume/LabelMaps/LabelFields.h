// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelFields.h
 * @brief The field arrays LabelValues, LabelNames and LabelColors of a label map: what is known of
 * them.
 */
#ifndef BoneDecimate_Applications_LabelFields_h
#define BoneDecimate_Applications_LabelFields_h

#include "vtkFieldData.h"
#include "vtkImageData.h"

namespace bonedecimate::volume
{
inline constexpr const char* LabelNamesName = "LabelNames";
inline constexpr const char* LabelNumberNames[] = { "LabelValues", "LabelColors" };

/// Whether the image says itself that its values are labels.
bool HasLabelFields(vtkImageData* image);

/// Adds those of the three that there are.
void CopyLabelFields(vtkFieldData* from, vtkFieldData* to);
}

#endif
