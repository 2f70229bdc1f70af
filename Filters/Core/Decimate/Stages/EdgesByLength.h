// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EdgesByLength.h
 * @brief The edges of a mesh, each once, shortest first.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_EdgesByLength_h
#define BoneDecimate_Core_Decimate_Stages_EdgesByLength_h

#include "Mesh/HalfEdgeMesh.h"

#include <vector>

namespace bonedecimate
{
struct EdgeOfLength
{
  double SquaredLength; // mm^2
  HalfEdgeId Edge;
};

inline double SquaredLength(const HalfEdgeMesh& mesh, HalfEdgeId edge)
{
  return (mesh.Position(mesh.Target(edge)) - mesh.Position(mesh.Origin(edge))).squaredNorm();
}

/// Whether the half-edge still exists and has the same length.
inline bool IsUnchanged(const HalfEdgeMesh& mesh, const EdgeOfLength& edge)
{
  return mesh.IsAlive(HalfEdgeMesh::Face(edge.Edge)) &&
    SquaredLength(mesh, edge.Edge) == edge.SquaredLength;
}

/// The edges longer than `above` and shorter than `below`, mm.
std::vector<EdgeOfLength> EdgesByLength(
  const HalfEdgeMesh& mesh, double above = -1.0, double below = Infinity);
}

#endif
