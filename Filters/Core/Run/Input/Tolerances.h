// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Tolerances.h
 * @brief Tolerances at input points: how far the surface may move there, mm.
 *
 *     0            the point and all triangles at it do not change in any bit
 *     positive     a largest error, linear on each triangle
 *     negative     no limit
 *
 * MaximumError caps all tolerances. Documentation/how-to/tolerance.md.
 */
#ifndef BoneDecimate_Core_Run_Input_Tolerances_h
#define BoneDecimate_Core_Run_Input_Tolerances_h

#include "Figures/InputFigures.h"
#include "Figures/InputStatus.h"
#include "Mesh/Cleaning.h"
#include "Mesh/PointRounding.h"
#include "Options/Options.h"

#include <vector>

namespace bonedecimate
{
/// Whether a run can use them; counts the invalid ones.
/// @param provesError Whether the mode proves errors. Without a proof, tolerances above 0 are
/// rejected.
InputStatus CheckTolerances(const std::vector<double>& given, std::size_t numberOfPoints,
  bool provesError, CleaningStatistics& found);

/// The largest error, mm (infinite: none), and tolerances of points, mm (null: none).
struct ErrorsOfPoints
{
  double Largest;
  const std::vector<double>* Tolerances;
};

/// Whether rounding the output keeps every point that triangles use within these errors;
/// counts the points that move too far.
InputStatus CheckRounding(const Surface& input, const CleanSurface& clean,
  const ErrorsOfPoints& errors, const PointRounding& rounding, CleaningStatistics& found);

/// Whether the tolerances (null: none) and the largest error are valid for the mode, the precision
/// of the output and the size of the input (InputSize.h). Lowers a largest error above the diagonal
/// to the diagonal.
InputStatus CheckErrors(const Surface& input, const CleanSurface& clean,
  const std::vector<double>* given, const PointRounding& rounding, Options& options,
  CleaningStatistics& found, SizeFigures& size);

/// The tolerances, mm, capped by the limit.
std::vector<double> LimitedTolerances(std::vector<double> given, double limit);

/// mm, for each point of the cleaned surface the least tolerance of the input points merged into
/// it; -1: none. Empty if no point has a tolerance.
std::vector<double> TolerancesOf(const CleanSurface& clean, const std::vector<double>& given);
}

#endif
