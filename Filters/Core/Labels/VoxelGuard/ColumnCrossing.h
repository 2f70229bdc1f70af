// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ColumnCrossing.h
 * @brief Where a column of voxel centers crosses a triangle, exactly.
 *
 * Along axis r, with the other axes s = r + 1 and t = r + 2 in cyclic order, all voxel centers are
 * displaced by
 *
 *     (e^3, e, e^2) in (r, s, t)          0 < e, as small as needed
 *
 * Then no column meets an edge, no displaced center lies on a triangle, and triangles along the
 * column are not crossed. The side of an edge on which a column lies is antisymmetric in the ends
 * of the edge, so neighbors agree.
 *
 *     side of an edge:  sign of ds (t - at) - dt (s - as); if 0, of -dt, then of ds
 *     height:           sign of n . (center - q0); if 0, of ns, nt, then of nr
 *
 * Coordinates of a triangle must not differ by more than 2^11 voxels: products then have at most
 * 127 bits.
 */
#ifndef BoneDecimate_Core_Labels_VoxelGuard_ColumnCrossing_h
#define BoneDecimate_Core_Labels_VoxelGuard_ColumnCrossing_h

#include "CenterLattice.h"

#include <cstdint>

namespace bonedecimate
{
/// The largest side of a box for which the predicates are exact.
constexpr std::int64_t MaxPatch = UnitsOfVoxel << 10;

struct Column
{
  std::size_t Axis; ///< r
  std::int64_t S;   ///< Voxel indices across it.
  std::int64_t T;
};

struct ColumnCrossing
{
  int Sign = 0;           ///< Orientation of the triangle seen from above; 0: not crossed.
  std::int64_t Below = 0; ///< The highest voxel center below the triangle.
};

/// @param box The box of the triangle.
ColumnCrossing CrossColumn(const FixedTriangle& corners, const FixedBox& box, const Column& column,
  const CenterLattice& lattice = {});
}

#endif
