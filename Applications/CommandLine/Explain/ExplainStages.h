// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ExplainStages.h
 * @brief The steps of a run in their order, and what ends it.
 */
#ifndef BoneDecimate_Applications_ExplainStages_h
#define BoneDecimate_Applications_ExplainStages_h

#include "Arguments/Arguments.h"
#include "Explain/Explanation.h"

namespace bonedecimate
{
/// @param options Options of the run. @param triangles Triangles of the input; 0: not known.
void ExplainStages(
  const Arguments& arguments, const Options& options, double triangles, Explanation& explanation);
}

#endif
