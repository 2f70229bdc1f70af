// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Motion.h
 * @brief Whether two triangles stay apart while their corners move along straight lines.
 *
 * A plane that keeps its normal separates the triangles at every time between two times at which it
 * does, because corners are linear in time. Where no such plane is found, time is halved.
 */
#ifndef BoneDecimate_Core_Smoothing_Motion_h
#define BoneDecimate_Core_Smoothing_Motion_h

#include "Proof/Guard/TrianglePair.h"

namespace bonedecimate
{
struct TrianglesInTime
{
  TriangleCorners First, Second; // mm
};

/// Whether two triangles that meet neither before nor after do not meet in between. True is proved;
/// false also where they move and come so near that it is not clear.
bool StayApart(const TrianglesInTime& before, const TrianglesInTime& after);
}

#endif
