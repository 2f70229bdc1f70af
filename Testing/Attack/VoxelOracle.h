// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VoxelOracle.h
 * @brief What a surface does to the voxels of a label map, without code of the core.
 */
#ifndef BoneDecimate_Testing_VoxelOracle_h
#define BoneDecimate_Testing_VoxelOracle_h

#include "Geometry/Surface.h"
#include "Labels/LabelMap/VoxelGrid.h"

#include <cstdint>
#include <vector>

namespace bonedecimate::testsupport
{
struct LabeledTriangles
{
  const bonedecimate::Surface& Surface;
  const std::vector<BoundaryLabels>& Labels; ///< Labels on both sides of each triangle.
};

/**
 * Voxels whose center is not in their label and in no other one: winding numbers in integers of any
 * size, of the positions as they are stored.
 * @param voxels The index of the label of each voxel.
 */
std::int64_t CountWrongExactly(const LabeledTriangles& surface, const VoxelGrid& grid,
  const std::vector<Index>& voxels, Index background);

/// Pairs of a triangle and a voxel center nearer to it than that many voxels. Centers outside of
/// the image count, too.
std::int64_t CountNearCenters(const Surface& surface, const VoxelGrid& grid, double voxels);

/// Pairs of a boundary edge of an open surface and a line of voxel centers nearer to it than that
/// many voxels. Lines in the outermost planes, in which the surface ends, do not count.
std::int64_t CountRimsNearLines(
  const LabeledTriangles& surface, const VoxelGrid& grid, double voxels);

/// Pairs of triangles of which an edge of one pierces the other, by integers of any size. Triangles
/// that only touch do not count: the rounding of positions to those of the output decides whether
/// they do.
std::int64_t CountIntersections(const Surface& surface);

/// Whether the triangles around each label are a closed surface: walls are shared, and nothing is
/// open.
bool AreWallsShared(const LabeledTriangles& surface, Index numberOfLabels);

/// The triangles of one label; corners in the order that turns normals out of it.
Surface SurfaceOfLabel(const LabeledTriangles& surface, Index label);
}

#endif
