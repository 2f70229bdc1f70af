// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelShapes.h
 * @brief Segmentations of known shapes, their surfaces, and the label of points: for tests, without
 * any code of the core.
 */
#ifndef BoneDecimate_Testing_LabelShapes_h
#define BoneDecimate_Testing_LabelShapes_h

#include "Geometry/Surface.h"
#include "Labels/LabelMap/VoxelGrid.h"

#include <cstdint>
#include <functional>

namespace bonedecimate::testsupport
{
/// Whether a point (mm) is inside of a shape.
using IsInsideOf = std::function<bool(const Vector3& p)>;
IsInsideOf BallShape(double radius);
IsInsideOf TorusShape(double ring, double tube);
IsInsideOf BoxShape(const Vector3& half);
/// The shape, turned about an oblique axis and shifted by a part of a voxel, so that grid planes
/// have no special position.
IsInsideOf Oblique(IsInsideOf shape);

struct BinarySurface
{
  bonedecimate::Surface Surface; ///< mm, counter-clockwise seen from outside, closed.
  LabelMapSource Source;         ///< Grid and grid points.
  std::vector<char> Voxels;      ///< 1: inside; the first axis fastest.
};
/// Marching cubes of the voxels of a shape at the origin: points are the middles of grid edges.
/// @param half mm, of the volume; one voxel more is left empty all around.
BinarySurface MarchedShape(const IsInsideOf& shape, double half, const Vector3& spacing);

/// Voxels of a grid whose center is on the other side of a closed surface than it was.
/// Rays along an axis a little beside the centers count crossings.
std::int64_t CountChangedVoxels(const BinarySurface& binary, const Surface& surface);

/// The sides between voxels of different labels, two triangles each, as one complex: walls that
/// meet have points and edges in common.
struct BlockComplex
{
  bonedecimate::Surface Surface;
  std::vector<BoundaryLabels> Labels; ///< Labels on both sides of each triangle.
};
BlockComplex BlocksOf(const std::array<Index, 3>& size,
  const std::function<Index(const std::array<Index, 3>& voxel)>& labelOf);
}

#endif
