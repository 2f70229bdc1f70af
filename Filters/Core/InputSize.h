// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InputSize.h
 * @brief The size of an input, and whether the largest error suits it.
 *
 *     diagonal D    of the bounding box of all triangles, mm
 *     odd size      D < 2 mm or D > 3 m: probably not a bone in millimeters, a warning
 *     error E       MaximumError or that of the preset; without both the largest tolerance of a point
 *     E > D / 4     rejected, unless AllowLargeError; then E > D counts as D
 *     E < D / 1e6   rejected if it is to be proved: rounding alone exceeds it
 */
#ifndef BoneDecimate_Core_InputSize_h
#define BoneDecimate_Core_InputSize_h

#include "Mesh/Cleaning.h"
#include "Options.h"
#include "Report.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/// @param tolerances mm, of each input point; may be null.
SizeFigures MeasureSize(
  const CleanSurface& clean, const Options& options, const std::vector<double>* tolerances);

InputStatus CheckSize(const SizeFigures& size, const Options& options);

/// What the status of CheckSize() means.
std::string SizeMessage(const SizeFigures& size, InputStatus status);

/// That the size is odd, and that a smaller error than that asked for was used.
std::vector<std::string> SizeWarnings(const SizeFigures& size);
}

#endif
