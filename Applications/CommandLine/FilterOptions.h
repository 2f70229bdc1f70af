// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FilterOptions.h
 * @brief The options of the core's table, handed to the filter through its setters.
 */
#ifndef BoneDecimate_Applications_FilterOptions_h
#define BoneDecimate_Applications_FilterOptions_h

#include "Arguments.h"
#include "Options.h"

#include "vtkBoneDecimate.h"

#include <string>

namespace bonedecimate
{
/**
 * Calls the setter of every row of OptionTable(); TargetReduction only if it was asked for, for its
 * default steps back by itself.
 * @throws std::logic_error if a row has no setter here, so that no run can overlook a new option.
 */
void ApplyOptions(const Options& options, vtkBoneDecimate* filter);

/**
 * The options asked for, in the precision of the files: what is proved holds for them only if they are read with the
 * coordinates that were proved.
 */
Options OptionsForFiles(const Arguments& arguments);

/// For SetMode() of any filter that has one.  @param name Of a mode, checked, in letters of any size.
int ModeNumber(const std::string& name);
}

#endif
