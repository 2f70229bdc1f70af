// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SentFields.h
 * @brief The field arrays of a label map on their way from one process to another.
 */
#ifndef BoneDecimate_Applications_SentFields_h
#define BoneDecimate_Applications_SentFields_h

#include "Pipe.h"

#include "vtkFieldData.h"

namespace bonedecimate::volume
{
void SendLabelFields(vtkFieldData* fields, Pipe& pipe);

/// False if the sender ended before it had sent all.
bool ReceiveLabelFields(Pipe& pipe, vtkFieldData* fields);
}

#endif
