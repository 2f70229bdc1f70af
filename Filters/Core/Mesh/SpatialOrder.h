// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SpatialOrder.h
 * @brief Sorts points and triangles so that neighbors in space are near each other in memory.
 *
 *     points     along the Z curve through a grid of 21 bits per axis; points of one cell by
 *                their coordinates, equal ones in their old order
 *     triangles  by their smallest point, then by the other corners in turn, equal ones in
 *                their old order
 *
 * The grid fills the bounding box, scaled by its longest side. Scaling by powers of two and
 * translation by exactly representable vectors preserve the order; other units of length preserve
 * it except for points that round into another cell. Points are radix-sorted: the first 11 bits of
 * the curve divide them into bins, which are sorted in parallel.
 *
 * G. M. Morton, A computer oriented geodetic data base and a new technique in file sequencing, IBM,
 * 1966: the curve.
 */
#ifndef BoneDecimate_Core_Mesh_SpatialOrder_h
#define BoneDecimate_Core_Mesh_SpatialOrder_h

#include "Cleaning.h"

namespace bonedecimate
{
/// Sorts a good surface and updates its maps. The order does not depend on the number of threads. A
/// surface that was split must have been sorted before; its duplicates stay at the end.
void SortAlongCurve(CleanSurface& clean, int threads = 1);

/// For each point in the new order, its old index.
std::vector<Index> CurveOrder(const std::vector<Vector3>& points, int threads = 1);
}

#endif
