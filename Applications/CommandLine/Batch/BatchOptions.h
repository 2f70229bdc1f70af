// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BatchOptions.h
 * @brief The options of the runs of a batch, for their processes and as a text.
 */
#ifndef BoneDecimate_Applications_BatchOptions_h
#define BoneDecimate_Applications_BatchOptions_h

#include "Arguments/Arguments.h"
#include "BatchPlan.h"

#include <map>
#include <string>
#include <vector>

namespace bonedecimate
{
/// The options that hold for one of the bones: --iso and --segments only for volumes.
std::map<std::string, std::string> OptionsFor(const BatchBone& bone, const Arguments& arguments);

/// The options of the runs, as on a command line, without those that change no result.
std::string OptionsText(const Arguments& arguments);

/// The words that make this program do one of the bones.
std::vector<std::string> WordsFor(const BatchBone& bone, const Arguments& arguments);

/// Whether they leave open how far to go.
bool HasDefaultTarget(const Arguments& arguments);
}

#endif
