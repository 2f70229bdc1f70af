// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Motion.h
 * @brief Whether two triangles stay apart while their corners move along straight lines.
 *
 * Corners are linear in time. So a plane of constant normal that separates the triangles at two
 * times does so at all times between. If no such plane is found, the interval of time is halved.
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
/// false also if they come so near that it stays open.
bool StayApart(const TrianglesInTime& before, const TrianglesInTime& after);
}

#endif
