// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Cleaning.h
 * @brief Rejects invalid input, merges equal points, drops triangles without area, and counts all
 * of these.
 *
 *     check points and triangles
 *     each used point:   its representative is the first used point with the same coordinates
 *                        (PointMerging.h)
 *     each triangle:     dropped if two corners are equal, or if it has no area and neighbors at
 *                        no more than one edge
 *     renumber the representatives, replace the corners
 *
 * The result does not depend on the number of threads.
 */
#ifndef BoneDecimate_Core_Mesh_Cleaning_h
#define BoneDecimate_Core_Mesh_Cleaning_h

#include "Figures/InputFigures.h"
#include "Figures/InputStatus.h"
#include "Geometry/Surface.h"
#include "HalfEdgeMesh.h"

#include <vector>

namespace bonedecimate
{
/// A surface ready for the half-edge mesh, with maps to and from the input.
struct CleanSurface
{
  InputStatus Status = InputStatus::Good;
  CleaningStatistics Statistics;
  bonedecimate::Surface Surface;    ///< Points in mm relative to Origin; every point is used.
  Vector3 Origin = Vector3::Zero(); ///< mm, lower corner of the bounding box of used points.
  std::vector<Index> InputPoint;    ///< For each point, the first input point with its coordinates.
  std::vector<Index> InputPointCount; ///< For each point, how many input points it merges.
  std::vector<Index> InputTriangle;   ///< For each triangle, its input triangle.
  /// For each input point, its point here; None if no triangle uses it.
  std::vector<Index> PointOfInput;
  PatchMap ManifoldPatches; ///< Empty unless the surface was split.
};

/// The first kind of defect that makes the input unusable; Good if there is none.
InputStatus CheckSurface(const Surface& input, int threads, CleaningStatistics& found);

/**
 * Drops triangles with a repeated corner. A triangle without area but with three different corners
 * is dropped only if it has neighbors at no more than one edge; otherwise this would open a crack.
 * If Status is not Good, only Statistics is filled.
 */
CleanSurface Clean(const Surface& input, bool mergePoints, int threads = 1);
}

#endif
