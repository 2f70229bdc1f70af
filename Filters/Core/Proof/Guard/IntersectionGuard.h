// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file IntersectionGuard.h
 * @brief No edit lets triangles meet that did not meet before, nor narrows a gap to less than half
 * of what it was.
 *
 *     near    = faces of the current mesh near the new ones                              (FaceGrid)
 *     meet:     pairs of a new face with one that is near, or of two new ones, that meet    (Piece)
 *               rejected if there are more of them than of pairs with the faces that go
 *     gap:      a pair that faces each other, or of two fragments, and has no corner in common
 *               rejected if it is nearer than half the initial gap at its corners         (GapRule)
 *               and nearer than the faces that go were
 *     jump:     rejected if a corner of what is left lies between the faces that go and the new
 *               ones                                                                      (Piece)
 *
 * The edits of a draft are checked together, in the mesh that is left (StateCheck.h).
 */
#ifndef BoneDecimate_Core_Proof_Guard_IntersectionGuard_h
#define BoneDecimate_Core_Proof_Guard_IntersectionGuard_h

#include "FaceGrid.h"
#include "GapRule.h"
#include "Piece.h"
#include "Proof/EditFilters/EditJournal.h"
#include "StateCheck.h"

#include <memory>
#include <mutex>
#include <vector>

namespace bonedecimate
{
class IntersectionGuard : public EditFilter
{
public:
  /// @param mesh Must outlive this object; its faces are sorted into the grid before the first
  ///   edit.
  /// @param surface The surface from which the mesh was made, its manifold patches joined.
  /// @param error mm, how far the surface may move.
  /// @param written Whether triangles meet is decided where they will be written.
  /// @param guardsGaps Whether gaps are measured; otherwise only intersections are rejected.
  IntersectionGuard(const HalfEdgeMesh& mesh, const Surface& surface,
    const WrittenPositions& written, double error, bool guardsGaps, int threads,
    const Monitor& monitor);

  std::shared_ptr<EditFilter::Pending> MakePending() override;
  bool NeedsSurfaceChange() const override { return true; }
  /// Defers an edit near cells of the grid that belong to another worker.
  Decision Screen(const HalfEdgeMesh& mesh, const SurfaceChange& change,
    EditFilter::Pending& pending) const override;
  Decision Check(const HalfEdgeMesh& mesh, const SurfaceChange& change,
    EditFilter::Pending& pending) const override;
  double Reach(const EditFilter::Pending& pending) const override;
  /// Whether no gap that the check read has changed.
  bool StillAccepts(const HalfEdgeMesh& mesh, const SurfaceChange& change,
    EditFilter::Pending& pending) const override;
  void Adopt(VertexId made, VertexId like) override;
  void Commit(const HalfEdgeMesh& mesh, const SurfaceChange& change, EditFilter::Pending& pending,
    Tally& tally) override;

  /// The check of a draft, made before its first edit. Guard and journal must outlive the check.
  StateCheck CheckOf(const EditJournal& journal) const
  {
    return { this->Mesh, this->Widths, this->Written, journal };
  }
  /// Continues with the mesh that the edits of the draft left.
  void TakeDraft(const EditJournal& journal);

private:
  struct Pending : public EditFilter::Pending
  {
    std::vector<FaceGrid::Key> OldCells, Cells;
    std::vector<std::size_t> EndsOfOld; // in OldCells, of each removed face
    std::vector<Index> Faces;
    std::vector<Piece> Old, New, Near, Swept;
    double Reach = 0.0;      // mm, of the gap rule around these
    bool KnowsCells = false; // of this edit
  };
  void BuildGrid();
  Gap MinGapOf(
    const HalfEdgeMesh& mesh, const SurfaceChange& change, const Triangle& originals) const;
  Piece PieceOf(const HalfEdgeMesh& mesh, const SurfaceChange& change, const Triangle& vertices,
    const TriangleCorners& corners) const;
  void FillPieces(const HalfEdgeMesh& mesh, const SurfaceChange& change, Pending& work) const;
  void FindCells(Pending& work) const;
  void FindNear(const HalfEdgeMesh& mesh, const SurfaceChange& change, Pending& work) const;
  void FindSwept(const HalfEdgeMesh& mesh, const SurfaceChange& change, Pending& work) const;
  void AddCellsOfCone(
    const TriangleCorners& base, const Vector3& apex, std::vector<FaceGrid::Key>& cells) const;
  bool NarrowsGap(const Pending& work) const;

  const HalfEdgeMesh& Mesh;
  WrittenPositions Written;
  double MinCell; // mm, of the grid
  std::unique_ptr<FaceGrid> Grid;
  std::mutex Building; // of the grid
  GapRule Widths;
};
}

#endif
