// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VoxelPatch.h
 * @brief Two patches of triangles with the same rim: whether a voxel center lies between them.
 *
 * The old patch and the reversed new one form a closed surface. Along one axis, on every edge
 * between two voxel centers, the signed crossings of the old triangles must equal those of the new
 * ones; then no winding number differs. With several labels this holds for each label: a triangle
 * counts +1 for the first of its labels and -1 for the second.
 *
 * If the rims differ, the surface is open there. Then all three axes are checked, with the
 * displacements of ColumnCrossing.h into all octants, since a boundary may lie in a plane of voxel
 * centers. The new rim must not come near an edge between voxel centers that the old one is not
 * near (RimLines.h).
 */
#ifndef BoneDecimate_Core_Labels_VoxelGuard_VoxelPatch_h
#define BoneDecimate_Core_Labels_VoxelGuard_VoxelPatch_h

#include "ColumnCrossing.h"
#include "RimLines.h"

#include <cstdint>
#include <vector>

namespace bonedecimate
{
class VoxelPatch
{
public:
  /// Voxel centers at every step, or on a lattice.
  explicit VoxelPatch(const CenterLattice& lattice = {})
    : Lattice(lattice)
    , Mirrored(lattice.Mirrored())
  {
  }

  void Clear();
  void AddOld(const FixedTriangle& corners, const BoundaryLabels& labels);
  void AddNew(const FixedTriangle& corners, const BoundaryLabels& labels);

  void AddOldRim(const FixedPoint& from, const FixedPoint& to, double margin);
  void AddNewRim(const FixedPoint& from, const FixedPoint& to, double margin);

  /// Whether every voxel center keeps its labels. Also false if the patches are larger than
  /// MaxPatch.
  bool KeepsLabels(bool isOpen);

  /// Whether a new triangle is nearer to a voxel center than the margin.
  /// @param margin Voxels, less than 0.1.
  bool IsNearCenter(double margin) const;

  /// Whether the new rim is nearer than its margin to an edge of the grid that the old one is not
  /// near.
  bool IsRimNearOtherEdges() const;

private:
  struct Face
  {
    FixedTriangle Corners;
    FixedBox Box;
    BoundaryLabels Labels;
    int Sign; ///< 1: old, -1: new.
  };
  /// Sum of the crossings of a label above a voxel center.
  struct Sum
  {
    std::int64_t Below;
    Index Label;
    int Total;
  };
  void Add(const FixedTriangle& corners, const BoundaryLabels& labels, int count);
  FixedBox Box() const;
  bool KeepsAlong(std::size_t axis, const FixedBox& box);
  bool KeepsColumn(const Column& column);
  void AddCrossing(std::int64_t below, Index label, int count);
  void Mirror(std::size_t axis);
  const CenterLattice& Centers() const { return this->IsMirrored ? this->Mirrored : this->Lattice; }

  CenterLattice Lattice;
  CenterLattice Mirrored;
  bool IsMirrored = false; // along the third axis
  std::vector<Face> Faces;
  std::vector<Sum> Sums; // of one column
  std::vector<GridEdge> NearOldRim;
  std::vector<GridEdge> NearNewRim;
  bool HasSeveralLabels = false;
};
}

#endif
