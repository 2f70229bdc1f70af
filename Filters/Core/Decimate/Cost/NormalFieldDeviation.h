// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NormalFieldDeviation.h
 * @brief The costs of edges and vertices of the thesis.
 *
 * For an edge e with triangles 1 and 2 of areas D1, D2 and unit normals n1, n2, and the tolerance
 * w:
 *
 *     NFD(e)  = (D1 + D2) (1 - w n1.n2)                                     mm^2
 *     Cost(e) = NFD(e) length(e)                                            mm^3
 *     Cost(v) = sum of Cost(e) over the edges at v
 *             + L (sum of Dt - | sum of Dt nt |) over the triangles t at v  mm^3
 *
 * The thesis has no L: its second term is mm^2 beside mm^3, so its order depends on the unit of
 * length. Here L is the mean edge length of the cleaned input, so costs scale with the cube of the
 * unit and the order is the same in millimeters and in meters. A boundary edge has one triangle.
 * Its missing twin counts as a triangle of the same area at right angles: NFD = 2 D1.
 *
 * M. Hussain, Efficient simplification methods for generating high quality LODs of 3D meshes, 2009:
 * NFD. H. Brandao, BSc thesis, Groningen 2018: the tolerance w and the vertex cost.
 */
#ifndef BoneDecimate_Core_Decimate_Cost_NormalFieldDeviation_h
#define BoneDecimate_Core_Decimate_Cost_NormalFieldDeviation_h

#include "Mesh/FaceAreas.h"
#include "Mesh/HalfEdgeMesh.h"
#include "VertexCost.h"

#include <memory>

namespace bonedecimate
{
class NormalFieldDeviation : public VertexCost
{
public:
  /// @param tolerance w, 0 to 1.  @param meanEdgeLength L, mm.
  NormalFieldDeviation(
    const HalfEdgeMesh& mesh, const FaceAreas& areas, double tolerance, double meanEdgeLength)
    : Mesh(mesh)
    , Areas(areas)
    , Tolerance(tolerance)
    , CurvatureLength(meanEdgeLength)
  {
  }

  double OfEdge(HalfEdgeId h) const override; ///< mm^3
  double OfVertex(VertexId v) const override; ///< mm^3

private:
  const HalfEdgeMesh& Mesh;
  const FaceAreas& Areas;
  double Tolerance;
  double CurvatureLength; // mm
};

/// For the table of modes.
std::unique_ptr<VertexCost> MakeNormalFieldDeviation(
  const HalfEdgeMesh& mesh, const FaceAreas& areas, double tolerance, double meanEdgeLength);
}

#endif
