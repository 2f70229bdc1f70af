// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VoxelRows.h
 * @brief Voxelizes a surface with labels on both sides, row by row along the first axis of the
 * grid.
 *
 *     points in steps of the grid
 *     for each slice:    the triangles that its plane may meet
 *         for each row:  the triangles that it crosses, exactly (winding number of their
 *                        projections), and between which voxels of the row each crossing
 *                        replaces one label by the other
 *
 * A row on an edge or through a point counts as displaced by (e, e^2) along the other axes, and a
 * voxel center on a triangle as above it, so that all triangles agree.
 */
#ifndef BoneDecimate_Core_Labels_LabelMap_VoxelRows_h
#define BoneDecimate_Core_Labels_LabelMap_VoxelRows_h

#include "Geometry/Surface.h"
#include "VoxelGrid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace bonedecimate
{
struct LabeledSurface
{
  const bonedecimate::Surface& Surface;
  /// Labels of each triangle; empty: 0 inside, 1 outside.
  const std::vector<BoundaryLabels>& Labels;
};

/// Voxel indices from First, Count along each axis.
struct VoxelBox
{
  std::array<std::int64_t, 3> First = { 0, 0, 0 };
  std::array<std::int64_t, 3> Count = { 0, 0, 0 };
};

/// A voxel with no label or several, because the surface intersects itself or is open.
constexpr Index Ambiguous = -2;

class VoxelRows
{
public:
  VoxelRows(const LabeledSurface& surface, const VoxelGrid& grid, Index background, int threads);

  /// All voxels that the box of the surface touches.
  VoxelBox Bounds() const;

  /// The rows of a slice of the box. One for each worker.
  class Slice
  {
  public:
    Slice(const VoxelRows& rows, const VoxelBox& box);

    /// @param z Index in the box.
    void Begin(std::int64_t z);
    /// The labels along the row at y (index in the box). None if no triangle is crossed, or if the
    /// crossings cancel and isOpen.
    /// @param isOpen The row begins with the label before the first crossing, otherwise with the
    ///   background.
    void Row(std::int64_t y, bool isOpen, std::vector<Index>& labels);

  private:
    struct Crossing
    {
      std::int64_t Row;
      std::int64_t Above;          // the first voxel above, index in the box
      std::array<Index, 2> Labels; // before and after
    };
    struct Count
    {
      Index Label;
      int Number;
    };
    void Cross(Index triangle, std::int64_t z);
    void Add(Index label, int number);
    Index Current() const;

    const VoxelRows& Rows;
    VoxelBox Box;
    std::vector<Crossing> Crossings; // of the slice, by row
    std::size_t Next = 0;
    std::vector<Count> Counts; // of the labels at one voxel
  };

private:
  friend class Slice;

  std::array<std::int64_t, 2> SlicesOf(const Triangle& triangle) const;
  void SortIntoSlices();

  const std::vector<Triangle>& Triangles;
  const std::vector<BoundaryLabels>& Labels;
  Index Background;
  bool IsMirrored; // left-handed grid: in voxels, normals point to the first label
  VoxelGrid Grid;
  std::vector<Vector3> Points; // steps
  std::array<std::int64_t, 3> Low{};
  std::array<std::int64_t, 3> High{};
  std::vector<std::size_t> Starts; // of each slice from Low, in InSlice
  std::vector<Index> InSlice;      // triangles
};

/// Whether an edge belongs to only one triangle. Points of equal coordinates are one.
bool HasBoundary(const Surface& surface);
}

#endif
