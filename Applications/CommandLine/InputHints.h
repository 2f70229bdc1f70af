// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InputHints.h
 * @brief What makes a surface hard to simplify, with a remedy: a double-sided surface, a soup of nearly equal points, one that is
 * inside out, and cells that are no part of the surface.
 */
#ifndef BoneDecimate_Applications_InputHints_h
#define BoneDecimate_Applications_InputHints_h

#include "vtkPolyData.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/**
 * A sentence for each. The diagnostics, which take time, are run only if the report tells that most of the surface is not manifold
 * or not connected, or that its volume is negative.
 * @param result Of a run, with its report. @param input Of the same run, mm.
 */
std::vector<std::string> InputHints(vtkPolyData* result, vtkPolyData* input, int threads);
}

#endif
