// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InputSize.h
 * @brief Checks the size of an input, and the largest error relative to it.
 *
 *     diagonal D    of the bounding box of all triangles, mm
 *     odd size      D < 2 mm or D > 3 m: a warning, since it is probably not a bone in millimeters
 *     error E       MaximumError or that of the preset; without both
 *                   the largest tolerance of a point
 *     E > D / 4     rejected, unless AllowLargeError; then E is at most D
 *     E < D / 1e6   rejected if it has to be proved: rounding alone exceeds it
 */
#ifndef BoneDecimate_Core_Run_Input_InputSize_h
#define BoneDecimate_Core_Run_Input_InputSize_h

#include "Figures/InputFigures.h"
#include "Figures/InputStatus.h"
#include "Mesh/Cleaning.h"
#include "Options/Options.h"

#include <vector>

namespace bonedecimate
{
/// @param tolerances mm, at each input point; may be null.
SizeFigures MeasureSize(
  const CleanSurface& clean, const Options& options, const std::vector<double>* tolerances);

InputStatus CheckSize(const SizeFigures& size, const Options& options);
}

#endif
