// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Separation.h
 * @brief How near a surface comes to itself: at each triangle, the distance within which it is one
 * disk.
 *
 *     disk:        triangles connected across edges, with Euler characteristic 1
 *     separation:  the triangles nearer than this belong to one disk; 0 at triangles that
 *                  intersect others
 *
 * Beyond it lies another part of the surface: the other side of a thin plate or strut, or another
 * fragment. Documentation/explanation/error-bound.md has the consequences.
 */
#ifndef BoneDecimate_Core_Proof_Guard_Separation_h
#define BoneDecimate_Core_Proof_Guard_Separation_h

#include "Base/Monitor.h"
#include "Mesh/HalfEdgeMesh.h"

#include <optional>
#include <vector>

namespace bonedecimate
{
/// mm, for each vertex the least separation of its triangles; infinite if it is not below the
/// limit. Nothing after an abort by the monitor, which may be empty.
std::optional<std::vector<double>> FindSeparations(
  const HalfEdgeMesh& mesh, double limit, int threads, const Monitor& monitor);
}

#endif
