// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PairCertificate.h
 * @brief Both directions between two sets of triangles or of segments, by distance and against tolerances.
 */
#ifndef BoneDecimate_Core_Certificate_PairCertificate_h
#define BoneDecimate_Core_Certificate_PairCertificate_h

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
  double Slack;           ///< mm
  bool OfSurfaces = true; ///< not of borders
};

struct PairCertificate
{
  DirectedCertificate ReferenceToResult, ResultToReference;
};

/**
 * @param limit mm, at each point of the reference, infinite where nothing limits; empty without a map.
 * @param share Of the whole progress.
 */
PairCertificate CertifyPair(const Simplices& reference, const Simplices& result,
  const std::vector<double>& limit, const PairTask& task, Stages& progress, double share);

/// If one set at least is empty: 0 from an empty set, infinite to it.
PairCertificate WithoutPartner(
  const BorderSet& reference, const BorderSet& result, const PairTask& task);
}

#endif
