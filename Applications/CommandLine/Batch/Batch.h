// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Batch.h
 * @brief Many bones overnight.
 */
#ifndef BoneDecimate_Applications_Batch_h
#define BoneDecimate_Applications_Batch_h

#include "Arguments/Arguments.h"
#include "ExitCode.h"

#include <string>

namespace bonedecimate
{
/**
 * Every bone in a process of its own, --jobs at once. Whenever one has ended, it gets a line on the
 * standard output, and summary.csv is written anew, whole.
 * @param self argv[0], to start ourselves again.
 * @returns The highest code of all bones.
 * @throws Failure(ExitCode::Interrupted) after every child has ended.
 */
ExitCode RunBatch(const Arguments& arguments, const std::string& self);
}

#endif
