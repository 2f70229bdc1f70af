// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ExplainInput.h
 * @brief What --explain checks of the input and the outputs as the run does, and what it leaves to
 * the run.
 */
#ifndef BoneDecimate_Applications_ExplainInput_h
#define BoneDecimate_Applications_ExplainInput_h

#include "Arguments/Arguments.h"
#include "Explain/Explanation.h"

class vtkPolyData;

namespace bonedecimate
{
/**
 * Rejects a surface that the run would reject: its arrays, points and triangles, tolerances, and
 * the largest error against its size and the precision of the output.
 * @param surface mm, with the array of tolerances.
 * @param options Options of the run, with the largest error that it keeps.
 * @throws Failure(ExitCode::InputRejected) with the sentence of the run
 */
void RequireUsable(vtkPolyData* surface, const Options& options, const Arguments& arguments);

/// A sentence for each output of one bone whose folder does not exist.
std::vector<std::string> MissingFolders(const Arguments& arguments);

/// @param isRead Whether the points and triangles of the input were read.
void ExplainUnchecked(const Arguments& arguments, bool isRead, Explanation& explanation);
}

#endif
