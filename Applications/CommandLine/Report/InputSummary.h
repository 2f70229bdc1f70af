// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InputSummary.h
 * @brief The lines of the summary about the input: its size, specks, and what was left out, closed
 * or found in it.
 */
#ifndef BoneDecimate_Applications_InputSummary_h
#define BoneDecimate_Applications_InputSummary_h

#include "ReportFields.h"
#include "SurfaceExtents.h"

namespace bonedecimate
{
void PrintInputSummary(const ReportFields& report, const SpeckFigures& specks);
}

#endif
