// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BindDecimate.h
 * @brief What a run returns, as Python sees it.
 */
#ifndef BoneDecimate_Wrapping_Wheel_BindDecimate_h
#define BoneDecimate_Wrapping_Wheel_BindDecimate_h

#include "Run/Decimate.h"

#include <nanobind/nanobind.h>

namespace bonedecimate
{
/// Arrays that were not filled are empty. @param input,threads Of the run.
nanobind::dict ToDict(Result&& result, const Surface& input, int threads);
}

#endif
