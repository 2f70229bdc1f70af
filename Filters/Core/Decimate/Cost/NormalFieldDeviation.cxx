// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NormalFieldDeviation.h"

namespace bonedecimate
{
double NormalFieldDeviation::OfEdge(HalfEdgeId h) const
{
  const HalfEdgeId twin = this->Mesh.Twin(h);
  const FaceAreas::Face& face = this->Areas[HalfEdgeMesh::Face(h)];
  double deviation = 2.0 * face.Area; // mm^2
  if (twin != None)
  {
    const FaceAreas::Face& other = this->Areas[HalfEdgeMesh::Face(twin)];
    deviation = (face.Area + other.Area) * (1.0 - this->Tolerance * Dot(face.Normal, other.Normal));
  }
  return deviation *
    (this->Mesh.Position(this->Mesh.Target(h)) - this->Mesh.Position(this->Mesh.Origin(h))).norm();
}

double NormalFieldDeviation::OfVertex(VertexId v) const
{
  double edges = 0.0;                   // mm^3
  double area = 0.0;                    // mm^2
  Vector3 areaVector = Vector3::Zero(); // mm^2
  this->Mesh.VisitEdges(v,
    [&](HalfEdgeId h)
    {
      edges += this->OfEdge(h);
      if (this->Mesh.Origin(h) == v)
      {
        const FaceAreas::Face& face = this->Areas[HalfEdgeMesh::Face(h)];
        area += face.Area;
        areaVector += face.Area * face.Normal;
      }
    });
  return edges + this->CurvatureLength * (area - areaVector.norm());
}

//------------------------------------------------------------------------------
std::unique_ptr<VertexCost> MakeNormalFieldDeviation(
  const HalfEdgeMesh& mesh, const FaceAreas& areas, double tolerance, double meanEdgeLength)
{
  return std::make_unique<NormalFieldDeviation>(mesh, areas, tolerance, meanEdgeLength);
}
}
