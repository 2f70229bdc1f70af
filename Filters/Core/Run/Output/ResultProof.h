// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ResultProof.h
 * @brief The certificate of a run: proved bounds of the distance between input and result, as both
 * are stored.
 *
 *     reference = input, or the original from which it was made,
 *       without dropped and pruned triangles
 *     Certify(reference, result)         in input coordinates, rounded as they will be written
 *     bound of a point                   the largest upper bound of the triangles around it
 *
 * Reads only these surfaces. With a reference, tolerances of points are certified separately,
 * relative to the input. The bound does not hold for dropped triangles without area; the report
 * counts them.
 */
#ifndef BoneDecimate_Core_Run_Output_ResultProof_h
#define BoneDecimate_Core_Run_Output_ResultProof_h

#include "Base/Monitor.h"
#include "Options/Options.h"
#include "Proof/Certificate/Certificate.h"
#include "Result.h"
#include "Run/Input/ReferenceInput.h"

namespace bonedecimate
{
/// What a run has to prove.  @param tolerances mm, for each point of the input; null: none.
CertificateOptions ProofOptions(const Options& options, const std::vector<double>* tolerances);

/// mm, for each point the largest bound of the triangles around it; empty if there are no bounds of
/// triangles.
std::vector<double> BoundsAtPoints(
  const Surface& surface, const std::vector<double>& triangleBounds);

/// The status of two proofs that must both hold: violated, else undecided, else the first one.
inline ProofStatus WorseOf(ProofStatus one, ProofStatus other)
{
  const bool isWorse = other == ProofStatus::Violated ||
    (other == ProofStatus::Undecided && one == ProofStatus::Proved);
  return isWorse ? other : one;
}

/// Whether a run ends with its proof.
bool WantsProof(const Options& options, bool hasTolerances);

/// The run was aborted: a proof that it should have had is missing.
void MarkAborted(bool wantsProof, Report& report);

/**
 * Fills in the proof in the report and the bounds at points. Without an error or tolerances there
 * are bounds and no proof status. Surfaces that the certificate cannot compare are undecided.
 * After an abort there is no proof.
 * @param cleaned Only its list of kept input triangles is used.
 * @param tolerances mm, for each input point, as CertificateOptions::ToleranceMap; null:
 * MaximumError only.
 * @param reference The surface to which MaximumError refers; null: the input.
 */
void ProveResult(const Surface& input, const CleanSurface& cleaned, const Options& options,
  const Monitor& monitor, Result& output, const std::vector<double>* tolerances = nullptr,
  const KeptSurface* reference = nullptr);
}

#endif
