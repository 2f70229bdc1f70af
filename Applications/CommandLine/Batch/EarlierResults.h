// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EarlierResults.h
 * @brief What earlier runs left in the output folder of a batch.
 */
#ifndef BoneDecimate_Applications_EarlierResults_h
#define BoneDecimate_Applications_EarlierResults_h

#include "Arguments/Arguments.h"
#include "BatchPlan.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/// Whether nothing is left to do: the result is of the same input, options and version.
bool HasEarlierResult(const BatchBone& bone, const Arguments& arguments);

/// The options of an earlier result, if it would be lost to those of this batch; otherwise empty.
std::string OtherOptions(const BatchBone& bone, const Arguments& arguments);

/// @throws Failure(ExitCode::Usage) if there is such a result, unless --force is set.
void RejectOtherOptions(const std::vector<BatchBone>& bones, const Arguments& arguments);
}

#endif
