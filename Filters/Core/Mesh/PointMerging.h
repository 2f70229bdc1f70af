// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointMerging.h
 * @brief Finds points with exactly the same coordinates; -0 equals +0.
 *
 *     hash every point; distribute the points over parts by the first bits of their hashes
 *     each part has a table that fits into the cache; enter its points in ascending order
 */
#ifndef BoneDecimate_Core_Mesh_PointMerging_h
#define BoneDecimate_Core_Mesh_PointMerging_h

#include "Base/LargeArray.h"
#include "Geometry/Surface.h"

#include <cstdint>
#include <vector>

namespace bonedecimate
{
/**
 * @param representative In: for each point to compare, its index; for others, None. Out: the first
 *   point with the same coordinates.
 * @return Number of points represented by another one.
 */
std::int64_t MergeEqualPoints(
  const std::vector<Vector3>& points, LargeArray<Index>& representative, int threads = 1);
}

#endif
