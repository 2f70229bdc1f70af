// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlaneQuadric.h"

#include <Eigen/Cholesky>

#include <algorithm>

namespace bonedecimate
{
namespace
{
constexpr double Ridge = 1e-3;       // of the mean eigenvalue of A
constexpr double FarthestMove = 2.0; // edge lengths from the middle

/// Calls visit(normal, corner) for the plane of every triangle of both rings, including the two at
/// the edge.
template <typename Visit>
void VisitPlanes(
  const HalfEdgeMesh& mesh, const FaceAreas& areas, const EdgeNeighborhood& around, Visit visit)
{
  for (Index i = 0; i < around.NumberOfRemovedFaces; ++i)
  {
    visit(areas[around.RemovedFaces[i]].Normal, mesh.Position(around.Start));
  }
  for (const HalfEdgeId h : around.Corners)
  {
    visit(areas[HalfEdgeMesh::Face(h)].Normal, mesh.Position(mesh.Origin(h)));
  }
}

void Add(PositionCandidates& proposals, const EdgeNeighborhood& around, const Vector3& position)
{
  proposals.Edits[proposals.Count++] = { around.Edge, around.Start, position, false };
}

void AddEnd(PositionCandidates& proposals, const HalfEdgeMesh& mesh, const EdgeNeighborhood& around,
  Index end)
{
  proposals.Edits[proposals.Count++] = { around.Edge, end, mesh.Position(end), true };
}

/// Minimizes a sum of squares along the edge. Each term is given by its change along the edge and
/// its value at Start.
class EdgeMinimum
{
public:
  void Add(double change, double atStart)
  {
    this->Slope += change * atStart;
    this->Curvature += change * change;
  }
  /// Adds the squared distance to a line, by the parts of the vectors across the line.
  void AddLine(const Vector3& direction, const Vector3& edge, const Vector3& fromLine)
  {
    const Vector3 edgeAcross = edge - Dot(direction, edge) * direction;
    const Vector3 fromAcross = fromLine - Dot(direction, fromLine) * direction;
    this->Slope += Dot(edgeAcross, fromAcross);
    this->Curvature += edgeAcross.squaredNorm();
  }
  double Fraction() const
  {
    return this->Curvature > 0.0 ? std::clamp(-this->Slope / this->Curvature, 0.0, 1.0) : 0.5;
  }

private:
  double Slope = 0.0;
  double Curvature = 0.0;
};

EdgeMinimum PlanesAlongEdge(
  const HalfEdgeMesh& mesh, const FaceAreas& areas, const EdgeNeighborhood& around)
{
  const Vector3& start = mesh.Position(around.Start);
  const Vector3 edge = mesh.Position(around.End) - start;
  EdgeMinimum minimum;
  VisitPlanes(mesh, areas, around,
    [&](const Vector3& normal, const Vector3& corner)
    { minimum.Add(Dot(normal, edge), Dot(normal, start - corner)); });
  return minimum;
}

void ProposeInside(const HalfEdgeMesh& mesh, const FaceAreas& areas, const EdgeNeighborhood& around,
  PositionCandidates& proposals)
{
  const Vector3& start = mesh.Position(around.Start);
  const Vector3& end = mesh.Position(around.End);
  const Vector3 middle = 0.5 * (start + end);
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Vector3 b = Vector3::Zero();
  VisitPlanes(mesh, areas, around,
    [&](const Vector3& normal, const Vector3& corner)
    {
      a += normal * normal.transpose();
      b += normal * Dot(normal, corner - middle);
    });
  a.diagonal().array() += Ridge * a.trace() / 3.0;
  const Vector3 move = a.llt().solve(b);
  if (move.squaredNorm() <= FarthestMove * FarthestMove * (end - start).squaredNorm())
  {
    Add(proposals, around, middle + move);
  }
  Add(proposals, around, start + PlanesAlongEdge(mesh, areas, around).Fraction() * (end - start));
  Add(proposals, around, middle);
  AddEnd(proposals, mesh, around, around.Start);
  AddEnd(proposals, mesh, around, around.End);
}

void ProposeAlongBoundary(const HalfEdgeMesh& mesh, const FaceAreas& areas,
  const EdgeNeighborhood& around, PositionCandidates& proposals)
{
  const Vector3& start = mesh.Position(around.Start);
  const Vector3 edge = mesh.Position(around.End) - start;
  EdgeMinimum minimum = PlanesAlongEdge(mesh, areas, around);
  for (const VertexId end : { around.Start, around.End })
  {
    mesh.VisitEdges(end,
      [&](HalfEdgeId h)
      {
        const VertexId other = mesh.OtherEnd(h, end);
        if (mesh.Twin(h) == None && other != around.Start && other != around.End)
        {
          const Vector3 direction = (mesh.Position(other) - mesh.Position(end)).stableNormalized();
          minimum.AddLine(direction, edge, start - mesh.Position(end));
        }
      });
  }
  Add(proposals, around, start + minimum.Fraction() * edge);
  AddEnd(proposals, mesh, around, around.Start);
  AddEnd(proposals, mesh, around, around.End);
}
}

PositionCandidates PlaneQuadricPositions(
  const HalfEdgeMesh& mesh, const FaceAreas& areas, const EdgeNeighborhood& around)
{
  PositionCandidates proposals;
  const VertexConstraint start = mesh.Constraint(around.Start);
  const VertexConstraint end = mesh.Constraint(around.End);
  if (start != end)
  {
    AddEnd(proposals, mesh, around, Outranks(start, end) ? around.Start : around.End);
  }
  else if (around.IsBoundaryEdge())
  {
    ProposeAlongBoundary(mesh, areas, around, proposals);
  }
  else
  {
    ProposeInside(mesh, areas, around, proposals);
  }
  return proposals;
}
}
