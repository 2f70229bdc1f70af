// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Draft.h
 * @brief Collapses that are tested cheaply while they are made, and proved together: what an Editor keeps for them.
 *
 *     BeginDraft:   DraftFilter in place of the error bound and the intersection guard, and a journal
 *     edits
 *     EndDraft:     until nothing is rejected:
 *                       every face and every original is proved                        (BulkProof)
 *                       every edit is checked against what was near it then, and gaps  (IntersectionGuard::FindRejected)
 *                       closed fragments keep their volume                             (FragmentGuard)
 *                       what is rejected is undone, and all edits that depend on it
 *                   the more turns, the more is undone around what is rejected; after too many of them, the whole draft
 *                   coverage, gaps, quadrics and volumes are those of the edits that are left
 *
 * Nothing that the draft estimates enters a proof. The mesh before the draft is proved, so undoing ends. Afterwards the state is one that
 * edit by edit could have led to as well: each edit that is left passed the rules, the fragments' and voxels' filters when it
 * was made, and replaces the same faces as then (EditJournal.h).
 */
#ifndef BoneDecimate_Core_Edit_Draft_h
#define BoneDecimate_Core_Edit_Draft_h

#include "EditFilters/EditJournal.h"
#include "Intersections/EditReplay.h"
#include "Mesh/Rejection.h"

#include <array>
#include <memory>
#include <vector>

namespace bonedecimate
{
struct Draft
{
  explicit Draft(const HalfEdgeMesh& mesh)
    : Journal(std::make_shared<EditJournal>(mesh))
    , Replay(mesh, *this->Journal)
  {
  }

  std::shared_ptr<EditJournal> Journal;
  EditReplay Replay;
  std::vector<Index> CheckedFaces; ///< IntersectionGuard::FindRejected.
  std::vector<std::shared_ptr<EditFilter>>
    ExactFilters; ///< Of the editor, while the draft has its own.
  std::array<std::int64_t, NumberOfRejections>
    Rejections{}; ///< Before the draft: its own are not counted.
};
}

#endif
