// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GapPairs.h
 * @brief Pairs of faces that face each other, or belong to two fragments, and are nearer than half
 * the initial gap at their corners.
 */
#ifndef BoneDecimate_Core_Proof_Guard_GapPairs_h
#define BoneDecimate_Core_Proof_Guard_GapPairs_h

#include "Piece.h"
#include "Proof/EditFilters/EditJournal.h"

#include <vector>

namespace bonedecimate
{
/// mm, how far from a face its gaps have to be looked after.
double ReachOf(const Gap& gap);

/// Nearer than the initial gap allows, and nearer than the faces that the piece replaces.
bool IsTooNear(
  const GapRule& widths, const Piece& piece, const Piece& near, const std::vector<Piece>& old);

/// A merged vertex represents both.
void MergeGaps(const EditJournal& journal, const HalfEdgeMesh& mesh, GapRule& widths);
}

#endif
