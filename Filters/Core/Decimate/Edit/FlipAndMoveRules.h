// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FlipAndMoveRules.h
 * @brief The rules of flips, moves and splits, which remove nothing.
 *
 *     move    constrained and stationary vertices never move
 *     flip    no corner of the two faces is constrained, and the new edge does not exist yet
 *     split   not of a face with three constrained corners, so an end is not constrained; a
 *             boundary edge only if its face has no other boundary edge, it is not on a feature
 *             curve, and neither end is constrained
 *     all     no triangle turns farther than CollapseRules.h allows, loses its area or becomes a
 *             worse needle
 */
#ifndef BoneDecimate_Core_Decimate_Edit_FlipAndMoveRules_h
#define BoneDecimate_Core_Decimate_Edit_FlipAndMoveRules_h

#include "Figures/Rejection.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Proof/EditFilters/SurfaceChange.h"

#include <array>

namespace bonedecimate
{
/// The corners around an interior edge a-b: a, b, c (apex of its face), d (apex of its twin's
/// face).
std::array<Index, 4> CornersAround(const HalfEdgeMesh& mesh, HalfEdgeId edge);
/// Positions of the corners, mm from the local origin.
std::array<Vector3, 4> PositionsOf(const HalfEdgeMesh& mesh, const std::array<Index, 4>& corners);

/// The rules of a flip that need no positions.
Rejection CheckFlipTopology(const HalfEdgeMesh& mesh, const std::array<Index, 4>& corners);
/// Whether no face of a flip turns too far or becomes a worse needle. @param corners Before the
/// flip, as CornersAround().
bool KeepsShape(const std::array<Vector3, 4>& corners);

/// @param change Receives its volume if the edit is allowed; likewise below.
Rejection CheckFlip(const HalfEdgeMesh& mesh, SurfaceChange& change);
Rejection CheckMove(const HalfEdgeMesh& mesh, SurfaceChange& change);
/// The rules of a split that do not depend on the position.
Rejection CheckSplit(const HalfEdgeMesh& mesh, HalfEdgeId edge);
/// Checks a new face against the one that it replaces, by the rules of a move.
Rejection CheckNewFace(const HalfEdgeMesh& mesh, FaceId old, const std::array<Vector3, 3>& corners);
/// Checks a split, or a collapse together with moves and flips: each new face against the face that
/// it replaces.
Rejection CheckNewFaces(const HalfEdgeMesh& mesh, SurfaceChange& change);
}

#endif
