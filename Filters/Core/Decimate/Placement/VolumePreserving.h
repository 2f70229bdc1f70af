// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VolumePreserving.h
 * @brief Where Fast, Balanced and Accurate put the merged vertex of an edge: nearest to the planes, the volume kept.
 *
 * With the quadric of the edge (EdgeQuadric.h), from its middle:
 *
 *     x0 = (M + 1e-5 tr M / 3 I)^-1 r                       least squared distance to the planes
 *     y  = (M + 1e-5 tr M / 3 I)^-1 g
 *     x  = x0 + y (d - g.x0) / (g.y)                        the same, volume kept
 *     |x| > 2 |w - v|: x0; if that is as far: the middle
 *     on the edge:  x = e clamp(r.e / (e.Me), -1, 1)        the minimum along the edge
 *
 * The ridge 1e-5 tr M / 3 pulls x to the middle in the directions that the planes leave open.
 *
 * This is the scalar reference of a part of Decimate/Kernels/KernelSet.h, which gives the same bits.
 *
 * P. Lindstrom, G. Turk, Fast and memory efficient polygonal simplification, 1998: volume kept.
 */
#ifndef BoneDecimate_Core_Decimate_Placement_VolumePreserving_h
#define BoneDecimate_Core_Decimate_Placement_VolumePreserving_h

#include "EdgeQuadric.h"
#include "Freedom.h"

namespace bonedecimate
{
constexpr float QuadricRidge = 1e-5F;        ///< Fraction of the mean eigenvalue of M.
constexpr float FarthestMoveSquared = 16.0F; ///< (2 lengths)^2 in squares of half a length.

/// From the middle of the edge, units; for Freedom::Nowhere as for Space.
Float3 VolumePreservingPosition(const EdgeQuadric& quadric, Freedom freedom);
}

#endif
