// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Gate.h"

#include "TriangleShape.h"

namespace bonedecimate
{
Verdict JudgeEnds(const HalfEdgeMesh& mesh, Index edge)
{
  const VertexKind start = mesh.Kind(mesh.Origin(edge));
  const VertexKind end = mesh.Kind(mesh.Target(edge));
  if (start == VertexKind::Locked || end == VertexKind::Locked)
  {
    return Verdict::NonManifold;
  }
  const bool bothOnBorder = start == VertexKind::Border && end == VertexKind::Border;
  return bothOnBorder && mesh.Twin(edge) != None ? Verdict::Border : Verdict::Allowed;
}

Verdict JudgeTopology(const HalfEdgeMesh& mesh, const Neighbourhood& around)
{
  const bool isEnvelope = !around.IsBorderEdge() && around.Apexes[0] == around.Apexes[1];
  if (around.Corners.empty() || isEnvelope)
  {
    return Verdict::Fragment; // a single triangle, or two glued together along all edges
  }
  if (around.CommonNeighbours != around.NumberOfGoneFaces)
  {
    return Verdict::LinkCondition;
  }
  // Two inside vertices with one staying face each: both faces would become the same triangle, back
  // to back. That is a tetrahedron, whether it stands alone or hangs on locked corners.
  const bool bothInside =
    mesh.Kind(around.Start) == VertexKind::Inside && mesh.Kind(around.End) == VertexKind::Inside;
  if (bothInside && around.Corners.size() <= 2)
  {
    return Verdict::Fragment;
  }
  return Verdict::Allowed;
}

Verdict JudgePlace(
  const HalfEdgeMesh& mesh, const FaceAreas& areas, const Neighbourhood& around, const Edit& edit)
{
  for (const Index h : around.Corners)
  {
    const Vector3& corner = mesh.Position(mesh.Origin(h));
    const Vector3& second = mesh.Position(mesh.Target(h));
    const Vector3& third = mesh.Position(mesh.Origin(HalfEdgeMesh::Previous(h)));
    const Verdict verdict =
      JudgeCorner(areas[HalfEdgeMesh::Face(h)], corner, edit.Position, second, third);
    if (verdict != Verdict::Allowed)
    {
      return verdict;
    }
  }
  return Verdict::Allowed;
}

double VolumeChange(const HalfEdgeMesh& mesh, const Neighbourhood& around, const Edit& edit)
{
  // Measured from Start: the cones of faces at Start have no volume, those of gone faces neither.
  const Vector3& from = mesh.Position(around.Start);
  double change = 0.0;
  for (const Index h : around.Corners)
  {
    const Vector3& corner = mesh.Position(mesh.Origin(h));
    const Vector3& second = mesh.Position(mesh.Target(h));
    const Vector3& third = mesh.Position(mesh.Origin(HalfEdgeMesh::Previous(h)));
    change += AreaVector(edit.Position, second, third).dot(second - from);
    change -= AreaVector(corner, second, third).dot(second - from);
  }
  return change / 3.0;
}
}
