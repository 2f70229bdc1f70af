// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VolumePreserving.h
 * @brief The position of the merged vertex in Fast, Balanced and Accurate: nearest to the planes
 * while the volume is preserved.
 *
 * With the quadric of the edge (EdgeQuadric.h), relative to its middle:
 *
 *     x0 = (M + 1e-5 tr M / 3 I)^-1 r                       minimizes the squared distances
 *     y  = (M + 1e-5 tr M / 3 I)^-1 g
 *     x  = x0 + y (d - g.x0) / (g.y)                        the same with the volume preserved
 *     |x| > 2 |w - v|:  x0; if that is as far, the middle
 *     on the edge:      x = e clamp(r.e / (e.Me), -1, 1)    the minimum along the edge
 *
 * The ridge 1e-5 tr M / 3 pulls x to the middle in the directions that the planes leave open.
 *
 * This is the scalar reference of a part of Decimate/Kernels/KernelSet.h, which gives the same
 * bits.
 *
 * P. Lindstrom, G. Turk, Fast and memory efficient polygonal simplification, 1998: volume
 * preservation.
 */
#ifndef BoneDecimate_Core_Decimate_Placement_VolumePreserving_h
#define BoneDecimate_Core_Decimate_Placement_VolumePreserving_h

#include "EdgeQuadric.h"
#include "Freedom.h"

namespace bonedecimate
{
constexpr float QuadricRidge = 1e-5F;        ///< Fraction of the mean eigenvalue of M.
constexpr float FarthestMoveSquared = 16.0F; ///< (2 lengths)^2 in squares of half a length.

/// The position relative to the middle of the edge, units. Freedom::Nowhere is treated as Space.
Float3 VolumePreservingPosition(const EdgeQuadric& quadric, Freedom freedom);
}

#endif
