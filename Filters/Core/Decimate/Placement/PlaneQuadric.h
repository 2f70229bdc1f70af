// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlaneQuadric.h
 * @brief Candidates for the position of the merged vertex in the thesis: the minimum of the local
 * plane quadric, and alternatives if it is rejected.
 *
 * Over the triangles t of both rings, with unit normals nt and a corner vt each, the vertex u
 * minimizes
 *
 *     sum of (nt.(u - vt))^2        A u = b,  A = sum of At, At = nt nt^T,  b = sum of At vt
 *
 * The sum is over both rings, because the minimum over the ring of one vertex would be this vertex.
 * Flat and cylindrical rings make A singular. A ridge of 1e-3 tr(A)/3 pulls u to the middle of the
 * edge in the directions that the planes leave open.
 *
 *     between two inner vertices:   u, unless it is farther than two edge lengths from the middle;
 *                                   the minimum along the edge; the middle; the ends
 *     from inner to boundary:       the boundary vertex
 *     along a boundary edge:        the minimum along the edge of the same sum plus the squared
 *                                   distances to the lines of the two next boundary edges; the ends
 *
 * M. Garland and P. Heckbert, Surface simplification using quadric error metrics, 1997: the
 * quadric.
 */
#ifndef BoneDecimate_Core_Decimate_Placement_PlaneQuadric_h
#define BoneDecimate_Core_Decimate_Placement_PlaneQuadric_h

#include "Mesh/EdgeNeighborhood.h"
#include "Mesh/Edit.h"
#include "Mesh/FaceAreas.h"

#include <array>

namespace bonedecimate
{
/// Edits to try, best first.
struct PositionCandidates
{
  std::array<Edit, 5> Edits;
  std::size_t Count = 0;
};

PositionCandidates PlaneQuadricPositions(
  const HalfEdgeMesh& mesh, const FaceAreas& areas, const EdgeNeighborhood& around);
}

#endif
