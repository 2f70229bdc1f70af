// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Gate.h
 * @brief What no collapse may do, whatever the mode: the rules, each a function that returns a verdict.
 */
#ifndef BoneDecimate_Core_Collapse_Gate_h
#define BoneDecimate_Core_Collapse_Gate_h

#include "Kernels/Kernels.h"
#include "Mesh/Edit.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Mesh/Neighbourhood.h"
#include "Report.h"

namespace bonedecimate
{
/// Locked or frozen ends, two pinned ones, and edges inside that join two vertices on borders, seams or pinned: collapsing
/// those would pinch the surface or move what must not move.
Verdict JudgeEnds(const HalfEdgeMesh& mesh, Index edge);

/// Link condition and the least size of fragments.
Verdict JudgeTopology(const HalfEdgeMesh& mesh, const Neighbourhood& around);

/// Fills the fan's ring from the mesh: everything but the place.
void FillFan(const HalfEdgeMesh& mesh, const Neighbourhood& around, Fan& fan);

/// No face without area, none worse than a sliver unless it was, none turned by more than 78 degrees, nor by more than 90
/// from what it was before its first change: many small turns do not add up to a face that is turned over.
/// @param fan Filled; its place and areas are set here.  @param volumeChange mm^3, returned.
Verdict JudgePlace(const HalfEdgeMesh& mesh, const Neighbourhood& around, const Edit& edit,
  Fan& fan, double& volumeChange);
}

#endif
