// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InputHints.h
 * @brief What a look at the surfaces of files tells: cells that are no part of a surface. The
 * filters tell what makes a surface hard to simplify.
 */
#ifndef BoneDecimate_Applications_InputHints_h
#define BoneDecimate_Applications_InputHints_h

#include "vtkPolyData.h"

#include <string>

namespace bonedecimate
{
/// Empty if there are none.
std::string VertexCellsHint(vtkPolyData* input);
}

#endif
