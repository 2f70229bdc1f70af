// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FirstBounds.h
 * @brief Bounds of the distance of one set to another before its search.
 */
#ifndef BoneDecimate_Core_Proof_Certificate_FirstBounds_h
#define BoneDecimate_Core_Proof_Certificate_FirstBounds_h

#include "Certificate.h"
#include "Simplices.h"
#include "Target.h"

namespace bonedecimate::certificate
{
/// The upper bound is the largest distance of a corner of the box of the source from one point of
/// the target: no point of a box is farther from a position than its corners. Both sets must not be
/// empty.
DistanceBounds FindFirstBounds(const Simplices& source, const Simplices& target, double slack);

/// mm, an upper bound: in each part of the source, the distance of one point plus the largest
/// distance of a corner from it.
double FindUpperOfParts(const Simplices& source, const Target& target, double slack, int threads);
}

#endif
