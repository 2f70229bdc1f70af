// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Gate.h
 * @brief Whether an edge may be collapsed at all, and whether to that place.
 *
 * The link condition for triangle meshes: the vertices joined to both ends are exactly the apexes of the faces at the edge.
 * T. Dey, H. Edelsbrunner, S. Guha, D. Nekhayev, Topology preserving edge contraction, 1999.
 *
 * | start \ end | inside    | border                                   | locked  |
 * |-------------|-----------|------------------------------------------|---------|
 * | inside      | by link   | by link, to the border vertex            | refused |
 * | border      | (as left) | border edge: by link; inside edge: refused, it would pinch | refused |
 */
#ifndef BoneDecimate_Core_Collapse_Gate_h
#define BoneDecimate_Core_Collapse_Gate_h

#include "Mesh/Edit.h"
#include "Mesh/FaceAreas.h"
#include "Mesh/Neighbourhood.h"
#include "Report.h"

namespace bonedecimate
{
/// The table above, by the kinds of the ends: asked first, since rings of locked vertices cannot be gathered.
Verdict JudgeEnds(const HalfEdgeMesh& mesh, Index edge);

/// Topology only: link condition and least sizes of fragments.
Verdict JudgeTopology(const HalfEdgeMesh& mesh, const Neighbourhood& around);

/// Geometry only: no triangle turns over or loses its area.
Verdict JudgePlace(
  const HalfEdgeMesh& mesh, const FaceAreas& areas, const Neighbourhood& around, const Edit& edit);

/// By how much the edit would change the volume enclosed by the surface, mm^3.
double VolumeChange(const HalfEdgeMesh& mesh, const Neighbourhood& around, const Edit& edit);
}

#endif
