// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StateCheck.h
 * @brief Checks a mesh that the edits of a journal have left: which edits to undo so that no pair
 * of faces is bad.
 *
 *     a pair is bad if an edit has changed one of both, and
 *         they intersect, or
 *         they are too near to each other (GapPairs.h), unless the pair goes back to one
 *           that was as near
 *     undo:  the later edit of both
 *
 * After the first call, only faces that have changed since the last one and faces near them are
 * checked: no other pair has changed. This does not find parts that have passed each other:
 * Separation.h.
 */
#ifndef BoneDecimate_Core_Proof_Guard_StateCheck_h
#define BoneDecimate_Core_Proof_Guard_StateCheck_h

#include "BoxTree.h"
#include "PairFace.h"
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

  std::vector<Index> FindEditsToUndo(int threads);

private:
  std::vector<FaceId> TakeChanged(int threads);
  void FindBadPairs(FaceId face, std::vector<Index>& edits) const;
  bool IsBad(FaceId face, PairFace& piece, FaceId other, PairFace& near) const;
  bool WasAsNear(const FaceVersion& one, const FaceVersion& other, int& stepsLeft) const;
  PairFace PairFaceOf(FaceId face) const;
  PairFace PairFaceOf(const FaceVersion& face) const;
  FaceVersion VersionOf(FaceId face) const
  {
    return this->Journal.LastVersion(face, this->Mesh.Corners(face));
  }

  const HalfEdgeMesh& Mesh;
  const GapRule& InitialWidths;
  const WrittenPositions& Written;
  const EditJournal& Journal;
  GapRule Widths;                  // of the current mesh
  std::vector<Index> CheckedEdits; // of each face, its last edit when it was checked
  std::optional<BoxTree> Tree;
};
}

#endif
