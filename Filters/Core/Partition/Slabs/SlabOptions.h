// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SlabOptions.h
 * @brief Which options a run in slabs can follow, and those of the run of one slab.
 */
#ifndef BoneDecimate_Core_Partition_Slabs_SlabOptions_h
#define BoneDecimate_Core_Partition_Slabs_SlabOptions_h

#include "SlabRun.h"

namespace bonedecimate
{
/// @param message Receives a sentence if an option cannot be followed.
Options OptionsOfSlabs(const Options& options, const SlabInputs& inputs, std::string& message);
}

#endif
