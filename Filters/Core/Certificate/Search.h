// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Search.h
 * @brief The largest distance of one set to another between a lower and an upper bound: branch and bound.
 *
 *     value of every corner                                lower = largest excess of a corner
 *     round by round, with 16 times as many cuts for each simplex as in the round before:
 *       for each simplex that is not closed yet, depth first from the whole of it:
 *         upper = least of  a. for a simplex F found nearest to one of the corners: largest excess over F of a corner
 *                           b. largest excess of a corner + how far a point of the piece can be from the corners
 *         upper <= goal: closed;   else cut an edge, find what is nearest to the new corner
 *     lower again, by looking at every simplex of the other set
 *
 * Excess: distance less what is tolerated, where 0 may be tolerated. Goal: the largest excess found so far and a little
 * more, or what somebody wants to know the excess to be below. Bound a holds because the distance to a convex set is a
 * convex function and tolerance is linear: where three corners keep it, every point between them does. It is exact as
 * soon as the corners have F in common, which is why edges are cut where two candidates are equally far. Bound b
 * holds because no distance changes by more than the way. Whoever finds the candidates can only make the search slow.
 *
 * H. Alt, P. Brass, M. Godau, C. Knauer, C. Wenk, Computing the Hausdorff distance of geometric patterns and shapes,
 * 2003: where maxima lie. M. Tang, M. Lee, Y. J. Kim, Interactive Hausdorff distance computation for general polygonal
 * models, 2009: bounds of pieces between surfaces.
 */
#ifndef BoneDecimate_Core_Certificate_Search_h
#define BoneDecimate_Core_Certificate_Search_h

#include "Certificate.h"
#include "Monitor.h"
#include "Simplices.h"
#include "Target.h"

#include <cstdint>
#include <vector>

namespace bonedecimate::certificate
{
struct SearchGoal
{
  double CloseBelow =
    0.0; ///< mm; where the excess is proved to be at most this, nobody looks closer
  double RelativeGap = 0.0; ///< of upper and lower bound
  double LeastGap = 0.0;    ///< mm; several slacks at least, or nothing is ever closed
  double Slack = 0.0;       ///< mm; see Slack()
  double Scale = 0.0;       ///< mm; added to the bound of which the gap is a share
  bool Decides = false; ///< Close nothing above CloseBelow as long as nothing was found above it.
  std::int64_t MostCuts = 0;
  int NumberOfThreads = 0;
};

/// The value of a point to the target, and the simplex that has it.
struct PointValues
{
  std::vector<double> Value;  ///< mm; not a number for points that were not looked at
  std::vector<Index> Simplex; ///< None there
};

/// @param ofAll Of all points that can be a corner, not only of those that are.
PointValues FindPointValues(
  const Simplices& source, const Target& target, bool ofAll, int threads, const Monitor& monitor);

/// Bounds of the largest excess of the source over the target.
/// @param monitor Not empty. If it stopped it, the upper bound is infinite.
DistanceBounds FindLargestExcess(const Simplices& source, const Target& target,
  const PointValues& values, const SearchGoal& goal, const Monitor& monitor);
}

#endif
