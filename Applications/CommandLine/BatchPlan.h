// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BatchPlan.h
 * @brief Which bones a batch does, and the names of their files.
 */
#ifndef BoneDecimate_Applications_BatchPlan_h
#define BoneDecimate_Applications_BatchPlan_h

#include "Arguments.h"

#include <map>
#include <string>
#include <vector>

namespace bonedecimate
{
struct BatchBone
{
  std::string Input;
  std::string Name; ///< Of the outputs, unlike that of any other bone of the batch.
  std::string Output;
  std::string Report;
  bool Volume = false;
};

/**
 * Files in the order given, those of a folder sorted by name: every surface file, and every volume
 * with --iso.
 * @throws Failure(ExitCode::InputRefused) if there is none, Failure(ExitCode::Usage) if an output
 * is an input.
 */
std::vector<BatchBone> PlanBatch(const Arguments& arguments);

/// The options that hold for one of them: --iso only for volumes.
std::map<std::string, std::string> GivenFor(const BatchBone& bone, const Arguments& arguments);

/// The words that make this program do one of them.
std::vector<std::string> WordsFor(const BatchBone& bone, const Arguments& arguments);
}

#endif
