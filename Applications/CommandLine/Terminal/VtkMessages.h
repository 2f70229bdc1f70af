// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VtkMessages.h
 * @brief What VTK has to say, collected instead of printed.
 */
#ifndef BoneDecimate_Applications_VtkMessages_h
#define BoneDecimate_Applications_VtkMessages_h

#include <string>
#include <vector>

namespace bonedecimate
{
/// One line each, without VTK's file, line, class and address.
struct VtkMessages
{
  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
};

/// From now on no VTK class writes to the standard error.
void CollectVtkMessages();

/// Hands over what was collected since the last call.
VtkMessages TakeVtkMessages();
}

#endif
