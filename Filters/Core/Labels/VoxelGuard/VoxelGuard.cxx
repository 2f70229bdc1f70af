// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelGuard.h"

#include "Mesh/SurfaceAssembly.h"
#include "VoxelPatch.h"

#include <algorithm>
#include <utility>

namespace bonedecimate
{
namespace
{
/// Error bound from which edits are large, in voxels.
constexpr double ErrorOfLargeEdits = 0.4;

/// Sum of the boundary edges between two vertices for one label.
struct EdgeSum
{
  Index From;
  Index To;
  Index Label;
  int Total;
};

void AddEdge(std::vector<EdgeSum>& sums, Index from, Index to, Index label, int count)
{
  const bool isTurned = from > to;
  const EdgeSum edge = { std::min(from, to), std::max(from, to), label, isTurned ? -count : count };
  for (EdgeSum& sum : sums)
  {
    if (sum.From == edge.From && sum.To == edge.To && sum.Label == edge.Label)
    {
      sum.Total += edge.Total;
      return;
    }
  }
  sums.push_back(edge);
}
}

/// Keeps its memory from edit to edit.
struct VoxelGuard::Pending : public EditFilter::Pending
{
  explicit Pending(const CenterLattice& lattice)
    : Patch(lattice)
  {
  }
  VoxelPatch Patch;
};

VoxelGuard::VoxelGuard(VoxelGuardSettings settings)
  : Settings(std::move(settings))
  , Frame(this->Settings.Grid)
  , Lattice(this->Settings.Grid)
{
}

//------------------------------------------------------------------------------
bool VoxelGuard::ChecksBeforeBound(const VoxelGrid& grid, double error)
{
  return error >= ErrorOfLargeEdits * grid.Spacing.minCoeff();
}

//------------------------------------------------------------------------------
std::shared_ptr<EditFilter::Pending> VoxelGuard::MakePending()
{
  return std::make_shared<Pending>(this->Lattice);
}

//------------------------------------------------------------------------------
const BoundaryLabels& VoxelGuard::LabelsOf(Index face) const
{
  static const BoundaryLabels single = { 0, 1 };
  const std::vector<BoundaryLabels>& all = this->Settings.OfFace;
  return all.empty() ? single : all[static_cast<std::size_t>(face)];
}

//------------------------------------------------------------------------------
FixedPoint VoxelGuard::Convert(const Vector3& position) const
{
  const Vector3 absolute = position + this->Settings.Origin;
  return this->Frame.Convert(this->Settings.Rounding.Of(absolute));
}

FixedTriangle VoxelGuard::Convert(const std::array<Vector3, 3>& corners) const
{
  return { this->Convert(corners[0]), this->Convert(corners[1]), this->Convert(corners[2]) };
}

//------------------------------------------------------------------------------
/// Whether the boundary of the surface changes. Where manifold patches meet, their edges cancel
/// label by label.
bool VoxelGuard::IsOpen(const HalfEdgeMesh& mesh, const SurfaceChange& change) const
{
  if (change.BoundaryStays || change.OldBoundary.empty())
  {
    return false;
  }
  std::vector<EdgeSum> sums;
  for (const Index h : change.OldBoundary)
  {
    const Index from = mesh.OriginalVertex(mesh.Origin(h));
    const Index to = mesh.OriginalVertex(mesh.Target(h));
    const BoundaryLabels& labels = this->LabelsOf(mesh.InputFace(HalfEdgeMesh::Face(h)));
    AddEdge(sums, from, to, labels[0], 1);
    AddEdge(sums, from, to, labels[1], -1);
  }
  return std::any_of(sums.begin(), sums.end(), [](const EdgeSum& sum) { return sum.Total != 0; });
}

//------------------------------------------------------------------------------
/// @pre KeepsLabels: the patch is not large.
bool VoxelGuard::KeepsRim(
  const HalfEdgeMesh& mesh, const SurfaceChange& change, VoxelPatch& patch) const
{
  const double margin = this->Settings.Margin;
  for (const Index h : change.OldBoundary)
  {
    patch.AddOldRim(this->Convert(mesh.Position(mesh.Origin(h))),
      this->Convert(mesh.Position(mesh.Target(h))), margin);
  }
  for (const SurfaceChange::BoundaryEdge& edge : change.NewBoundary)
  {
    patch.AddNewRim(this->Convert(edge.Ends[0]), this->Convert(edge.Ends[1]), margin);
  }
  return !patch.IsRimNearOtherEdges();
}

//------------------------------------------------------------------------------
Decision VoxelGuard::Check(
  const HalfEdgeMesh& mesh, const SurfaceChange& change, EditFilter::Pending& pending) const
{
  VoxelPatch& patch = static_cast<Pending&>(pending).Patch;
  patch.Clear();
  for (const Index face : change.OldFaces)
  {
    const Triangle c = mesh.Corners(face);
    patch.AddOld(this->Convert({ mesh.Position(c[0]), mesh.Position(c[1]), mesh.Position(c[2]) }),
      this->LabelsOf(mesh.InputFace(face)));
  }
  for (const SurfaceChange::Face& face : change.NewFaces)
  {
    patch.AddNew(this->Convert(face.Corners), this->LabelsOf(mesh.InputFace(face.Old())));
  }
  const bool isOpen = this->IsOpen(mesh, change);
  const bool keeps = patch.KeepsLabels(isOpen) && !patch.IsNearCenter(this->Settings.Margin) &&
    (!isOpen || this->KeepsRim(mesh, change, patch));
  return keeps ? Rejection::NotRejected : Rejection::VoxelLabel;
}
}
