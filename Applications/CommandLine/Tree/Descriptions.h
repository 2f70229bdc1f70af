// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Descriptions.h
 * @brief Options that print what describes the program: completions, manual page, tables of the
 * documentation.
 */
#ifndef BoneDecimate_Applications_Descriptions_h
#define BoneDecimate_Applications_Descriptions_h

#include "Arguments/CliForward.h"

namespace bonedecimate
{
/// @param program With all of its commands when the line is parsed.
void AddDescriptions(CLI::App& command, const CLI::App& program);
}

#endif
