// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SummaryCommand.h
 * @brief bonedecimate summary: the table of a folder of results from the reports in it.
 */
#ifndef BoneDecimate_Applications_SummaryCommand_h
#define BoneDecimate_Applications_SummaryCommand_h

#include "ExitCode.h"

#include <CLI/App.hpp>

namespace bonedecimate
{
void AddSummaryCommand(CLI::App& program, ExitCode& code);
}

#endif
