// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DecimateCommand.h
 * @brief The default command in its two forms: the options of the program, and the words of the
 * thesis.
 */
#ifndef BoneDecimate_Applications_DecimateCommand_h
#define BoneDecimate_Applications_DecimateCommand_h

#include "Arguments/CliForward.h"
#include "ExitCode.h"

#include <string>

namespace bonedecimate
{
/// @param self argv[0], with which a batch starts its processes.
void AddDecimateCommand(CLI::App& program, const std::string& self, ExitCode& code);

void AddThesisCommand(CLI::App& program, ExitCode& code);

/// Smoothing alone: a run that removes no triangles.
void AddSmoothCommand(CLI::App& program, ExitCode& code);
}

#endif
