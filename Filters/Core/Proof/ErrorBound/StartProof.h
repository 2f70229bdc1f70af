// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StartProof.h
 * @brief For a run that continues an earlier one, proves that the mesh it starts from covers the
 * original (ReferenceMesh.h).
 *
 *     triangles     by BulkProof, as after a draft
 *     boundaries    each edge by boundary edges of the mesh near it        (BoundaryProof)
 *
 * Nothing has to be proved from the mesh to the original: faces that never change are as near as
 * they were, and new ones are proved when they are made.
 */
#ifndef BoneDecimate_Core_Proof_ErrorBound_StartProof_h
#define BoneDecimate_Core_Proof_ErrorBound_StartProof_h

#include "Geometry/Zone.h"
#include "Proof/Reference/ReferenceMesh.h"

#include <vector>

namespace bonedecimate
{
class ErrorBound;

/// Fills the coverage of the bound.
/// @param zone Where edits are allowed; originals farther away than the limit need no proof. Null:
///   everywhere.
/// @return Triangles of the original that are not proved or have a boundary edge that is not. What
///   is near them must not change.
std::vector<Index> ProveStart(ErrorBound& bound, const ReferenceMesh& reference,
  const HalfEdgeMesh& mesh, const Zone* zone, int threads);
}

#endif
