// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Draft.h
 * @brief Collapses that are tested cheaply while they are made, and proved together.
 *
 *     begin:        DraftFilter in place of the error bound and the intersection guard, and a
 *                   journal; limits by the separation
 *     edits
 *     Prove:        until nothing is rejected:
 *                       every face and every original is proved, with these limits      (BulkProof)
 *                       no pair of faces intersects or is too near                     (StateCheck)
 *                       closed fragments keep their volume                          (FragmentGuard)
 *                       components lie within the same others as before               (Containment)
 *                       what is rejected is undone, and all edits that depend on it
 *                   after four failures at a vertex, one more of the last edits there each time;
 *                     after too many turns, the whole draft
 *                   coverage, gaps, quadrics and volumes are those of the edits that are left
 *
 * Nothing that the draft estimates enters a proof. The mesh before the draft is proved, so undoing
 * ends. Each edit that is left passed the rules, the fragments' and voxels' filters when it was
 * made, and replaces the same faces as then (EditJournal.h). Why no parts pass each other, though
 * only the last mesh is looked at: Documentation/explanation/error-bound.md.
 */
#ifndef BoneDecimate_Core_Decimate_Edit_Draft_h
#define BoneDecimate_Core_Decimate_Edit_Draft_h

#include "Base/Monitor.h"
#include "Editor.h"
#include "Proof/EditFilters/EditJournal.h"
#include "Proof/ErrorBound/ErrorLimits.h"
#include "Proof/Guard/StateCheck.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace bonedecimate
{
class BulkProof;

class Draft
{
public:
  /// Filters of the editor are those of the draft from now on.
  Draft(Editor& editor, int threads);

  /// Proves the draft and undoes what is not proved. False if the monitor requested a stop; then
  /// all of it is undone.
  bool Prove(const Monitor& monitor);
  /// Undoes all of it.
  void Undo();

private:
  ErrorLimits InitialLimits() const;
  void ExchangeFilters();
  std::vector<std::vector<Index>> FindEnclosing(const BoundingTree* tree) const;
  std::vector<Index> FindRejectedEdits(BulkProof& proof);
  std::vector<char> FindWrongComponents() const;
  void UndoRejected(const std::vector<Index>& edits);
  void UndoWithDependents(Index edit);
  void Finish();

  Editor& MeshEditor;
  int Threads;
  bool StartsFromOriginal; // whether nothing had been edited before
  std::shared_ptr<EditJournal> Journal;
  ErrorLimits Limits; // of the bound, but below half of the separation
  // for each component, those that enclose it at first; only with a guard
  std::vector<std::vector<Index>> Enclosing;
  std::optional<StateCheck> State;    // only with a guard
  std::vector<std::uint8_t> Failures; // of each vertex, rejected edits
  std::vector<std::shared_ptr<EditFilter>> ExactFilters;
  // before the draft: its own rejections are not counted
  std::array<std::int64_t, NumberOfRejections> Rejections;
};
}

#endif
