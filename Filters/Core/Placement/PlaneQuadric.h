// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlaneQuadric.h
 * @brief Where the merged vertex may go: the thesis's local plane quadric and what to try when that is refused.
 *
 * Over the triangles t of both rings, with unit normals nt and a corner vt each, the vertex u minimises
 *
 *     sum of (nt.(u - vt))^2        A u = b,  A = sum of nt ntT,  b = sum of A_t vt
 *
 * Over one vertex's own ring the answer would be that vertex, so both rings are meant. Flat and cylindrical rings make A
 * singular: a ridge of 1e-3 tr(A)/3 pulls u to the middle of the edge in the directions the planes leave open.
 *
 * Between two inside vertices: that u, unless it is farther than two edge lengths from the middle; then its minimum
 * along the edge, the middle, the ends. From inside to border: the border vertex. Along a border edge: the minimum
 * along the edge of the same sum plus the squared distances to the two neighbouring border edges' lines; then the ends.
 *
 * M. Garland and P. Heckbert, Surface simplification using quadric error metrics, 1997: the quadric.
 */
#ifndef BoneDecimate_Core_Placement_PlaneQuadric_h
#define BoneDecimate_Core_Placement_PlaneQuadric_h

#include "Mesh/Edit.h"
#include "Mesh/FaceAreas.h"
#include "Mesh/Neighbourhood.h"

#include <array>

namespace bonedecimate
{
/// Edits to try, best first.
struct Proposals
{
  std::array<Edit, 5> Edits;
  std::size_t Count = 0;
};

Proposals ProposePlaces(
  const HalfEdgeMesh& mesh, const FaceAreas& areas, const Neighbourhood& around);
}

#endif
