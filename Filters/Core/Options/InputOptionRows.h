// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InputOptionRows.h
 * @brief Rows of the table of options: what is looked for in the input, and what of it is left out, on request.
 */
#ifndef BoneDecimate_Core_Options_InputOptionRows_h
#define BoneDecimate_Core_Options_InputOptionRows_h

#include "OptionTable.h"

#include <vector>

namespace bonedecimate
{
std::vector<OptionInfo> InputOptionRows();
}

#endif
