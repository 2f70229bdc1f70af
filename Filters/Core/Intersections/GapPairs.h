// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GapPairs.h
 * @brief Pairs of faces that face each other, or belong to two fragments, and are nearer than half the initial gap at their corners.
 */
#ifndef BoneDecimate_Core_Intersections_GapPairs_h
#define BoneDecimate_Core_Intersections_GapPairs_h

#include "FaceHistory.h"
#include "Piece.h"

#include <vector>

namespace bonedecimate
{
/// mm, how far from a face its gaps have to be looked after.
double ReachOf(const Gap& gap);

/// Nearer than the initial gap allows, and nearer than the faces that the piece replaces.
bool IsTooNear(
  const GapRule& widths, const Piece& piece, const Piece& near, const std::vector<Piece>& old);

/// For each pair of faces that are too near to each other, one of which the edits of the journal have changed, the later edit of
/// both. Whether they were as near in the input makes no difference: more is undone then.
/// @param widths Of the vertices of the mesh before the first edit of the journal.
/// @param checked Of each face, the last edit of it in the last call; empty before the first for a journal. Only new faces are looked at
/// first, and if they have no such pair, all: a pair may also arise where an undone edit has restored a face or a wider gap.
std::vector<Index> FindNarrowedGaps(const HalfEdgeMesh& mesh, const GapRule& widths,
  const EditJournal& journal, std::vector<Index>& checked, int threads);

/// A merged vertex represents both.
void MergeGaps(const EditJournal& journal, const HalfEdgeMesh& mesh, GapRule& widths);
}

#endif
