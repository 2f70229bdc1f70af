// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Gate.h"

namespace bonedecimate
{
namespace
{
/// One turn is short enough; together with those before it would be too many.
bool IsAnyTurnedOver(const HalfEdgeMesh& mesh, const Neighbourhood& around, const Fan& fan)
{
  for (std::size_t i = 0; i < around.Corners.size(); ++i)
  {
    const Vector3 area(fan.NewArea[0][i], fan.NewArea[1][i], fan.NewArea[2][i]);
    if (mesh.IsTurnedOver(HalfEdgeMesh::Face(around.Corners[i]), area))
    {
      return true;
    }
  }
  return false;
}
}

Verdict JudgeEnds(const HalfEdgeMesh& mesh, Index edge)
{
  const VertexKind start = mesh.Kind(mesh.Origin(edge));
  const VertexKind end = mesh.Kind(mesh.Target(edge));
  if (start == VertexKind::Locked || end == VertexKind::Locked)
  {
    return Verdict::NonManifold;
  }
  if (start == VertexKind::Frozen || end == VertexKind::Frozen)
  {
    return Verdict::Frozen;
  }
  const bool leavesBorder = start != VertexKind::Inside && end != VertexKind::Inside;
  const bool areBothPinned = mesh.IsPinned(mesh.Origin(edge)) && mesh.IsPinned(mesh.Target(edge));
  return areBothPinned || (leavesBorder && mesh.Twin(edge) != None) ? Verdict::Border
                                                                    : Verdict::Allowed;
}

//------------------------------------------------------------------------------
Verdict JudgeTopology(const HalfEdgeMesh& mesh, const Neighbourhood& around)
{
  const bool isEnvelope = !around.IsBorderEdge() && around.Apexes[0] == around.Apexes[1];
  if (around.Corners.empty() || isEnvelope)
  {
    return Verdict::Fragment; // a single triangle, or two glued together along all edges
  }
  // Two inside vertices with one staying face each: both faces would become the same triangle, back
  // to back. That is a tetrahedron, whether it stands alone or hangs on locked corners.
  const bool bothInside = !mesh.IsOnBorder(around.Start) && !mesh.IsOnBorder(around.End);
  if (bothInside && around.Corners.size() <= 2)
  {
    return around.RingIsSimple() ? Verdict::Fragment : Verdict::LinkCondition;
  }
  return around.RingIsSimple() ? Verdict::Allowed : Verdict::LinkCondition;
}

//------------------------------------------------------------------------------
void FillFan(const HalfEdgeMesh& mesh, const Neighbourhood& around, Fan& fan)
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
    const Index which = static_cast<Index>(lane) % around.NumberOfGoneFaces;
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
    const Index corner = mesh.Origin(around.Corners[static_cast<std::size_t>(i)]);
    atEnd[i] = corner == around.End ? -1 : 0;
  }
}

//------------------------------------------------------------------------------
Verdict JudgePlace(const HalfEdgeMesh& mesh, const Neighbourhood& around, const Edit& edit,
  Fan& fan, double& volumeChange)
{
  const Vector3& origin = mesh.Position(around.Start);
  for (int k = 0; k < 3; ++k)
  {
    fan.Place[k] = edit.Position[k] - origin[k];
  }
  FanVerdict found;
  BestKernels().JudgeFan(fan, found);
  volumeChange = found.VolumeChange;
  return found.Degenerate                              ? Verdict::Degenerate
    : found.Flip || IsAnyTurnedOver(mesh, around, fan) ? Verdict::Flip
                                                       : Verdict::Allowed;
}
}
