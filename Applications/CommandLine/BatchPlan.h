// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BatchPlan.h
 * @brief Which bones a batch does, and the names of their files.
 */
#ifndef BoneDecimate_Applications_BatchPlan_h
#define BoneDecimate_Applications_BatchPlan_h

#include "Arguments.h"
#include "ExitCode.h"

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
  std::string WhyNot;                  ///< Why nothing is done with it; empty for a bone.
  ExitCode CodeIfNot = ExitCode::Done; ///< What that means for the batch.

  bool IsBone() const { return this->WhyNot.empty(); }
};

/**
 * Files in the order given, those of a folder sorted by name: every file and folder in it but hidden ones and the output
 * folder. What is neither a surface nor a volume has a reason instead of outputs and counts as Done, because the command line did not name it;
 * a volume without --iso and --segments counts as InputRejected.
 * @throws Failure(ExitCode::InputRejected) if there is no bone, Failure(ExitCode::Usage) if an output
 * is an input, or if --iso is given and there is no volume.
 */
std::vector<BatchBone> PlanBatch(const Arguments& arguments);

/// The options that hold for one of them: --iso and --segments only for volumes.
std::map<std::string, std::string> OptionsFor(const BatchBone& bone, const Arguments& arguments);

/// The words that make this program do one of them.
std::vector<std::string> WordsFor(const BatchBone& bone, const Arguments& arguments);
}

#endif
