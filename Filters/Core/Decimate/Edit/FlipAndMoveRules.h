// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FlipAndMoveRules.h
 * @brief The rules of flips, moves and splits, which remove nothing.
 *
 * Constrained and stationary vertices never move. No corner of the two faces of a flipped edge is
 * constrained, the new edge must not exist yet. No face with three constrained corners is split, so
 * one end at least is not constrained. An edge on a boundary is split only if it is the only
 * boundary edge of its face, not on a feature curve, and neither end is constrained. No triangle
 * turns by more than CollapseRules.h allows, loses its area or becomes a worse needle.
 */
#ifndef BoneDecimate_Core_Decimate_Edit_FlipAndMoveRules_h
#define BoneDecimate_Core_Decimate_Edit_FlipAndMoveRules_h

#include "Figures/Rejection.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Proof/EditFilters/SurfaceChange.h"

#include <array>

namespace bonedecimate
{
/// The corners around an inside edge a-b: a, b, c (apex of its face), d (apex of its twin's face).
std::array<Index, 4> CornersAround(const HalfEdgeMesh& mesh, HalfEdgeId edge);
/// mm from the local origin
std::array<Vector3, 4> PositionsOf(const HalfEdgeMesh& mesh, const std::array<Index, 4>& corners);

/// The rules of a flip that need no positions.
Rejection CheckFlipTopology(const HalfEdgeMesh& mesh, const std::array<Index, 4>& corners);
/// Whether no face of a flip turns too far or becomes a worse needle.
bool KeepsShape(const std::array<Vector3, 4>& corners);

/// @param change Gets its volume if it is allowed, as from the rules below.
Rejection CheckFlip(const HalfEdgeMesh& mesh, SurfaceChange& change);
Rejection CheckMove(const HalfEdgeMesh& mesh, SurfaceChange& change);
/// The rules of a split that do not depend on the position.
Rejection CheckSplit(const HalfEdgeMesh& mesh, HalfEdgeId edge);
/// The rules of a move for a new face against the one that it replaces.
Rejection CheckNewFace(const HalfEdgeMesh& mesh, FaceId old, const std::array<Vector3, 3>& corners);
/// Checks a collapse together with moves and flips, or a split, by the rules of a move: each new
/// face against the face that it replaces.
Rejection CheckNewFaces(const HalfEdgeMesh& mesh, SurfaceChange& change);
}

#endif
