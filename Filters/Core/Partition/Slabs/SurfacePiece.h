// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfacePiece.h
 * @brief A surface with the labels of its triangles: cut between planes, and joined.
 */
#ifndef BoneDecimate_Core_Partition_Slabs_SurfacePiece_h
#define BoneDecimate_Core_Partition_Slabs_SurfacePiece_h

#include "Geometry/Surface.h"
#include "Geometry/Zone.h"
#include "Labels/LabelMap/VoxelGrid.h"

#include <vector>

namespace bonedecimate
{
struct SurfacePiece
{
  Surface Shape;                      ///< mm
  std::vector<BoundaryLabels> Labels; ///< Labels of its triangles; empty: there is one label.
};

/// Whether a part of the triangle may lie between the planes.
bool Reaches(const std::vector<Vector3>& points, const Triangle& corners, const Zone& zone);

/// The triangles that reach between the planes, and their points, in their order.
SurfacePiece CutBetween(const SurfacePiece& surface, const Zone& zone);

/// The triangles of both pieces, in order; equal points are not merged.
SurfacePiece Joined(SurfacePiece first, const SurfacePiece& second);

/// The largest absolute coordinate of the points, mm.
double MaxCoordinateOf(const Surface& surface);

/// Removes points without triangles.
/// @return For each point that is left, its old index.
std::vector<Index> RemoveUnusedPoints(Surface& surface);
}

#endif
