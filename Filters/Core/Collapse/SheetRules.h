// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SheetRules.h
 * @brief What no edit may do where sheets meet: join two of them along an edge that they did not have in common, or take
 * the last face at a pinned end of open lines.
 */
#ifndef BoneDecimate_Core_Collapse_SheetRules_h
#define BoneDecimate_Core_Collapse_SheetRules_h

#include "Mesh/Neighbourhood.h"
#include "Mesh/VertexRange.h"
#include "Report.h"

namespace bonedecimate
{
/// Of a collapse.  @return Elsewhere if a copy of something around the edge is out of range.
Verdict JudgeSheets(const HalfEdgeMesh& mesh, const Neighbourhood& around, VertexRange range);

/// Of a flip that makes an edge from a to b.
Verdict JudgeNewEdge(const HalfEdgeMesh& mesh, Index a, Index b, VertexRange range);
}

#endif
