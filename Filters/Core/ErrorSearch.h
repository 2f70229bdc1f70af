// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ErrorSearch.h
 * @brief From a number of triangles to the smallest error that can be proved, and the curve of one against the other.
 *
 *     FindSmallestError(N):
 *       best = decimate to N without a largest error; high = upper bound of its distance, by the certificate
 *       low = 0; e = high
 *       until low >= high (1 - precision):
 *         decimate to N with MaximumError = e
 *         reaches N:  best = it, high = upper bound of its distance, which is at most e
 *         else:       low = e
 *         e = high / 2 while low is 0, then sqrt(low high)
 *
 * Every run is decided by the runs before it and by nothing else: the answer is the same everywhere. That a larger error
 * gives no more triangles is nearly always so and not a law: what low says is that this error was tried in vain.
 */
#ifndef BoneDecimate_Core_ErrorSearch_h
#define BoneDecimate_Core_ErrorSearch_h

#include "Decimate.h"

#include <vector>

namespace bonedecimate
{
/// One run of a search or of a curve.
struct ErrorTrial
{
  double MaximumError = 0.0;  ///< mm, asked for; 0: none, the result was certified afterwards.
  std::int64_t Triangles = 0; ///< Of the result.
  double Proved = 0.0;        ///< mm, upper bound of the distance, both ways and of open borders.
  bool IsReached = false;     ///< It is proved, and there are no more triangles than asked for.
  double Seconds = 0.0;
};

struct ErrorSearchOptions
{
  /// Of every run; its number of triangles is what is asked for, its MaximumError does not count.
  bonedecimate::Options Run;
  double RelativePrecision = 0.02; ///< Above 0: the search ends when low and high are so near.
  int MostRuns = 40;
  bool InputIsSingle = false; ///< See Decimate().
};

struct ErrorSearchResult
{
  std::vector<ErrorTrial>
    Trials;      ///< In the order in which they were run; an aborted one is not in it.
  int Best = -1; ///< Of the trials; -1: no run reached the number of triangles.
  double TriedInVain =
    0.0; ///< mm, the largest error below the best one for which no run did; 0: none.
  bool WasAborted = false; ///< By the monitor; what was found before stays.
  Result Found;            ///< The best run; the last one if none reached the number.
};

/// @param options Run.TargetNumberOfTriangles must be above 0, and Run.Mode another than Thesis.
ErrorSearchResult FindSmallestError(
  const Surface& input, const ErrorSearchOptions& options, const Monitor& monitor = {});

/// One run for each largest error (mm, above 0), in their order; Found is the last, or the first that was refused, with its
/// status.
ErrorSearchResult FindErrorCurve(const Surface& input, const std::vector<double>& errors,
  const ErrorSearchOptions& options, const Monitor& monitor = {});
}

#endif
