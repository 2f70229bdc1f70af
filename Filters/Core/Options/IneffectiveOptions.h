// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file IneffectiveOptions.h
 * @brief The one table of options that need others: without them no run looks at the value.
 */
#ifndef BoneDecimate_Core_Options_IneffectiveOptions_h
#define BoneDecimate_Core_Options_IneffectiveOptions_h

#include "Options.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/**
 * A sentence for each of the given options that cannot have an effect with the others as they are: "VoxelSize has no effect;
 * it needs ErrorPreset". What depends on the input, such as an array that is not there, is not known here.
 * @param given Names of the options that were set, to any value.
 */
std::vector<std::string> IneffectiveOptions(
  const Options& options, const std::vector<std::string>& given);

/// Names of the options that do not have their default, for callers that do not know which were set.
std::vector<std::string> ChangedOptions(const Options& options);
}

#endif
