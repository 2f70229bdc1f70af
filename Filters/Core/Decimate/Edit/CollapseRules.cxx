// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CollapseRules.h"

namespace bonedecimate
{
namespace
{
/// Whether any face has turned over from its initial normal. CheckFan limits the turn by a single
/// collapse only.
bool IsAnyTurnedOver(const HalfEdgeMesh& mesh, const EdgeNeighborhood& around, const Fan& fan)
{
  for (std::size_t i = 0; i < around.Corners.size(); ++i)
  {
    const Vector3 twice(fan.NewArea[0][i], fan.NewArea[1][i], fan.NewArea[2][i]); // mm^2
    if (mesh.IsTurnedOver(HalfEdgeMesh::Face(around.Corners[i]), 0.5 * twice))
    {
      return true;
    }
  }
  return false;
}
}

Rejection CheckEnds(const HalfEdgeMesh& mesh, HalfEdgeId edge)
{
  const VertexConstraint start = mesh.Constraint(mesh.Origin(edge));
  const VertexConstraint end = mesh.Constraint(mesh.Target(edge));
  if (start == VertexConstraint::NonManifold || end == VertexConstraint::NonManifold)
  {
    return Rejection::NonManifold;
  }
  if (IsConstrained(start) || IsConstrained(end))
  {
    return Rejection::Constrained;
  }
  const bool areStationary = IsStationary(start) && IsStationary(end);
  return areStationary || LeavesBoundary(start, end, mesh.Twin(edge) == None)
    ? Rejection::Boundary
    : Rejection::NotRejected;
}

//------------------------------------------------------------------------------
Rejection CheckTopology(const HalfEdgeMesh& mesh, const EdgeNeighborhood& around)
{
  const bool isEnvelope = !around.IsBoundaryEdge() && around.Apexes[0] == around.Apexes[1];
  if (around.Corners.empty() || isEnvelope)
  {
    return Rejection::Fragment; // a single triangle, or two glued together along all edges
  }
  // Two inner vertices with one remaining face each: both faces would become the same triangle,
  // back to back. This is a tetrahedron, on its own or attached to constrained corners.
  const bool bothInside = !mesh.IsOnBoundary(around.Start) && !mesh.IsOnBoundary(around.End);
  if (bothInside && around.Corners.size() <= 2)
  {
    return around.RingIsSimple() ? Rejection::Fragment : Rejection::LinkCondition;
  }
  return around.RingIsSimple() ? Rejection::NotRejected : Rejection::LinkCondition;
}

//------------------------------------------------------------------------------
void FillFan(const HalfEdgeMesh& mesh, const EdgeNeighborhood& around, Fan& fan)
{
  const Vector3& origin = mesh.Position(around.Start);
  const Vector3 end = mesh.Position(around.End) - origin;
  const int points = static_cast<int>(around.Ring.size());
  for (int k = 0; k < 3; ++k)
  {
    fan.End[k] = end[k];
  }
  for (std::size_t lane = 0; lane < 4; ++lane)
  {
    const Index which = static_cast<Index>(lane) % around.NumberOfRemovedFaces;
    const Vector3 apex = mesh.Position(around.Apexes[static_cast<std::size_t>(which)]) - origin;
    for (int k = 0; k < 3; ++k)
    {
      fan.Apexes[k][lane] = apex[k];
    }
  }
  double* const ring[3] = { fan.Ring[0], fan.Ring[1], fan.Ring[2] };
  const int faces = fan.Faces;
  for (int i = 0; i <= faces; ++i)
  {
    const Vector3& p = mesh.Position(around.Ring[static_cast<std::size_t>(i < points ? i : 0)]);
    ring[0][i] = p[0] - origin[0];
    ring[1][i] = p[1] - origin[1];
    ring[2][i] = p[2] - origin[2];
  }
  std::int64_t* const atEnd = fan.AtEnd;
  for (int i = 0; i < faces; ++i)
  {
    const VertexId corner = mesh.Origin(around.Corners[static_cast<std::size_t>(i)]);
    atEnd[i] = corner == around.End ? -1 : 0;
  }
}

//------------------------------------------------------------------------------
Rejection CheckPosition(
  const HalfEdgeMesh& mesh, const EdgeNeighborhood& around, Fan& fan, SurfaceChange& change)
{
  const Vector3& origin = mesh.Position(around.Start);
  for (int k = 0; k < 3; ++k)
  {
    fan.Position[k] = change.Requested.Position[k] - origin[k];
  }
  FanValidity found;
  BestKernels().CheckFan(fan, found);
  change.VolumeChange = found.VolumeChange;
  return found.Degenerate                              ? Rejection::Degenerate
    : found.Flip || IsAnyTurnedOver(mesh, around, fan) ? Rejection::Flip
                                                       : Rejection::NotRejected;
}
}
