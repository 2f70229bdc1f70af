// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointMerging.h
 * @brief Which points have exactly the same coordinates; -0 equals +0.
 *
 *     hash every point, distribute them over parts by the first bits of their hash
 *     for each part: a table of its own that fits into the cache, points entered in ascending order
 */
#ifndef BoneDecimate_Core_Mesh_PointMerging_h
#define BoneDecimate_Core_Mesh_PointMerging_h

#include "Memory/LargeArray.h"
#include "Surface.h"

#include <vector>

namespace bonedecimate
{
/**
 * @param representative Of each point to be compared itself, of the others None; becomes the least point with the same
 *   coordinates.
 * @return How many points are represented by another one.
 */
std::int64_t MergeEqualPoints(
  const std::vector<Vector3>& points, LargeArray<Index>& representative, int threads = 1);
}

#endif
