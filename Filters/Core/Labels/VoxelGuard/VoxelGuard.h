// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VoxelGuard.h
 * @brief Rejects edits that move a voxel center to another side: voxelized again, every voxel has
 * its original label.
 *
 *     Check(edit):   positions as they will be written, in voxels                 (FixedPoint.h)
 *                    no voxel center lies between the old and the new triangles
 *                                                                       (VoxelPatch.h, exact)
 *                    none is nearer to a new triangle than the margin, nor an edge of the grid
 *                      to the rim of an open surface
 *
 * The margin exceeds the rounding of programs that voxelize the result. Triangles that are never
 * changed may be nearer. Edits larger than MaxPatch (1024 voxels) are rejected. Only the edit
 * itself is read, so no edit is deferred and nothing has to be committed.
 */
#ifndef BoneDecimate_Core_Labels_VoxelGuard_VoxelGuard_h
#define BoneDecimate_Core_Labels_VoxelGuard_VoxelGuard_h

#include "CenterLattice.h"
#include "Labels/LabelMap/VoxelGrid.h"
#include "Mesh/PointRounding.h"
#include "Proof/EditFilters/EditFilter.h"

#include <vector>

namespace bonedecimate
{
class VoxelPatch;

struct VoxelGuardSettings
{
  VoxelGrid Grid;
  /// Labels of each face of the initial mesh; empty: all have the same.
  std::vector<BoundaryLabels> OfFace = {};
  PointRounding Rounding = {};      ///< Rounding of the written positions,
  Vector3 Origin = Vector3::Zero(); ///< mm, relative to this position.
  double Margin = 1e-3;             ///< Voxels, less than 0.1.
};

class VoxelGuard : public EditFilter
{
public:
  explicit VoxelGuard(VoxelGuardSettings settings);

  std::shared_ptr<EditFilter::Pending> MakePending() override;
  bool NeedsSurfaceChange() const override { return true; }
  Decision Check(const HalfEdgeMesh& mesh, const SurfaceChange& change,
    EditFilter::Pending& pending) const override;

  /// Whether a check before the error bound saves time. Not for small edits, which rarely move a
  /// voxel center to another side.
  /// @param error mm, of the bound.
  static bool ChecksBeforeBound(const VoxelGrid& grid, double error);

private:
  struct Pending;
  const BoundaryLabels& LabelsOf(Index face) const;
  FixedPoint Convert(const Vector3& position) const;
  FixedTriangle Convert(const std::array<Vector3, 3>& corners) const;
  bool IsOpen(const HalfEdgeMesh& mesh, const SurfaceChange& change) const;
  bool KeepsRim(const HalfEdgeMesh& mesh, const SurfaceChange& change, VoxelPatch& patch) const;

  VoxelGuardSettings Settings;
  FixedPointFrame Frame;
  CenterLattice Lattice;
};
}

#endif
