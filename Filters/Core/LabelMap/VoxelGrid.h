// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VoxelGrid.h
 * @brief The grid of voxel centers of an image, and what is known of a surface that was extracted from its labels.
 *
 * Positions are either in millimeters or in voxels: voxel centers have integer coordinates there.
 */
#ifndef BoneDecimate_Core_LabelMap_VoxelGrid_h
#define BoneDecimate_Core_LabelMap_VoxelGrid_h

#include "Surface.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bonedecimate
{
struct VoxelGrid
{
  Vector3 Origin = Vector3::Zero();  ///< mm, the center of voxel 0, 0, 0.
  Vector3 Spacing = Vector3::Ones(); ///< mm, positive.
  Eigen::Matrix3d Direction =
    Eigen::Matrix3d::Identity();                 ///< Columns: unit vectors of the axes, orthogonal.
  std::array<Index, 3> Dimensions = { 0, 0, 0 }; ///< Number of voxels; 0: not known.

  std::size_t NumberOfVoxels() const
  {
    return static_cast<std::size_t>(this->Dimensions[0]) *
      static_cast<std::size_t>(this->Dimensions[1]) * static_cast<std::size_t>(this->Dimensions[2]);
  }
  Vector3 ToMillimeters(const Vector3& voxels) const
  {
    return this->Origin + this->Direction * this->Spacing.cwiseProduct(voxels);
  }
  Vector3 ToVoxels(const Vector3& millimeters) const
  {
    return (this->Direction.transpose() * (millimeters - this->Origin))
      .cwiseQuotient(this->Spacing);
  }
};

/**
 * Twice the voxel coordinates of the middle of a grid edge, of a cell's face or of a cell. The number of odd coordinates tells
 * which: 1, 2 or 3. A point keeps the labels of all voxels while it stays in the octahedron
 *
 *     sum of |x - center| over the axes, in voxels  <  half the number of odd coordinates
 */
using GridPoint = std::array<std::int32_t, 3>;

/// Labels on the two sides of a triangle, as indices into LabelMapSource::Values. The normal points from the first to the
/// second, and the first index is less than the second. The background has the largest index, so normals point out of the bone.
using BoundaryLabels = std::array<Index, 2>;

/// What is known of the label map from which a surface was extracted.
struct LabelMapSource
{
  VoxelGrid Grid;
  /// The labels of the image, ascending, and at the end the background, which may be less than they are.
  std::vector<std::int64_t> Values;
  std::vector<BoundaryLabels> OfTriangle; ///< Empty: one label.
  std::vector<GridPoint> OfPoint;         ///< Where each point was extracted. Empty: not known.

  /// The index of the background.
  Index Background() const { return static_cast<Index>(this->Values.size()) - 1; }
};
}

#endif
