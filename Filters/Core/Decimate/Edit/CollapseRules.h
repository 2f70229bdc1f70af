// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CollapseRules.h
 * @brief The rules of a collapse in every mode. Each is a function that returns a rejection.
 */
#ifndef BoneDecimate_Core_Decimate_Edit_CollapseRules_h
#define BoneDecimate_Core_Decimate_Edit_CollapseRules_h

#include "Decimate/Kernels/Kernels.h"
#include "Figures/Rejection.h"
#include "Mesh/EdgeNeighborhood.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Proof/EditFilters/SurfaceChange.h"

namespace bonedecimate
{
/// Rejects edges with a constrained end or two stationary ends, and interior edges without an end
/// that moves freely. Their collapse would pinch the surface or move a vertex that must not move.
Rejection CheckEnds(const HalfEdgeMesh& mesh, HalfEdgeId edge);

/// Checks the link condition and that the fragment keeps enough faces.
Rejection CheckTopology(const HalfEdgeMesh& mesh, const EdgeNeighborhood& around);

/// Fills the fan from the mesh, except for the position.
void FillFan(const HalfEdgeMesh& mesh, const EdgeNeighborhood& around, Fan& fan);

/// Rejects faces without area, new slivers, and faces that turn by more than 78 degrees, or by more
/// than 90 degrees from their initial normal (HalfEdgeMesh::IsTurnedOver), so that small rotations
/// cannot accumulate.
/// @param fan Filled. Its position and areas are set here.
/// @param change Receives its volume.
Rejection CheckPosition(
  const HalfEdgeMesh& mesh, const EdgeNeighborhood& around, Fan& fan, SurfaceChange& change);
}

#endif
