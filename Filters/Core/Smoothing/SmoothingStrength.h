// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SmoothingStrength.h
 * @brief The strength lambda of the smoothing of a binary surface, by the discrepancy principle.
 *
 * A segmentation rounds the position of the surface to the midpoint of a grid edge. The rounding
 * error along the surface's normal n is uniform, with the standard deviation h |n . e| / sqrt 3 for
 * a grid edge along e of length 2 h. Smoothing should remove this much and not more:
 *
 *     RMS(n . d)  =  0.7 RMS(h |n . e| / sqrt 3)         over points on grid edges that may move
 *
 * Starts at 5, with at most three solves of ten iterations, each from the result of the one before,
 * and secant steps of the logarithms, limited to 1 to 12.
 *
 * V. A. Morozov, On the solution of functional equations by the method of regularization, 1966: the
 * principle.
 */
#ifndef BoneDecimate_Core_Smoothing_SmoothingStrength_h
#define BoneDecimate_Core_Smoothing_SmoothingStrength_h

#include "BoundedSolver.h"

namespace bonedecimate
{
constexpr double MinStrength = 1.0;
constexpr double MaxStrength = 12.0;
/// The strength without a known grid.
constexpr double DefaultStrength = 3.0;

/// The input of the choice.
struct StrengthProblem
{
  const bonedecimate::Surface& Surface;
  const SmoothingGraph& Graph;
  const DisplacementSets& Sets;
  const LabelMapSource& Source; ///< With OfPoint.
  int Threads = 1;
};

/// @param displacements Receives those of the last solve, a start for the final one.
/// @param monitor May be empty.
double ChooseStrength(const StrengthProblem& problem, BoundedSolver& solver, const Monitor& monitor,
  std::vector<Vector3>& displacements);
}

#endif
