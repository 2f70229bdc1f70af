// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PairCertificate.h
 * @brief Certifies both directions between two sets of triangles or of segments: distances, and
 * excess over tolerances.
 */
#ifndef BoneDecimate_Core_Proof_Certificate_PairCertificate_h
#define BoneDecimate_Core_Proof_Certificate_PairCertificate_h

#include "Certificate.h"
#include "Frame.h"
#include "Simplices.h"
#include "Stages.h"

#include <limits>
#include <memory>
#include <vector>

namespace bonedecimate::certificate
{
struct PairTask
{
  const CertificateOptions& Options;
  double Slack;            ///< mm
  bool AreSurfaces = true; ///< False: boundaries.
};

struct PairCertificate
{
  DirectedCertificate ReferenceToResult, ResultToReference;
};

class DirectedSearch;

/// Finds the bounds of both directions step by step, so that both are known early.
class PairSearch
{
public:
  /// Keeps references to all but the function. The sets must not be empty.
  /// @param limit mm, at each point of the reference, infinite where there is no limit; empty
  ///   without a map.
  /// @param listener Called on the calling thread with bounds of both directions; may be empty.
  PairSearch(const Simplices& reference, const Simplices& result, const std::vector<double>& limit,
    const PairTask& task, BoundsListener listener);
  ~PairSearch();

  /// @param weight Part of the whole progress, 0 to 1.
  void FindBounds(Stages& progress, double weight);
  /// Means and distances of points.
  void AddStatistics(Stages& progress, double weight);
  /// @param wasStopped The bounds are those proved so far.
  PairCertificate Found(bool wasStopped);

private:
  void Tell();
  void FindValues(Stages& progress, double weight);
  void FindExcess(Stages& progress, double weight);

  const Simplices& Reference;
  const std::vector<double>& Limit;
  BoundsListener Listener;
  int NumberOfThreads;
  double ToldLower = -1.0;                                    // mm
  double ToldUpper = std::numeric_limits<double>::infinity(); // mm
  std::unique_ptr<DirectedSearch> Forward;
  std::unique_ptr<DirectedSearch> Backward; // null: one-sided
};

/// mm, the largest finite limit; 0 without any.
double MaxFinite(const std::vector<double>& limits);

/// The bounds if at least one set is empty: 0 from an empty set, infinite to it.
PairCertificate WithoutPartner(
  const BoundarySet& reference, const BoundarySet& result, const PairTask& task);
}

#endif
