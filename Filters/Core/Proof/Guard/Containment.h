// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Containment.h
 * @brief Which components of a mesh lie within which others.
 *
 * A ray from one vertex of each component meets the triangles of a closed component that holds it
 * an odd number of times, by exact predicates. Rays that pass exactly through an edge are replaced
 * by others, and so is a vertex that lies on another component. A component with all of the
 * vertices that are tried on others is within none.
 */
#ifndef BoneDecimate_Core_Proof_Guard_Containment_h
#define BoneDecimate_Core_Proof_Guard_Containment_h

#include "Geometry/BoundingTree.h"
#include "Mesh/HalfEdgeMesh.h"

#include <functional>
#include <vector>

namespace bonedecimate
{
/// For each component, those that its ray leaves an odd number of times, in ascending order. The
/// closed ones among them enclose it.
/// @param componentOf The component of a vertex.
/// @param tree Bounding tree of the faces of the mesh by their ids; null: one is made.
std::vector<std::vector<Index>> FindEnclosing(const HalfEdgeMesh& mesh, Index components,
  const std::function<Index(VertexId)>& componentOf, const BoundingTree* tree, int threads);
}

#endif
