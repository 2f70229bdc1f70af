// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SplitRules.h
 * @brief The rules of edge splits.
 *
 * No face with three constrained corners is split, so one end at least is not constrained. An edge
 * on a boundary is split only if it is the only boundary edge of its face, not on a feature curve,
 * and neither end is constrained. No triangle turns, loses its area or becomes a worse needle than
 * FlipAndMoveRules.h allows.
 */
#ifndef BoneDecimate_Core_Decimate_Edit_SplitRules_h
#define BoneDecimate_Core_Decimate_Edit_SplitRules_h

#include "Figures/Rejection.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Proof/EditFilters/SurfaceChange.h"

namespace bonedecimate
{
/// What does not depend on the position.
Rejection CheckSplit(const HalfEdgeMesh& mesh, HalfEdgeId edge);
}

#endif
