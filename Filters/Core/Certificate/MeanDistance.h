// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeanDistance.h
 * @brief Average and root mean square of the distance over the area, to a stated precision.
 *
 *     linear part   between the corners' distances, and their squares, integrated exactly over each triangle
 *     the rest      at samples, one in each equal share of the area, more until the precision is reached
 *
 * The error stated is two standard errors, estimated from the differences of neighbouring shares (W. G. Cochran, Sampling
 * techniques, 1977, 5A.12: collapsed strata), which overestimates it. It is an estimate, no bound: bounds of the mean
 * would need as many cuts as there are triangles under each other.
 */
#ifndef BoneDecimate_Core_Certificate_MeanDistance_h
#define BoneDecimate_Core_Certificate_MeanDistance_h

#include "Certificate.h"
#include "Search.h"
#include "Simplices.h"
#include "Target.h"

namespace bonedecimate::certificate
{
/// @param precision Share of the mean and of the root mean square, 0 to 1.
MeanDistance FindMeanDistance(const Simplices& source, const Target& target,
  const PointValues& values, double precision, int threads, const Monitor& monitor);
}

#endif
