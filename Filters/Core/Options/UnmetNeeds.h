// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file UnmetNeeds.h
 * @brief Which options have no effect because of other options.
 */
#ifndef BoneDecimate_Core_Options_UnmetNeeds_h
#define BoneDecimate_Core_Options_UnmetNeeds_h

#include "Options.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/**
 * One sentence for each list of needs of which an option that was set misses one, with the names
 * of properties: "VoxelSize has no effect; it needs ErrorPreset". A number that is 0 by default
 * and was set to 0 needs nothing.
 * @param given Names of the options that were set, also to their defaults.
 */
std::vector<std::string> UnmetNeeds(const Options& options, const std::vector<std::string>& given);
}

#endif
