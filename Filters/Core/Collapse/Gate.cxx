// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Gate.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// Cosine of the most (78 degrees) by which a face may turn in one step; 90 would let it end on its
/// edge.
constexpr double LeastCosine = 0.2;
/// 4 sqrt(3) area / sum of squared edges, 1 for an equilateral triangle: below this, no better than
/// before.
constexpr double LeastQuality = 0.02;
constexpr double QualityOfEquilateral = 6.928203230275509; // 4 sqrt(3)

double Quality(double area, const Vector3& a, const Vector3& b, const Vector3& c)
{
  const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return squares > 0.0 ? QualityOfEquilateral * area / squares : 0.0;
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
    const FaceAreas::Face& before = areas[HalfEdgeMesh::Face(h)];
    const Vector3 after = AreaVector(edit.Position, second, third);
    const double area = after.norm();
    if (!(area > 0.0))
    {
      return Verdict::Degenerate;
    }
    if (before.Area > 0.0 && before.Normal.dot(after) < LeastCosine * area)
    {
      return Verdict::Flip;
    }
    const double quality = Quality(area, edit.Position, second, third);
    if (quality < LeastQuality && quality < Quality(before.Area, corner, second, third))
    {
      return Verdict::Degenerate;
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
