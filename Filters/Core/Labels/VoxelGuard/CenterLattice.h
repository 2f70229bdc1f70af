// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CenterLattice.h
 * @brief The coordinates of voxel centers as integers of 2^-30 step: at every step, or, along the
 * third axis, at positions of layers.
 *
 * Positions of layers are rounded to integers once, so all predicates agree on them. Layers have
 * the same indices as without positions of their own.
 */
#ifndef BoneDecimate_Core_Labels_VoxelGuard_CenterLattice_h
#define BoneDecimate_Core_Labels_VoxelGuard_CenterLattice_h

#include "FixedPoint.h"

#include <cstdint>
#include <vector>

namespace bonedecimate
{
class CenterLattice
{
public:
  CenterLattice() = default; ///< Centers at every step.
  explicit CenterLattice(const VoxelGrid& grid);

  /// The mirror image across the third axis.
  CenterLattice Mirrored() const;

  /// The coordinate of the centers with this index along an axis.
  std::int64_t Coordinate(std::size_t axis, std::int64_t index) const
  {
    return this->IsEven(axis) ? index * UnitsOfVoxel : this->LayerCoordinate(index);
  }
  /// The index of the first center at or above a coordinate.
  std::int64_t AtOrAbove(std::size_t axis, std::int64_t coordinate) const
  {
    return this->IsEven(axis) ? CenterAtOrAbove(coordinate)
                              : this->LayerAtOrBelow(coordinate - 1) + 1;
  }
  /// The index of the last center at or below a coordinate.
  std::int64_t AtOrBelow(std::size_t axis, std::int64_t coordinate) const
  {
    return this->IsEven(axis) ? CenterAtOrBelow(coordinate) : this->LayerAtOrBelow(coordinate);
  }

  /// Number of planes of voxel centers across an axis that meet the box.
  std::int64_t NumberOfPlanes(const FixedBox& box, std::size_t axis) const
  {
    return std::max<std::int64_t>(
      0, this->AtOrBelow(axis, box.High[axis]) - this->AtOrAbove(axis, box.Low[axis]) + 1);
  }
  bool HasCenter(const FixedBox& box) const
  {
    return this->NumberOfPlanes(box, 0) > 0 && this->NumberOfPlanes(box, 1) > 0 &&
      this->NumberOfPlanes(box, 2) > 0;
  }

  /// Whether centers are one step apart.
  bool IsEven(std::size_t axis) const { return axis != 2 || this->Layers.empty(); }

private:
  std::int64_t LayerCoordinate(std::int64_t index) const;
  std::int64_t LayerAtOrBelow(std::int64_t coordinate) const;

  // Empty, or at least two. Beyond the ends, layers continue at the distance of the last two.
  std::vector<std::int64_t> Layers;
};
}

#endif
