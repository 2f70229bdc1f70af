// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RingQuadrics.h
 * @brief Keeps the quadrics of the vertex records equal to the sums over the triangles as they are
 * now.
 *
 *     M_v = sum of 2 A n n^T,  G_v = sum of 2 A n           over the triangles at v, squares of the
 *                                                           mesh's unit
 *     M_v += 2 (|b|^2 I - b b^T)                            for each boundary edge b at v
 *
 * After a collapse only the difference is added, so that it costs the ring and not the rings of the
 * ring.
 */
#ifndef BoneDecimate_Core_Decimate_Edit_RingQuadrics_h
#define BoneDecimate_Core_Decimate_Edit_RingQuadrics_h

#include "Decimate/Kernels/Kernels.h"
#include "Mesh/EdgeNeighborhood.h"

namespace bonedecimate
{
/// All of them afresh. Constrained vertices get none: their edges are never collapsed.
void SumRingQuadrics(HalfEdgeMesh& mesh, int threads);

/**
 * After the collapse of what is in `around` into `keep`.
 * @param origin Where Start was before, mm.
 * @param fan As CheckFan left it.
 */
void ExchangeRingQuadrics(HalfEdgeMesh& mesh, const EdgeNeighborhood& around, VertexId keep,
  const Vector3& origin, const Fan& fan);
}

#endif
