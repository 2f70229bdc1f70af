// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FilterOptions.h
 * @brief The options of the core's table, handed to the filter through its setters.
 */
#ifndef BoneDecimate_Applications_FilterOptions_h
#define BoneDecimate_Applications_FilterOptions_h

#include "Arguments.h"
#include "Options/Options.h"

#include "vtkBoneDecimate.h"

#include <string>

namespace bonedecimate
{
/// Sets every option of the table; TargetReduction only if it was set, because its default is
/// ignored beside other targets.
void ApplyOptions(const Options& options, vtkBoneDecimate* filter);

/**
 * The requested options, in the precision of the files: what is proved holds for them only if they
 * are read with the coordinates that were proved. Limits of --prune are those of voxels if there
 * are segments, and not of the filter.
 */
Options OptionsForFiles(const Arguments& arguments);

/// The number for SetMode() of any filter. @param name Name of a mode, validated, in any case.
int ModeNumber(const std::string& name);
}

#endif
