// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelFields.h
 * @brief The field arrays LabelValues, LabelNames and LabelColors of a label map: what is known of them, and their way from one process to another.
 */
#ifndef BoneDecimate_Applications_LabelFields_h
#define BoneDecimate_Applications_LabelFields_h

#include "Pipe.h"

#include "vtkFieldData.h"
#include "vtkImageData.h"

namespace bonedecimate::volume
{
/// Whether the image says itself that its values are labels.
bool HasLabelFields(vtkImageData* image);

/// Adds those of the three that there are.
void CopyLabelFields(vtkFieldData* from, vtkFieldData* to);

void SendLabelFields(vtkFieldData* fields, Pipe& pipe);

/// False if the sender ended before it had sent all.
bool ReceiveLabelFields(Pipe& pipe, vtkFieldData* fields);
}

#endif
