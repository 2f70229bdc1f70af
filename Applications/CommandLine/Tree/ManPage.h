// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ManPage.h
 * @brief The manual page of the program, section 1.
 */
#ifndef BoneDecimate_Applications_ManPage_h
#define BoneDecimate_Applications_ManPage_h

#include "Tree/CommandTree.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/// The manual page in the macros man(7), for groff and mandoc.
std::string ManPage(const std::vector<CommandEntry>& commands);
}

#endif
