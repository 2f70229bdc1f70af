// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BatchPlan.h
 * @brief Which bones a batch does, and the names of their files.
 */
#ifndef BoneDecimate_Applications_BatchPlan_h
#define BoneDecimate_Applications_BatchPlan_h

#include "Arguments/Arguments.h"
#include "ExitCode.h"

#include <string>
#include <vector>

namespace bonedecimate
{
struct BatchBone
{
  std::string Input;
  std::string Root;  ///< The folder that was searched, or the folder of a file that was named.
  std::string Below; ///< The folder of the input, relative to Root; empty: Root itself.
  std::string Name;  ///< Name of the outputs, unique in the batch; may have folders.
  std::string Output;
  std::string Report;
  bool Volume = false;
  std::string WhyNot;                  ///< Why the input is left out; empty for a bone.
  ExitCode CodeIfNot = ExitCode::Done; ///< Its exit code in the batch if it is left out.

  bool IsBone() const { return this->WhyNot.empty(); }
};

/**
 * Files in the order given, those of a folder sorted by name, with those of the folders in it:
 * every file, every folder of a DICOM series or TIFF slices, but hidden ones, those that --only
 * leaves out, and the output folder. Links to folders, folders with results of a batch, and what is
 * neither a surface nor a volume have a reason instead of outputs and count as Done, because the
 * command line did not name them; a volume without --iso and --segments counts as LeftOut, a folder
 * that cannot be read as InputRejected.
 */
std::vector<BatchBone> FindBones(const Arguments& arguments);

/**
 * The same, with their outputs.
 * @throws Failure(ExitCode::InputRejected) if there is no bone, Failure(ExitCode::Usage) if an
 * output is an input, or if --iso is given and there is no volume.
 */
std::vector<BatchBone> PlanBatch(const Arguments& arguments);

std::string PathBelow(const BatchBone& bone);
}

#endif
