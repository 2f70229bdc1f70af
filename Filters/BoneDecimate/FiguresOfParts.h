// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FiguresOfParts.h
 * @brief The report on a surface of which several processes have a part each, from numbers of the
 * parts.
 */
#ifndef FiguresOfParts_h
#define FiguresOfParts_h

#include "Run/Report/Report.h"

#include <vector>

namespace bonedecimate
{
/// @param ofParts vtkBoneDecimate::FiguresOfPart() of each part.
void TakeFiguresOfParts(const std::vector<std::vector<double>>& ofParts, Report& report);
}

#endif
