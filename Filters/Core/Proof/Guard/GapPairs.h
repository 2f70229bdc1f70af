// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GapPairs.h
 * @brief Pairs of faces that face each other or belong to two fragments, and are nearer than half
 * the initial gap at their corners.
 */
#ifndef BoneDecimate_Core_Proof_Guard_GapPairs_h
#define BoneDecimate_Core_Proof_Guard_GapPairs_h

#include "PairFace.h"
#include "Proof/EditFilters/EditJournal.h"

#include <vector>

namespace bonedecimate
{
/// mm, distance from a face within which its gaps have to be checked.
double ReachOf(const Gap& gap);

/// Whether a pair is nearer than its initial gap allows, and nearer than the old faces were to
/// `near`.
bool IsTooNear(const GapRule& widths, const PairFace& face, const PairFace& near,
  const std::vector<PairFace>& old);

/// Gives each merged vertex the smaller widths of both, by the edits of a journal.
void MergeGaps(const EditJournal& journal, const HalfEdgeMesh& mesh, GapRule& widths);
}

#endif
