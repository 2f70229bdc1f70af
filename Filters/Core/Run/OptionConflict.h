// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OptionConflict.h
 * @brief Steps before a run, such as welding and closing tunnels, do not go with every kind of run (Options/RunKinds.h).
 */
#ifndef BoneDecimate_Core_Run_OptionConflict_h
#define BoneDecimate_Core_Run_OptionConflict_h

#include "Options/Options.h"
#include "Run/Input/RunInputs.h"
#include "Run/Output/Result.h"

#include <string>

namespace bonedecimate
{
/// Why an option does not go with what the run keeps or has, in one sentence; empty: all do.
std::string FindConflict(const Options& options, const RunInputs& inputs);

/// The result of a run that is rejected for that reason.
Result RejectedResult(const Options& options, const std::string& conflict);
}

#endif
