// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LeftOutOfParts.h
 * @brief What a surface in parts left out, and the checksum of its result, from those of its parts.
 */
#ifndef LeftOutOfParts_h
#define LeftOutOfParts_h

#include "Run/Report/Report.h"

#include <vector>

namespace bonedecimate
{
/// @param ofParts vtkBoneDecimate::FiguresOfPart() of each part.
void TakeFiguresOfParts(const std::vector<std::vector<double>>& ofParts, Report& report);
}

#endif
