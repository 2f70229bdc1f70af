// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EditReplay.h
 * @brief Checks each edit of a journal against the faces that were near when it was made: two rules of IntersectionGuard.
 *
 *     near:   faces of the mesh just before the edit whose boxes meet that of its old and new faces     (FaceHistory)
 *     meet:   more pairs of the new faces intersect than of the old ones                                (Piece)
 *     jump:   a corner of what is near lies between the old and the new faces                           (Piece)
 *
 * So what is left of a journal is a sequence of edits that the guard would have accepted one after the other. Checking only
 * the last mesh would miss parts that have passed each other.
 */
#ifndef BoneDecimate_Core_Intersections_EditReplay_h
#define BoneDecimate_Core_Intersections_EditReplay_h

#include "FaceHistory.h"
#include "Piece.h"

#include <array>
#include <optional>
#include <vector>

namespace bonedecimate
{
class EditReplay
{
public:
  /// Both must outlive this object.
  EditReplay(const HalfEdgeMesh& mesh, const EditJournal& journal)
    : Mesh(mesh)
    , Journal(journal)
  {
  }

  /// In ascending order; edits that are undone are left out. After the first call only edits near those that were undone
  /// since, and later than these, are checked again: nothing else has changed what they find.
  std::vector<Index> FindRejected(const WrittenPositions& written, int threads);

private:
  static constexpr std::size_t MostTogether = 8;
  struct Patch
  {
    Index Edit;
    std::vector<Piece> Old, New;
  };
  struct Workspace
  {
    std::array<Patch, MostTogether> Patches;
    std::vector<FaceHistory::Candidate> Found;
    std::vector<Piece> Near;
  };
  SpaceTimeTree TakeUndone();
  Index ChooseEdits(const SpaceTimeTree& undone, int threads);
  std::optional<SpaceTimeTree> BoxesToCheck(Index chosen) const;
  void CheckWindow(const FaceHistory& history, const WrittenPositions& written, int threads);
  std::vector<Index> EditsToCheck(const FaceHistory& history) const;
  void CheckTogether(const FaceHistory& history, std::size_t count, const WrittenPositions& written,
    Workspace& work);
  void FillPatch(Index edit, Patch& patch) const;

  const HalfEdgeMesh& Mesh;
  const EditJournal& Journal;
  enum class State : char
  {
    Unchecked,
    Accepted,
    Rejected,
    Undone
  };
  std::vector<FloatBox> Boxes; // of each edit that was checked, around its old and new faces
  std::vector<State> States;   // of each edit, when they were checked last
};
}

#endif
