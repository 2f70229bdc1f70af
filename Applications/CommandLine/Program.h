// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Program.h
 * @brief The program from its command line to its exit code.
 */
#ifndef BoneDecimate_Applications_Program_h
#define BoneDecimate_Applications_Program_h

#include "ExitCode.h"

namespace bonedecimate
{
/// A failure is one line on the standard error; nothing else goes there.
ExitCode RunProgram(int argc, char* argv[]);
}

#endif
