// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SmallEdits.h
 * @brief Whether a vertex may be moved or an edge flipped: the rules of Gate.h for edits that remove nothing.
 *
 * Locked, frozen and pinned vertices never move. No corner of the two faces of a flipped edge is locked or frozen, the
 * new edge must not exist yet. No triangle turns by more than the gate allows, loses its area or becomes a worse needle.
 */
#ifndef BoneDecimate_Core_Collapse_SmallEdits_h
#define BoneDecimate_Core_Collapse_SmallEdits_h

#include "Mesh/HalfEdgeMesh.h"
#include "Report.h"

#include <array>

namespace bonedecimate
{
/// The corners around an inside edge a-b: a, b, c (apex of its face), d (apex of its twin's face).
std::array<Index, 4> CornersAround(const HalfEdgeMesh& mesh, Index edge);
/// mm from the local origin
std::array<Vector3, 4> PositionsOf(const HalfEdgeMesh& mesh, const std::array<Index, 4>& corners);

/// @param volumeChange mm^3, returned if it is allowed.
Verdict JudgeFlip(const HalfEdgeMesh& mesh, Index edge, double& volumeChange);
Verdict JudgeMove(
  const HalfEdgeMesh& mesh, Index vertex, const Vector3& position, double& volumeChange);
}

#endif
