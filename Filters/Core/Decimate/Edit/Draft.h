// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Draft.h
 * @brief Collapses that are checked cheaply when they are made, and proved together afterwards.
 *
 *     begin:   replace error bound and intersection guard by DraftFilter and a journal, with
 *              limits below half of the separation of parts
 *     edits
 *     Prove, until nothing is rejected:
 *         every face and every original is proved within these limits        (BulkProof)
 *         no pair of faces intersects or is too near                         (StateCheck)
 *         closed fragments keep their volume                                 (FragmentGuard)
 *         components lie within the same others as before                    (Containment)
 *         undo what is rejected, and all edits that depend on it
 *             after four failures at a vertex, one more of the last edits there each time
 *             after too many turns, the whole draft
 *     end:     coverage, gaps, quadrics and volumes are set to those of the remaining edits
 *
 * No estimate of the draft enters a proof. The mesh before the draft is proved, so undoing ends.
 * Each remaining edit passed the rules and the filters of fragments and voxels when it was made,
 * and still replaces the same faces (EditJournal.h). Documentation/explanation/error-bound.md
 * explains why no parts pass through each other, although only the last mesh is checked.
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
  Draft(Editor& editor, int threads);

  /// Replaces the filters of the editor by those of the draft. False if the monitor requests a
  /// stop; then they are as before.
  bool Begin(const Monitor& monitor);
  /// Proves the draft and undoes what is not proved. False if the monitor requests a stop; then the
  /// whole draft is undone.
  bool Prove(const Monitor& monitor);
  /// Undoes the whole draft.
  void Undo();

private:
  bool ReduceLimits(const Monitor& monitor);
  bool NoteState(const Monitor& monitor);
  bool ExchangeFilters(const Monitor& monitor);
  std::vector<std::vector<Index>> FindEnclosing(const BoundingTree* tree) const;
  std::optional<std::vector<Index>> FindRejectedEdits(BulkProof& proof, const Monitor& monitor);
  std::vector<char> FindWrongComponents() const;
  void UndoRejected(const std::vector<Index>& edits);
  void UndoWithDependents(Index edit);
  void Finish();

  Editor& MeshEditor;
  int Threads;
  bool StartsFromOriginal; // whether the mesh was unedited before
  std::shared_ptr<EditJournal> Journal;
  ErrorLimits Limits; // those of the bound, below half of the separation
  // for each component, those that enclosed it before the draft; only with a guard
  std::vector<std::vector<Index>> Enclosing;
  std::optional<StateCheck> State;    // only with a guard
  std::vector<std::uint8_t> Failures; // number of rejected edits of each vertex
  std::vector<std::shared_ptr<EditFilter>> ExactFilters;
  // those before the draft, which does not count its own
  std::array<std::int64_t, NumberOfRejections> Rejections;
};
}

#endif
