// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RingQuadrics.h
 * @brief Keeps the quadrics of the vertex records equal to the sums over the current triangles.
 *
 *     M_v = sum of 2 A n n^T,  G_v = sum of 2 A n    over the triangles at v, squares of the unit
 *     M_v += 2 (|b|^2 I - b b^T)                     for each boundary edge b at v
 *
 * A collapse only adds the differences at its ring.
 */
#ifndef BoneDecimate_Core_Decimate_Edit_RingQuadrics_h
#define BoneDecimate_Core_Decimate_Edit_RingQuadrics_h

#include "Decimate/Kernels/Kernels.h"
#include "Mesh/EdgeNeighborhood.h"

namespace bonedecimate
{
/// Computes all quadrics, except those of constrained vertices, whose edges are never collapsed.
void SumRingQuadrics(HalfEdgeMesh& mesh, int threads);

/**
 * Updates the quadrics after the collapse of the edge of `around` into `keep`.
 * @param origin Position of Start before the collapse, mm.
 * @param fan As CheckFan left it.
 */
void ExchangeRingQuadrics(HalfEdgeMesh& mesh, const EdgeNeighborhood& around, VertexId keep,
  const Vector3& origin, const Fan& fan);
}

#endif
