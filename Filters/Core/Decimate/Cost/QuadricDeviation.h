// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file QuadricDeviation.h
 * @brief The cost of collapses in the modes Fast, Balanced and Accurate: the change of the normal
 * field.
 *
 * With the quadric Q of the edge (EdgeQuadric.h) at the position x (VolumePreserving.h):
 *
 *     S = tr M                                           twice the area of both rings
 *     q = max(Q(x), 0) + 1e-8 S |e|^2
 *     cost = c (S^(1/4) q^(3/4) + 0.03 (S / 2) D^(3/2))      c of CostNormalization()
 *
 * The first term is about area times distance^(3/2): the deviation of the old from the new normals
 * of the remaining faces, weighted by area and height. D is the larger of the errors accumulated at
 * both ends by earlier collapses (AccumulatedError.h). In flat parts, the second term of q, of the
 * size of a rounding error, collapses shorter edges first. On open boundaries, M contains 2 |b|^2
 * (I - b b^T / |b|^2) for each boundary edge b at both its ends.
 *
 * This is the scalar reference of a part of Decimate/Kernels/KernelSet.h, which gives the same
 * bits.
 *
 * P. Lindstrom, G. Turk, Fast and memory efficient polygonal simplification, 1998: memoryless
 * quadrics.
 */
#ifndef BoneDecimate_Core_Decimate_Cost_QuadricDeviation_h
#define BoneDecimate_Core_Decimate_Cost_QuadricDeviation_h

#include "CollapseInput.h"

namespace bonedecimate
{
constexpr float AccumulatedErrorWeight = 0.03F;
constexpr float FlatRatio = 1e-8F; ///< Factor of S |e|^2.

/// The cost: units of the mesh to the power of 3.5, times the normalization.
float QuadricDeviation(const CollapseInput& input);

/// The factor c = length^-3.5. It makes costs independent of how the unit was rounded.
/// @param length Mean edge length, units.
float CostNormalization(double length);
}

#endif
