// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Explain.h
 * @brief --explain: what a run would do with these options on this input, without running it.
 */
#ifndef BoneDecimate_Applications_Explain_h
#define BoneDecimate_Applications_Explain_h

#include "Arguments/Arguments.h"
#include "ExitCode.h"

namespace bonedecimate
{
/// Adds --explain.
void AddExplain(CLI::App& app, Arguments& arguments);

/**
 * Reads the input, prints, writes nothing.
 * @return Exit code of the run as far as it is known before the first edit: Usage if the options
 * would be rejected.
 * @throws Failure as the run.
 */
ExitCode Explain(const Arguments& arguments);
}

#endif
