// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BindOptions.h
 * @brief The options of a run from an object of JavaScript, by the names of the option table.
 */
#ifndef BoneDecimate_Npm_BindOptions_h
#define BoneDecimate_Npm_BindOptions_h

#include "Options/Options.h"
#include "Values.h"

#include <string>

namespace bonedecimate
{
/// The table: name, kind, unit, choices, values, default and description of each option.
val OptionRows();

/// Sets the options that the object has. @returns What is wrong, in one sentence; empty if nothing
/// is.
std::string ReadOptions(const val& from, Options& options);
}

#endif
