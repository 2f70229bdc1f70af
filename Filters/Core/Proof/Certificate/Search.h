// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Search.h
 * @brief Lower and upper bound of the largest distance of one set to another by branch and bound.
 *
 *     value of every corner;  lower = largest excess of a corner
 *     in rounds, each with 16 times as many cuts for each simplex as the one before:
 *       for each simplex that is not closed, depth first over its pieces:
 *         upper = least of
 *           a.   over a simplex F that is nearest to one of the corners:
 *                  the largest excess of a corner over F
 *           b.   largest excess of a corner + the largest distance of a point of the piece
 *                  from its nearest corner
 *           c.   what several simplices that cover the piece prove: OverlayCover.h, JointCover.h
 *         upper <= goal: closed;   else cut an edge, find the simplex nearest to the new corner
 *     lower bound again, by the distance to every simplex of the other set
 *
 * Simplices form parts. At any moment the upper bound is the largest one of a part: after its
 * search that of its pieces, before it the bound of its whole simplices, or what the round before
 * left. So the bounds of a stopped search hold, too.
 *
 * Excess: distance minus tolerance, which may be 0. Goal: the largest excess found so far plus the
 * gap, or CloseBelow, below which the excess need not be known more precisely.
 *
 * Bound a holds because the distance to a convex set is a convex function and the tolerance is
 * linear, so the excess is largest at a corner. It is exact as soon as F is the nearest simplex of
 * all corners, which is why edges are cut where two candidates are equally far. Bound b holds
 * because the distance is 1-Lipschitz. Wrong candidates make the search slower, never wrong.
 *
 * H. Alt, P. Brass, M. Godau, C. Knauer, C. Wenk, Computing the Hausdorff distance of geometric
 * patterns and shapes, 2003: where maxima lie.
 *
 * M. Tang, M. Lee, Y. J. Kim, Interactive Hausdorff distance computation for general polygonal
 * models, 2009: bounds of pieces between surfaces.
 */
#ifndef BoneDecimate_Core_Proof_Certificate_Search_h
#define BoneDecimate_Core_Proof_Certificate_Search_h

#include "Base/Monitor.h"
#include "Certificate.h"
#include "Simplices.h"
#include "Target.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace bonedecimate::certificate
{
struct SearchGoal
{
  double CloseBelow = 0.0;  ///< mm; pieces are not refined if no excess exceeds this
  double RelativeGap = 0.0; ///< of upper and lower bound
  double MinGap = 0.0;      ///< mm; at least several slacks, or no piece is ever closed
  double Slack = 0.0;       ///< mm; see Slack()
  double Scale = 0.0;       ///< mm; added to the excess to which RelativeGap applies
  /// Close no piece above CloseBelow before an excess above it is found.
  bool Decides = false;
  std::int64_t MaxCuts = 0;
  int NumberOfThreads = 0;
};

/// The value of each point to the target (Target.h), and the simplex with this value.
struct PointValues
{
  std::vector<double> Value;  ///< mm; NaN for points that were not evaluated
  std::vector<Index> Simplex; ///< None for these points
};

/// The position with the largest excess found so far.
struct MaxExcess
{
  double Value = -std::numeric_limits<double>::infinity(); // mm, excess
  double Tolerance = 0.0;                                  // mm
  Vector3 Position = Vector3::Zero();                      // mm
  Index Simplex = None;
  Index Nearest = None; // of the target

  void Join(const MaxExcess& other)
  {
    if (other.Value > this->Value)
    {
      *this = other;
    }
  }
};

/// What is known before a search.
struct KnownBounds
{
  std::vector<double> Upper; ///< mm, of the excess of each simplex; empty: unknown
  MaxExcess Max;
};

/// Called on the calling thread with an upper bound (mm) that holds at that moment, and the largest
/// excess found so far.
using SearchListener = std::function<void(double upper, const MaxExcess& max)>;

/// @param allPoints Evaluate all usable points, not only corners.
/// @param sufficient mm; values up to this need not be the least. Negative: all are the least.
PointValues FindPointValues(const Simplices& source, const Target& target, bool allPoints,
  double sufficient, int threads, const Monitor& monitor);

/// Bounds of the largest excess of the source over the target.
/// @param known Simplices whose upper bound is small enough are not searched.
/// @param monitor Not empty. After an abort the bounds are those proved so far.
/// @param listener May be empty.
DistanceBounds FindMaxExcess(const Simplices& source, const Target& target,
  const PointValues& values, const SearchGoal& goal, const KnownBounds& known,
  const Monitor& monitor, const SearchListener& listener = {});

/// The same without a cut: of whole simplices.
DistanceBounds FindBoundsWithoutCuts(
  const Simplices& source, const Target& target, const PointValues& values, const SearchGoal& goal);
}

#endif
