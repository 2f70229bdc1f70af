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

/**
 * @param limit mm, at each point of the reference, infinite where there is no limit; empty without
 *   a map.
 * @param weight Part of the whole progress, 0 to 1.
 */
PairCertificate CertifyPair(const Simplices& reference, const Simplices& result,
  const std::vector<double>& limit, const PairTask& task, Stages& progress, double weight);

/// mm, the largest finite limit; 0 without any.
double MaxFinite(const std::vector<double>& limits);

/// The bounds if at least one set is empty: 0 from an empty set, infinite to it.
PairCertificate WithoutPartner(
  const BoundarySet& reference, const BoundarySet& result, const PairTask& task);
}

#endif
