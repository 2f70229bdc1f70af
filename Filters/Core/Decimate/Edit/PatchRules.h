// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PatchRules.h
 * @brief The rules of edits where manifold patches meet. No edit joins two patches along an edge
 * that they did not have in common, or removes the last face at a stationary end of open curves.
 */
#ifndef BoneDecimate_Core_Decimate_Edit_PatchRules_h
#define BoneDecimate_Core_Decimate_Edit_PatchRules_h

#include "Mesh/EdgeNeighborhood.h"
#include "Mesh/VertexRange.h"
#include "Proof/EditFilters/Decision.h"

namespace bonedecimate
{
/// Checks a collapse. Defers it if a duplicate of a vertex around the edge is out of range.
Decision CheckPatches(const HalfEdgeMesh& mesh, const EdgeNeighborhood& around, VertexRange range);

/// Checks the collapse of an edge of a feature curve in all patches at it.
/// @param patches The neighborhood of the edge in each patch.
/// @param gone The original vertex to remove.
Rejection CheckPatchBoundary(
  const HalfEdgeMesh& mesh, const std::vector<const EdgeNeighborhood*>& patches, VertexId gone);

/// Checks a flip that makes an edge from a to b.
Decision CheckNewEdge(const HalfEdgeMesh& mesh, VertexId a, VertexId b, VertexRange range);
}

#endif
