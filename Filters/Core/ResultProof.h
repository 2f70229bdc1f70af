// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ResultProof.h
 * @brief The certificate of a run: how far its result is from its input, proved, as both are stored.
 *
 *     reference = input, or what it was made from, without the triangles without area that cleaning dropped
 *     Certify(reference, result)         in input coordinates, rounded as they will be written
 *     bound of a point                   the largest upper bound of the triangles around it
 *
 * It reads nothing of the run but these surfaces. With a reference, tolerances of points are certified against the input,
 * apart. Triangles without area that were dropped are sets of points, too: the promise does not hold for them, and the
 * report counts them.
 */
#ifndef BoneDecimate_Core_ResultProof_h
#define BoneDecimate_Core_ResultProof_h

#include "Decimate.h"
#include "ReferenceInput.h"

namespace bonedecimate
{
/// Whether a run ends with its proof.
bool WantsProof(const Options& options, bool hasTolerances);

/**
 * Fills in the report's proof and the bounds at the points; without a promise there are bounds of the whole and no
 * verdict. What the certificate cannot judge is undecided. If the monitor stops it there is no proof.
 * @param cleaned Which triangles of the input count, and nothing else.
 * @param tolerances mm, of each input point, as CertificateOptions::ToleranceMap; null: none but MaximumError.
 * @param reference What MaximumError is promised against; null: the input.
 */
void ProveResult(const Surface& input, const CleanSurface& cleaned, const Options& options,
  const Monitor& monitor, Result& answer, const std::vector<double>* tolerances = nullptr,
  const KeptSurface* reference = nullptr);
}

#endif
