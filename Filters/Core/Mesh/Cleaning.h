// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Cleaning.h
 * @brief Refuses what cannot be a surface, merges equal points, drops triangles without area, counts everything.
 *
 *     check points and triangles
 *     each used point: the least used point with the same coordinates stands for it     PointMerging.h
 *     each triangle: dropped if corners are one, or flat and at most one edge is shared
 *     number the points that stand for a corner, rename the corners
 *
 * The same result whatever the number of threads.
 */
#ifndef BoneDecimate_Core_Mesh_Cleaning_h
#define BoneDecimate_Core_Mesh_Cleaning_h

#include "HalfEdgeMesh.h"
#include "Report.h"
#include "Surface.h"

#include <vector>

namespace bonedecimate
{
/// A surface ready for the half-edge mesh, and where each piece came from.
struct CleanSurface
{
  InputStatus Status = InputStatus::Good;
  CleaningStatistics Statistics;
  bonedecimate::Surface Surface;    ///< Points in mm relative to Origin; every point is used.
  Vector3 Origin = Vector3::Zero(); ///< mm, the least corner of the used points' bounding box.
  std::vector<Index> InputPoint; ///< Of each point: the least input point with these coordinates.
  std::vector<Index> InputPointCount; ///< Of each point: how many input points were merged into it.
  std::vector<Index> InputTriangle;   ///< Of each triangle.
  std::vector<Index>
    PointOfInput;  ///< Of each input point: its point here; None if no triangle uses it.
  SheetMap Sheets; ///< Empty until it is split.
};

/**
 * Triangles with a repeated corner are dropped. A triangle of zero area with three different corners is dropped
 * only if it shares at most one edge: otherwise it holds the surface together, and dropping it would open a crack.
 * If Status is not Good, only Statistics is filled.
 */
CleanSurface Clean(const Surface& input, bool mergePoints, int threads = 1);
}

#endif
