// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Tolerances.h
 * @brief How far the surface may move at each point, as it is asked for: mm, one for each input point.
 *
 *     0            the point and all triangles at it stay as they are, bit for bit
 *     positive     a largest error of its own, linear on each triangle
 *     negative     no limit of its own
 *
 * The largest error asked for everywhere caps them all. Documentation/tolerance.md.
 */
#ifndef BoneDecimate_Core_Tolerances_h
#define BoneDecimate_Core_Tolerances_h

#include "Mesh/Cleaning.h"
#include "Options.h"
#include "Report.h"

#include <vector>

namespace bonedecimate
{
/// Whether a run of that mode can use them; what is wrong is counted.
InputStatus CheckTolerances(const std::vector<double>& given, std::size_t numberOfPoints, Mode mode,
  CleaningStatistics& found);

/// Whether rounding the coordinates to single precision, as they are written, leaves every point that triangles use
/// within the largest error (mm; infinite: none) and its tolerance; what is moved too far is counted.
InputStatus CheckRounding(const Surface& input, const CleanSurface& clean, double largestError,
  const std::vector<double>* given, CleaningStatistics& found);

/// Whether the tolerances (null: none) and the largest error suit the mode, the precision of the output and the size of the
/// input (InputSize.h), which is put into the report. Lowers the largest error to the diagonal if it is more.
InputStatus CheckErrors(const Surface& input, const CleanSurface& clean,
  const std::vector<double>* given, bool roundsToSingle, Options& options, Report& report);

/// mm, the tolerances, none above the limit.
std::vector<double> LimitedTolerances(std::vector<double> given, double limit);

/// mm, of each point of the cleaned surface: the least of the input points that became it, -1: none. Empty if nothing
/// limits anything.
std::vector<double> TolerancesOf(const CleanSurface& clean, const std::vector<double>& given);
}

#endif
