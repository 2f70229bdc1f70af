// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InputHints.h
 * @brief What a look at the surfaces of files tells: cells that are no part of a surface, two files
 * of different units. The filters tell what makes a surface hard to simplify.
 */
#ifndef BoneDecimate_Applications_InputHints_h
#define BoneDecimate_Applications_InputHints_h

#include "vtkPolyData.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/// Empty if there are none.
std::string VertexCellsHint(vtkPolyData* input);

/// A warning if one of two surfaces is nine or more times as large as the other.
void WarnOfUnits(vtkPolyData* reference, vtkPolyData* result, std::vector<std::string>& warnings);
}

#endif
