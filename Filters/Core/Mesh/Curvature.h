// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Curvature.h
 * @brief The curvature of a surface, averaged over a neighborhood of each vertex.
 *
 *     T(B) = 1 / area(B) * sum over edges of B: angle * length * e e^T    e: direction of the edge
 *
 * The angle is that between the normals of the two faces, positive where the surface is convex. The
 * eigenvalues of T are the principal curvatures and 0.
 *
 * D. Cohen-Steiner and J.-M. Morvan, Restricted Delaunay triangulations and normal cycle, 2003.
 */
#ifndef BoneDecimate_Core_Mesh_Curvature_h
#define BoneDecimate_Core_Mesh_Curvature_h

#include "HalfEdgeMesh.h"
#include "PointGraph.h"

#include <vector>

namespace bonedecimate
{
/**
 * For each vertex, the largest absolute principal curvature, 1/mm, of the surface that edges within
 * the radius connect with it.
 * @param mesh Before the first edit.  @param graph The graph of its points.  @param radius mm
 */
std::vector<double> MaxCurvatures(
  const HalfEdgeMesh& mesh, const PointGraph& graph, double radius, int threads);
}

#endif
