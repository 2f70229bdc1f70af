// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelMaps.h
 * @brief Label maps built in code, and the labels that surfaces give to voxels, by brute force and
 * without any code of the core.
 */
#ifndef BoneDecimate_Testing_LabelMaps_h
#define BoneDecimate_Testing_LabelMaps_h

#include "Geometry/Surface.h"
#include "Labels/LabelMap/VoxelGrid.h"
#include "Shapes.h"

#include <array>
#include <cstdint>
#include <vector>

namespace bonedecimate::testsupport
{
/// Labels of all voxels, x fastest.
struct LabelMap
{
  VoxelGrid Grid;
  std::vector<std::int32_t> Labels;
};

/// Spacing 1, origin 0.
LabelMap MakeLabelMap(const std::array<Index, 3>& size, const LabelOf& labelOf);

/// Each voxel has one of that many labels at random, from 0 on.
LabelMap NoiseLabels(const std::array<Index, 3>& size, int labels, std::uint64_t seed);

/// Two halves of an ellipsoid and a core that touches both, labels 1 to 3.
LabelMap EllipsoidLabels(const std::array<Index, 3>& size);

/// A grid with another origin and anisotropic spacing. It is turned about all three axes, and the
/// last axis is reversed if mirrored.
VoxelGrid ObliqueGrid(const std::array<Index, 3>& size, bool isMirrored);

/// The oblique grid with axes that are not perpendicular, as of a tilted gantry.
VoxelGrid ShearedGrid(const std::array<Index, 3>& size, bool isMirrored = false);

/// Gives a grid layers at 1, 1.75 and 3 times its spacing from each other, in this order.
VoxelGrid Uneven(VoxelGrid grid);

/// The triangles have labels on both sides; the normal points from the first to the second.
constexpr Index NoLabel = -1;

/**
 * The label of each voxel, x fastest, as an index: lines along the axis count how often they enter
 * and leave each label. They pass voxel centers at a distance of 1e-7 voxels and start in the
 * background. NoLabel where a voxel is in several or in none.
 */
std::vector<Index> VoxelizeLabels(const Surface& surface, const std::vector<BoundaryLabels>& labels,
  const VoxelGrid& grid, Index background, std::size_t axis);

/// The labels of the voxels of a grid.
struct VoxelLabels
{
  const std::vector<Index>& OfVoxel; ///< x fastest.
  Index Background;
  bool IsOpen = false; ///< The surface ends at the outermost voxel centers.
};

/**
 * Edges between neighboring voxel centers along the axis that do not cross the surface as the
 * labels of their ends demand: once more from the first to the second label than back, and all
 * other labels as often in as out. Edges from the image to the outside count. Of an open surface
 * only those that do not lie on its sides count.
 */
std::int64_t CountWrongGridEdges(const Surface& surface, const std::vector<BoundaryLabels>& labels,
  const VoxelGrid& grid, const VoxelLabels& voxels, std::size_t axis);
}

#endif
