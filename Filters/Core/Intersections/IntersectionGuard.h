// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file IntersectionGuard.h
 * @brief No edit lets triangles meet that did not meet before, nor narrows a gap to less than half of what it was.
 *
 *     near    = faces of the current mesh near the new ones                                          (FaceGrid)
 *     meet:     pairs of a new face with one that is near, or of two new ones, that meet             (Piece)
 *               rejected if there are more of them than of pairs with the faces that go
 *     gap:      a pair that faces each other, or of two fragments, and has no corner in common
 *               rejected if it is nearer than half the initial gap at its corners                     (GapRule)
 *               and nearer than the faces that go were
 *     jump:     rejected if a corner of what is near lies between the faces that go and the new ones  (Piece)
 */
#ifndef BoneDecimate_Core_Intersections_IntersectionGuard_h
#define BoneDecimate_Core_Intersections_IntersectionGuard_h

#include "EditFilters/EditFilter.h"
#include "FaceGrid.h"
#include "GapRule.h"
#include "Piece.h"

namespace bonedecimate
{
class IntersectionGuard : public EditFilter
{
public:
  /// @param surface Of which the mesh was made, its manifold patches joined.  @param error mm, how far the surface may move.
  IntersectionGuard(const HalfEdgeMesh& mesh, const Surface& surface, double error, int threads,
    const Monitor& monitor);

  std::shared_ptr<EditFilter::Pending> MakePending() override;
  bool NeedsSurfaceChange() const override { return true; }
  /// Defers an edit near cells of the grid that belong to another worker.
  Decision Screen(const HalfEdgeMesh& mesh, const ProposedEdit& edit,
    EditFilter::Pending& pending) const override;
  Decision Check(const HalfEdgeMesh& mesh, const ProposedEdit& edit,
    EditFilter::Pending& pending) const override;
  void Commit(const HalfEdgeMesh& mesh, const ProposedEdit& edit, EditFilter::Pending& pending,
    Tally& tally) override;

private:
  struct Pending : public EditFilter::Pending
  {
    std::vector<FaceGrid::Key> OldCells, Cells;
    std::vector<std::size_t> EndsOfOld; // in OldCells, of each removed face
    std::vector<Index> Faces;
    std::vector<Piece> Old, New, Near;
    bool KnowsCells = false; // of this edit
  };
  bool Owns(
    const HalfEdgeMesh& mesh, const SurfaceChange& change, VertexRange range, Pending& work) const;
  Piece PieceOf(const HalfEdgeMesh& mesh, const SurfaceChange& change, const Triangle& vertices,
    const TriangleCorners& corners) const;
  void FillPieces(const HalfEdgeMesh& mesh, const SurfaceChange& change, Pending& work) const;
  void FindCells(Pending& work) const;
  void FindNear(const HalfEdgeMesh& mesh, const SurfaceChange& change, Pending& work) const;
  double GapOf(const Piece& a, const Piece& b) const;
  bool IsTooNear(const Piece& piece, const Piece& near, const std::vector<Piece>& old) const;
  bool NarrowsGap(const Pending& work) const;

  FaceGrid Grid;
  GapRule Widths;
};
}

#endif
