// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StateCheck.h
 * @brief Checks a mesh that the edits of a journal have left: which edits to undo so that no pair
 * of faces is bad.
 *
 *     a pair is bad if an edit has changed one of both, and
 *         they intersect, or
 *         they are too near to each other (GapPairs.h), unless the pair goes back to one that was
 *           as near
 *     undo:  the later edit of both
 *
 * After the first call only faces that have changed since the last one are looked at, and what is
 * near them: nothing else has changed pairs. It does not see whether parts have passed each other:
 * Separation.h.
 */
#ifndef BoneDecimate_Core_Proof_Guard_StateCheck_h
#define BoneDecimate_Core_Proof_Guard_StateCheck_h

#include "BoxTree.h"
#include "Piece.h"
#include "Proof/EditFilters/EditJournal.h"

#include <optional>
#include <vector>

namespace bonedecimate
{
class StateCheck
{
public:
  /// All arguments must outlive this object.
  /// @param widths Gap widths at the vertices of the mesh before the first edit.
  StateCheck(const HalfEdgeMesh& mesh, const GapRule& widths, const WrittenPositions& written,
    const EditJournal& journal);

  std::vector<Index> FindRejected(int threads);

private:
  std::vector<FaceId> TakeChanged(int threads);
  void Look(FaceId face, std::vector<Index>& edits) const;
  bool IsBad(FaceId face, Piece& piece, FaceId other, Piece& near) const;
  bool WasAsNear(const FaceVersion& one, const FaceVersion& other, int& left) const;
  Piece PieceOf(FaceId face) const;
  Piece PieceOf(const FaceVersion& face) const;
  FaceVersion VersionOf(FaceId face) const
  {
    return this->Journal.LastVersion(face, this->Mesh.Corners(face));
  }

  const HalfEdgeMesh& Mesh;
  const GapRule& WidthsAtFirst;
  const WrittenPositions& Written;
  const EditJournal& Journal;
  GapRule Widths;            // of the mesh as it is
  std::vector<Index> Looked; // of each face, its last edit when it was looked at
  std::optional<BoxTree> Tree;
};
}

#endif
