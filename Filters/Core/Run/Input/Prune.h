// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Prune.h
 * @brief Removes components that are too small on request, as if they had never been in the input.
 *
 *     components of the cleaned surface     connected by common points
 *     of each: number of triangles, longest side of its box, area, and volume if it is closed
 *     below any limit that is set: removed and reported
 */
#ifndef BoneDecimate_Core_Run_Input_Prune_h
#define BoneDecimate_Core_Run_Input_Prune_h

#include "Figures/InputFigures.h"
#include "Mesh/Cleaning.h"
#include "Options/Options.h"

namespace bonedecimate
{
/// Whether it is below a limit. No value is below a limit of 0, and a volume of NaN is below no
/// limit.
bool IsPruned(const PrunedComponent& component, const Options& limits);

/// Those of the components that are below a limit.
PruneFigures FindPruned(const std::vector<PrunedComponent>& components, const Options& limits);

/**
 * Without a limit nothing is changed. If no component would remain, nothing is changed either, and
 * all are reported.
 * @param input The surface before cleaning.
 * @returns The removed components; see PruneFigures.
 */
PruneFigures Prune(const Surface& input, const Options& options, CleanSurface& cleaned);
}

#endif
