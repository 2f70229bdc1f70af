// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Prune.h
 * @brief Components that are too small, taken away on request: what is left is as if they had never been in the input.
 *
 *     components of the cleaned surface     connected by shared points
 *     of each: triangles, largest side of its box, area, and its volume if it is closed
 *     below any limit that is set: gone, and on the list
 */
#ifndef BoneDecimate_Core_Prune_h
#define BoneDecimate_Core_Prune_h

#include "Mesh/Cleaning.h"
#include "Options.h"
#include "Report.h"

namespace bonedecimate
{
/**
 * Nothing is changed without a limit, nor if nothing would be left: then the figures are of all components.
 * @param input What was cleaned.
 * @returns What went; see PruneFigures.
 */
PruneFigures Prune(const Surface& input, const Options& options, CleanSurface& cleaned);
}

#endif
