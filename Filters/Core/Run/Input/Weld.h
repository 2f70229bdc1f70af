// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Weld.h
 * @brief Moves points of open boundaries onto each other where that joins edges.
 *
 *     positions     points of equal coordinates are one
 *     boundary      edges of one triangle
 *     leaders       positions of the boundary in the order x, y, z: each joins the nearest
 *                   leader within the distance, or leads
 *     kept          positions whose boundary edge has the same two leaders as another
 *                   boundary edge; the others stay
 *
 * A position never joins one that has a triangle in common with it, so no triangle loses a corner.
 * No position moves farther than the distance: chains do not add up. Points that are not on a
 * boundary stay, so closed fragments are never joined. The result depends neither on the order of
 * points and triangles nor on threads. O(n log n) unless points have very many neighbors.
 */
#ifndef BoneDecimate_Core_Run_Input_Weld_h
#define BoneDecimate_Core_Run_Input_Weld_h

#include "Geometry/Surface.h"

#include <cstdint>
#include <vector>

namespace bonedecimate
{
struct WeldedPoints
{
  std::vector<Vector3> Points; ///< mm, all points of the input; joined ones have equal coordinates.
  std::int64_t Moved = 0;      ///< How many points moved.
  double Movement = 0.0;       ///< mm, how far one moved at most, rounded up.
};

/// @param input With valid corners and points (CheckSurface). @param distance mm, above 0.
/// @param stays For each point: whether it may not take part. Empty: none.
WeldedPoints Weld(const Surface& input, double distance, const std::vector<char>& stays);
}

#endif
