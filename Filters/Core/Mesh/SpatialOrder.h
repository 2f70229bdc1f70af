// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SpatialOrder.h
 * @brief Puts neighbours in space next to each other in memory.
 *
 *     points     along the Z curve through a grid of 21 bits an axis, those of one cell by their coordinates, equal
 *                ones in their old order
 *     triangles  after their least point and the other corners from there on, equal ones in their old order
 *
 * The grid fills the bounding box, measured by its longest side: scaling by powers of two and moving by exactly
 * representable amounts keep the order, other units of length but for points that round into another cell. Sorting is
 * by radix: the curve's first 11 bits part the points into bins that are sorted side by side.
 *
 * G. M. Morton, A computer oriented geodetic data base and a new technique in file sequencing, IBM, 1966: the curve.
 */
#ifndef BoneDecimate_Core_Mesh_SpatialOrder_h
#define BoneDecimate_Core_Mesh_SpatialOrder_h

#include "Cleaning.h"

namespace bonedecimate
{
/// Sorts a good surface; its maps go along. The same order whatever the number of threads.
void SortAlongCurve(CleanSurface& clean, int threads = 1);

/// Old number of each point in its new place.
std::vector<Index> CurveOrder(const std::vector<Vector3>& points, int threads = 1);
}

#endif
