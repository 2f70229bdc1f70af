// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceHistory.h
 * @brief The faces that there were between two edits of a journal, found by box and time; from the last edits to the first.
 *
 *     window:   some edits that follow each other; its versions are the faces after its last edit and those that its edits replaced
 *     GoBack:   the window before, as large as the memory allows
 *
 * So the mesh need not be made again to know what was near an edit, and the edits of a window are looked at in parallel. Edits that were
 * undone never happened. Versions are sorted by size and then by face, because faces lie along a curve that fills space, and
 * versions of very different sizes would spoil each other's boxes.
 */
#ifndef BoneDecimate_Core_Intersections_FaceHistory_h
#define BoneDecimate_Core_Intersections_FaceHistory_h

#include "EditFilters/EditJournal.h"
#include "SpaceTimeTree.h"

#include <optional>
#include <vector>

namespace bonedecimate
{
class FaceHistory
{
public:
  /// The window after the last edit.
  /// @param mesh After the edits of the journal that are not undone. Both must outlive this object and not change.
  FaceHistory(const HalfEdgeMesh& mesh, const EditJournal& journal, int threads);

  /// The window before. Without versions that no box of the region meets while both exist, if it is given.
  /// @param mostVersions In the window, before some are left out; one edit is in it at least.
  void GoBack(Index mostVersions, const SpaceTimeTree* region = nullptr);

  /// The edits of the window: from the first to the one before the end.
  Index FirstEdit() const { return this->First; }
  Index EndOfEdits() const { return this->End; }

  /// Calls visit(version) for each face that meets the box, was there before the edit and is not replaced by it.
  /// @param edit Of the window, or the end: after its last one.
  template <typename Visit>
  void VisitAt(const FloatBox& box, Index edit, const Visit& visit) const
  {
    this->Tree->VisitAt(
      box, edit, [&](std::size_t position) { visit(this->Version(this->Ids[position])); });
  }

  /// A face and when it was there.
  struct Candidate
  {
    TimedBox Box;
    Index Version; ///< For VisitAmong.
  };
  /// Finds at once what VisitAt would for several edits near each other: all that meet the box and were there before an edit of the
  /// window from the first to the last.
  void Find(const FloatBox& box, Index first, Index last, std::vector<Candidate>& found) const;
  /// What VisitAt does, among those that were found.
  template <typename Visit>
  void VisitAmong(
    const std::vector<Candidate>& found, const FloatBox& box, Index edit, const Visit& visit) const
  {
    const TimedBox before = { box, edit, edit };
    for (const Candidate& candidate : found)
    {
      if (candidate.Box.MeetsWhile(before))
      {
        visit(this->Version(candidate.Version));
      }
    }
  }
  /// Before the first edit of the window.
  Index NumberOfFaces() const { return this->Alive; }

private:
  /// A version of the journal, or ToId of a face as it is now.
  using Id = Index;
  struct Timed
  {
    Id Version;
    Index Replaced; // by this edit
  };
  static Id ToId(FaceId face) { return None - 1 - face; }
  FaceVersion Version(Id id) const;
  std::vector<Timed> FindVersions();
  TimedBox BoxOf(const Timed& version) const;
  void KeepNear(const SpaceTimeTree& region, std::vector<Timed>& versions) const;
  void SortBySize(std::vector<Timed>& versions) const;
  void Build(std::vector<Timed> versions);

  const HalfEdgeMesh& Mesh;
  const EditJournal& Journal;
  int Threads;
  Index First, End;        // of the edits
  Index Alive = 0;         // faces before the first edit of the window
  std::vector<Id> AtFirst; // of each face, before the first edit of the window; None: removed
  std::vector<Id> Ids;     // of the versions in the tree
  std::optional<SpaceTimeTree> Tree; // of their boxes
};
}

#endif
