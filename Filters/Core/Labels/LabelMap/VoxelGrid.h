// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VoxelGrid.h
 * @brief The grid of voxel centers of an image, and what is known of a surface that was extracted
 * from its labels.
 *
 * Positions are in mm or in voxels; in voxels, voxel centers have integer coordinates.
 */
#ifndef BoneDecimate_Core_Labels_LabelMap_VoxelGrid_h
#define BoneDecimate_Core_Labels_LabelMap_VoxelGrid_h

#include "Geometry/Surface.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bonedecimate
{
/**
 * From voxels n = (i, j, k) to mm:
 *
 *     mm(n) = Origin + Direction * (Spacing[0] i, Spacing[1] j, Spacing[2] s(k))
 *     s(k)  = k, or Layers[k] / Spacing[2] if layers have positions of their own; linear between
 *             two layers and beyond the ends
 *
 * (i, j, s) are the steps of a position. Predicates and displacements are computed in steps, which
 * are linear in mm, so triangles are flat. In voxels they are not where the distance of layers
 * changes.
 */
struct VoxelGrid
{
  Vector3 Origin = Vector3::Zero(); ///< mm, the center of voxel 0, 0, 0.
  /// mm, positive; with Layers the third is the least distance of two.
  Vector3 Spacing = Vector3::Ones();
  /// Columns: unit vectors of the axes. Orthogonal unless the gantry was tilted, which shears the
  /// grid.
  Eigen::Matrix3d Direction = Eigen::Matrix3d::Identity();
  std::array<Index, 3> Dimensions = { 0, 0, 0 }; ///< Number of voxels; 0: not known.
  /// mm along the third axis, of each layer from the first one, ascending.
  /// Empty: layers are Spacing[2] apart.
  std::vector<double> Layers = {};

  std::size_t NumberOfVoxels() const
  {
    return static_cast<std::size_t>(this->Dimensions[0]) *
      static_cast<std::size_t>(this->Dimensions[1]) * static_cast<std::size_t>(this->Dimensions[2]);
  }
  bool HasLayers() const { return !this->Layers.empty(); }

  Vector3 ToMillimeters(const Vector3& voxels) const
  {
    return this->Origin +
      this->Direction *
      this->Spacing.cwiseProduct(this->HasLayers() ? this->StepsOfVoxels(voxels) : voxels);
  }
  Vector3 ToVoxels(const Vector3& millimeters) const
  {
    const Vector3 steps = this->ToSteps(millimeters);
    return this->HasLayers() ? Vector3(steps[0], steps[1], this->LayerAt(steps[2])) : steps;
  }
  Vector3 ToSteps(const Vector3& millimeters) const
  {
    // The transpose, not an inverse, for the same bits in all versions.
    return this->IsOrthogonal()
      ? Vector3(
          (this->Direction.transpose() * (millimeters - this->Origin)).cwiseQuotient(this->Spacing))
      : this->ShearedSteps(millimeters);
  }

  /// Whether the axes are orthogonal, up to rounding. Otherwise the grid is sheared.
  bool IsOrthogonal() const
  {
    constexpr double rounding = 1e-6;
    const Vector3 x = this->Direction.col(0);
    const Vector3 y = this->Direction.col(1);
    const Vector3 z = this->Direction.col(2);
    return std::abs(Dot(x, y)) <= rounding && std::abs(Dot(y, z)) <= rounding &&
      std::abs(Dot(z, x)) <= rounding;
  }
  /// The inverse of Direction; its transpose if it is orthogonal.
  Eigen::Matrix3d InverseDirection() const;
  /// Whether the numbers describe a grid: finite, distances positive, axes unit vectors that are
  /// not in one plane, and one ascending position for each layer, if any.
  bool IsValid() const;
  /// The unit normal of the layers, on the side of the third axis.
  Vector3 LayerNormal() const;

  /// s(k), also between layers.
  double StepsOf(double layer) const;
  /// The layer at s(k), also between layers.
  double LayerAt(double steps) const;
  /// The first layer whose center is at this height or above, and the last one at it or below.
  std::int64_t FirstLayerAtOrAbove(double steps) const;
  std::int64_t LastLayerAtOrBelow(double steps) const;

  /// mm along the third axis from a layer to the next one.
  double DistanceAbove(Index layer) const
  {
    return this->Spacing[2] * (this->StepsOf(layer + 1.0) - this->StepsOf(layer));
  }
  /// mm along the third axis, of the voxels of these layers. A voxel ends in the middle between its
  /// layer and the next.
  /// @param end The layer after the last one.
  double ThicknessOf(Index first, Index end) const
  {
    return this->HasLayers()
      ? this->Spacing[2] * (this->StepsOf(end - 0.5) - this->StepsOf(first - 0.5))
      : static_cast<double>(end - first) * this->Spacing[2];
  }
  /// The largest distance of neighboring voxels along each axis, mm.
  Vector3 MaxSpacing() const;
  /// Volume of the parallelepiped with unit edges along the axes, and area of its face across an
  /// axis; 1 unless the grid is sheared.
  double UnitVolume() const;
  double UnitArea(int axis) const;

private:
  Vector3 StepsOfVoxels(const Vector3& voxels) const
  {
    return { voxels[0], voxels[1], this->StepsOf(voxels[2]) };
  }
  Vector3 ShearedSteps(const Vector3& millimeters) const;
};

/**
 * Twice the voxel coordinates of the middle of a grid edge, of a cell's face or of a cell. They
 * have 1, 2 or 3 odd coordinates. A point keeps the labels of all voxels while it stays in the
 * octahedron
 *
 *     sum of |x - center| over the axes, in voxels  <  half the number of odd coordinates
 *
 * Proof: the octahedron of a cell contains no voxel center and is convex, and those of its edges
 * and faces lie in it; all are affine images of one of a cube. If layers have positions of their
 * own, a voxel is as thick as the cell between them. A point in a layer belongs to cells above and
 * below it: the thinner one counts, so that its octahedron lies in those of both.
 */
using GridPoint = std::array<std::int32_t, 3>;

/// Half the sides of the voxels that limit the octahedron of a point, mm along the axes.
Vector3 HalfSidesAt(const VoxelGrid& grid, const GridPoint& point);

/// Labels on the two sides of a triangle, as indices into LabelMapSource::Values. The normal points
/// from the first to the second, and the first index is less than the second. The background has
/// the largest index, so normals point out of the bone.
using BoundaryLabels = std::array<Index, 2>;

/// What is known of the label map from which a surface was extracted.
struct LabelMapSource
{
  VoxelGrid Grid;
  /// The labels of the image, ascending, and at the end the background, which may be less than they
  /// are.
  std::vector<std::int64_t> Values;
  std::vector<BoundaryLabels> OfTriangle; ///< Empty: one label.
  std::vector<GridPoint> OfPoint;         ///< For each point. Empty: not known.

  /// The index of the background.
  Index Background() const { return static_cast<Index>(this->Values.size()) - 1; }
};
}

#endif
