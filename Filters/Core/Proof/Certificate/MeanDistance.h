// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeanDistance.h
 * @brief Mean and root mean square of the distance over the area, to a requested precision.
 *
 *     linear part   the distances at the corners and their squares, interpolated and integrated
 *                   exactly
 *     the rest      at samples, one in each of many strata of equal area, until the precision
 *                   is reached
 *
 * The reported error is two standard errors, estimated from the differences of neighboring strata
 * (W. G. Cochran, Sampling techniques, 1977, 5A.12: collapsed strata), which overestimates it. It
 * is not a bound: to bound the mean, every triangle would have to be cut along all triangles of the
 * other surface under it.
 */
#ifndef BoneDecimate_Core_Proof_Certificate_MeanDistance_h
#define BoneDecimate_Core_Proof_Certificate_MeanDistance_h

#include "Certificate.h"
#include "Search.h"
#include "Simplices.h"
#include "Target.h"

namespace bonedecimate::certificate
{
/// @param precision Relative, 0 to 1; of the mean and of the root mean square.
/// @param rounding mm; an error that is not larger is small enough.
MeanDistance FindMeanDistance(const Simplices& source, const Target& target,
  const PointValues& values, double precision, double rounding, int threads,
  const Monitor& monitor);
}

#endif
