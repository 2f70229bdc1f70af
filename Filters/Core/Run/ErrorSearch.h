// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ErrorSearch.h
 * @brief Finds the smallest error that can be proved for a number of triangles, and the curve of
 * triangles over errors.
 *
 *     FindSmallestError(N):
 *       best = decimate to N without a largest error; high = upper bound of its distance, by the
 *         certificate
 *       low = 0; e = high
 *       until low >= high (1 - precision):
 *         decimate to N with MaximumError = e
 *         reaches N:  best = it, high = upper bound of its distance, which is at most e
 *         else:       low = e, also if the input itself is farther than e from the reference
 *         e = high / 2 while low is 0, then sqrt(low high)
 *
 * Each error depends only on the results of earlier runs, so the search is the same on every
 * system. A larger error nearly always gives fewer triangles, but this is not guaranteed: low is an
 * error that was tried and failed.
 */
#ifndef BoneDecimate_Core_Run_ErrorSearch_h
#define BoneDecimate_Core_Run_ErrorSearch_h

#include "Decimate.h"

#include <cstdint>
#include <vector>

namespace bonedecimate
{
/// One run of a search or of a curve.
struct ErrorTrial
{
  double MaximumError = 0.0;  ///< mm, of the run; 0: none, the result was certified afterwards.
  std::int64_t Triangles = 0; ///< Number of triangles of the result.
  double Proved = 0.0;    ///< mm, upper bound of the distance, both ways and of open boundaries.
  bool IsReached = false; ///< The error is proved, and the number of triangles is reached.
  double Seconds = 0.0;   ///< Time of the run and its certificate.
  /// With another label than in the input; -1: no voxel grid is known.
  std::int64_t ChangedVoxels = -1;
};

/// What is searched for.
struct ErrorSearchOptions
{
  /// Options of every run; TargetNumberOfTriangles is the number to reach, MaximumError is ignored.
  bonedecimate::Options Run;
  /// Above 0: the search ends when low and high differ by no more.
  double RelativePrecision = 0.02;
  int MaxRuns = 40; ///< The search ends after as many, 1 or more.
  /// Inputs of every run; without a log. Errors are those to the reference if there is one.
  RunInputs Inputs;
};

/// What was found, and all runs that were tried.
struct ErrorSearchResult
{
  std::vector<ErrorTrial> Trials; ///< In the order of the runs; without an aborted one.
  int Best = -1;                  ///< Index of a trial; -1: no run reached the number of triangles.
  /// mm, the largest error below the best one with which a run failed; 0: none.
  double MaxFailedError = 0.0;
  bool WasAborted = false; ///< By the monitor; earlier results are kept.
  Result Found;            ///< The best run; the last one if none reached the number.
};

/// @param options Run.TargetNumberOfTriangles must be above 0, and Run.Mode must not be Thesis.
ErrorSearchResult FindSmallestError(
  const Surface& input, const ErrorSearchOptions& options, const Monitor& monitor = {});

/// One run for each largest error (mm, above 0), in their order. Found is the last run, or the
/// first rejected one, with its status.
ErrorSearchResult FindErrorCurve(const Surface& input, const std::vector<double>& errors,
  const ErrorSearchOptions& options, const Monitor& monitor = {});
}

#endif
