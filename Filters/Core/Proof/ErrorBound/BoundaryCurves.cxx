// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryCurves.h"

#include "Mesh/PatchBoundaries.h"

#include <cmath>

namespace bonedecimate
{
BoundaryCurves::BoundaryCurves(const HalfEdgeMesh& mesh, const CutEdges& cuts)
  : Mesh(mesh)
{
  std::vector<Index> leaving(static_cast<std::size_t>(mesh.NumberOfVertexSlots()), None);
  for (Index face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    for (Index corner = 0; corner < 3; ++corner)
    {
      const HalfEdgeId h = HalfEdgeMesh::HalfEdge(face, corner);
      if (mesh.Twin(h) == None &&
        !cuts.Contain(mesh.OriginalVertex(mesh.Origin(h)), mesh.OriginalVertex(mesh.Target(h))))
      {
        leaving[mesh.Origin(h)] = this->Count();
        this->Edges.push_back(h);
      }
    }
  }
  this->Neighbors.resize(this->Edges.size(), { None, None });
  for (Index edge = 0; edge < this->Count(); ++edge)
  {
    const VertexId at = mesh.Target(this->Edges[edge]);
    if (leaving[at] != None &&
      (mesh.Constraint(at) == VertexConstraint::Boundary || IsInsidePatchBoundary(mesh, at)))
    {
      this->Neighbors[edge][1] = leaving[at];
      this->Neighbors[leaving[at]][0] = edge;
    }
  }
}

//------------------------------------------------------------------------------
BoundaryProof::Segment BoundaryCurves::Ends(Index edge) const
{
  const Index h = this->Edges[edge];
  return { this->Mesh.Position(this->Mesh.Origin(h)), this->Mesh.Position(this->Mesh.Target(h)) };
}

//------------------------------------------------------------------------------
double BoundaryCurves::Distance(const Vector3& p, Index edge) const
{
  return std::sqrt(BoundaryProof::SquaredDistance(this->Ends(edge), p));
}

//------------------------------------------------------------------------------
Index BoundaryCurves::WalkFrom(const Vector3& p, Index edge) const
{
  double least = this->Distance(p, edge);
  for (const std::size_t way : { 0, 1 })
  {
    for (Index next = this->Neighbors[edge][way]; next != None; next = this->Neighbors[edge][way])
    {
      const double distance = this->Distance(p, next);
      if (distance >= least)
      {
        break;
      }
      least = distance;
      edge = next;
    }
  }
  return edge;
}

//------------------------------------------------------------------------------
std::vector<Index> BoundaryCurves::EdgesAtVertices() const
{
  std::vector<Index> edges(
    this->Edges.empty() ? 0 : static_cast<std::size_t>(this->Mesh.NumberOfVertexSlots()), None);
  for (Index edge = 0; edge < this->Count(); ++edge)
  {
    edges[this->Mesh.Origin(this->Edges[edge])] = edge;
    edges[this->Mesh.Target(this->Edges[edge])] = edge;
  }
  return edges;
}
}
