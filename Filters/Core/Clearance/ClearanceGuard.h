// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ClearanceGuard.h
 * @brief No edit lets triangles meet that did not meet before, nor narrows a gap to less than half of what it was.
 *
 *     near    = faces of the current mesh near the new ones                                          (FaceGrid)
 *     meet:     pairs of a new face with one that is near, or of two new ones, that meet             (Piece)
 *               refused if there are more of them than of pairs with the faces that go
 *     gap:      a pair that faces each other, or of two fragments, and has no corner in common
 *               refused if it is nearer than half the gap at first at what its corners stand for     (Gaps)
 *               and nearer than the faces that go were
 *     jump:     refused if a corner of what is near lies between the faces that go and the new ones  (Piece)
 */
#ifndef BoneDecimate_Core_Clearance_ClearanceGuard_h
#define BoneDecimate_Core_Clearance_ClearanceGuard_h

#include "FaceGrid.h"
#include "Gaps.h"
#include "Guarantee/Patch.h"
#include "Piece.h"
#include "Report.h"

namespace bonedecimate
{
class ClearanceGuard
{
public:
  /// @param surface Of which the mesh was made, its sheets joined.  @param error mm, how far the surface may move.
  ClearanceGuard(const HalfEdgeMesh& mesh, const Surface& surface, double error, int threads,
    const Monitor& monitor);

  /// What one worker needs while it judges; filled by Owns or Judge for Commit.
  struct Workspace
  {
    std::vector<FaceGrid::Key> OldCells, Cells;
    std::vector<std::size_t> EndsOfOld; // in OldCells, of each face that goes
    std::vector<Index> Faces;
    std::vector<Piece> Old, New, Near;
    bool KnowsCells = false; ///< Of this edit.
  };

  /// Whether all that has to be looked at may be looked at; else a worker of another range has to judge.
  /// @param mesh Before the edit.
  bool Owns(
    const HalfEdgeMesh& mesh, const Patch& change, VertexRange range, Workspace& work) const;
  Verdict Judge(const HalfEdgeMesh& mesh, const Patch& change, Workspace& work) const;

  /// Of the edit that was judged last, before or after it is carried out.
  void Commit(const HalfEdgeMesh& mesh, const Patch& change, Workspace& work);

private:
  Piece PieceOf(const HalfEdgeMesh& mesh, const Patch& change, const Triangle& vertices,
    const TriangleCorners& corners) const;
  void FillPieces(const HalfEdgeMesh& mesh, const Patch& change, Workspace& work) const;
  void FindCells(Workspace& work) const;
  void FindNear(const HalfEdgeMesh& mesh, const Patch& change, Workspace& work) const;
  double GapOf(const Piece& a, const Piece& b) const;
  bool IsTooNear(const Piece& piece, const Piece& near, const std::vector<Piece>& old) const;
  bool NarrowsGap(const Workspace& work) const;

  FaceGrid Grid;
  Gaps Widths;
};
}

#endif
