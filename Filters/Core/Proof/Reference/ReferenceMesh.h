// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReferenceMesh.h
 * @brief The original of a run that continues an earlier one: edits start from the input, but the
 * error bound refers to this mesh.
 *
 * Both meshes have ids of their own. The relations between them are only starts of walks: proofs
 * decide what is near.
 */
#ifndef BoneDecimate_Core_Proof_Reference_ReferenceMesh_h
#define BoneDecimate_Core_Proof_Reference_ReferenceMesh_h

#include "Geometry/BoundingTree.h"
#include "Mesh/Cleaning.h"
#include "Mesh/CutEdges.h"
#include "Mesh/HalfEdgeMesh.h"

#include <vector>

namespace bonedecimate
{
struct ReferenceMesh
{
  CleanSurface Clean; ///< mm relative to the local origin of the input.
  HalfEdgeMesh Mesh;
  CutEdges Cuts;
  BoundingTree Tree;
  std::vector<Index> NearVertex; ///< For each vertex a vertex of the input near it.
  /// For each vertex of the input, a triangle of this mesh near it.
  std::vector<Index> NearTriangle;
};
}

#endif
