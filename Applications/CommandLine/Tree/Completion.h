// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Completion.h
 * @brief Scripts that make shells complete commands, options, their choices and the files that each
 * takes.
 */
#ifndef BoneDecimate_Applications_Completion_h
#define BoneDecimate_Applications_Completion_h

#include "Tree/CommandTree.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/// @name For bash 4 or later, zsh 5 or later, fish 3 or later; they need no other package. @{
std::string BashCompletion(const std::vector<CommandEntry>& commands);
std::string ZshCompletion(const std::vector<CommandEntry>& commands);
std::string FishCompletion(const std::vector<CommandEntry>& commands);
/// @}
}

#endif
