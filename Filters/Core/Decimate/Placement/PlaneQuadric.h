// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlaneQuadric.h
 * @brief Position candidates of the merged vertex: the thesis's local plane quadric and
 * alternatives if that is rejected.
 *
 * Over the triangles t of both rings, with unit normals nt and a corner vt each, the vertex u
 * minimizes
 *
 *     sum of (nt.(u - vt))^2        A u = b,  A = sum of nt ntT,  b = sum of A_t vt
 *
 * Over one vertex's own ring the minimum would be that vertex, so the sum is over both rings. Flat
 * and cylindrical rings make A singular: a ridge of 1e-3 tr(A)/3 pulls u to the middle of the edge
 * in the directions the planes leave open.
 *
 * Between two inside vertices: that u, unless it is farther than two edge lengths from the middle;
 * then its minimum along the edge, the middle, the ends. From inside to boundary: the boundary
 * vertex. Along a boundary edge: the minimum along the edge of the same sum plus the squared
 * distances to the two neighboring boundary edges' lines; then the ends.
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
