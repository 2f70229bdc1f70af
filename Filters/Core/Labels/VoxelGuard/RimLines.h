// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RimLines.h
 * @brief Edges between voxel centers that pass near the rim of an open surface.
 *
 * Whether an edge of the grid crosses the surface decides the labels of its ends. If the rim is
 * nearer to the edge than the rounding error of a program that voxelizes, rounding decides. The
 * surface of a volume ends in planes of voxel centers, so its rim meets edges of the grid in these
 * planes; an edit must not bring it near others.
 */
#ifndef BoneDecimate_Core_Labels_VoxelGuard_RimLines_h
#define BoneDecimate_Core_Labels_VoxelGuard_RimLines_h

#include "CenterLattice.h"

#include <vector>

namespace bonedecimate
{
/// An edge of the grid, from a voxel center to the next one along the axis.
struct GridEdge
{
  std::size_t Axis;
  FixedPoint From; ///< Voxel indices.

  bool operator==(const GridEdge& other) const
  {
    return this->Axis == other.Axis && this->From == other.From;
  }
};

/// Adds the edges of the grid that are nearer than the margin to the segment between two points.
/// @param margin Steps, less than 0.1.
void AddEdgesNear(const FixedPoint& from, const FixedPoint& to, double margin,
  const CenterLattice& lattice, std::vector<GridEdge>& edges);
}

#endif
