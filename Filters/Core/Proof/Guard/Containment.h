// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Containment.h
 * @brief Which components of a mesh lie within which others.
 *
 * A ray from a vertex of each component meets the triangles of a closed component that contains it
 * an odd number of times, by exact predicates. If a ray passes exactly through an edge, other
 * directions are tried; if the vertex lies on another component, other vertices are. A component of
 * which all tried vertices lie on others is within none.
 */
#ifndef BoneDecimate_Core_Proof_Guard_Containment_h
#define BoneDecimate_Core_Proof_Guard_Containment_h

#include "Geometry/BoundingTree.h"
#include "Mesh/HalfEdgeMesh.h"

#include <functional>
#include <vector>

namespace bonedecimate
{
/// For each component, those that its ray meets an odd number of times, in ascending order. The
/// closed ones among them enclose it.
/// @param componentOf The component of a vertex.
/// @param tree Bounding tree of the faces of the mesh by their ids. Null: one is built.
std::vector<std::vector<Index>> FindEnclosing(const HalfEdgeMesh& mesh, Index components,
  const std::function<Index(VertexId)>& componentOf, const BoundingTree* tree, int threads);
}

#endif
