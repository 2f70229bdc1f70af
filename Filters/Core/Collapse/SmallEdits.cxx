// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SmallEdits.h"

#include "TriangleShape.h"

#include <algorithm>

namespace bonedecimate
{
std::array<Index, 4> CornersAround(const HalfEdgeMesh& mesh, Index edge)
{
  const Index twin = mesh.Twin(edge);
  return { mesh.Origin(edge), mesh.Origin(twin), mesh.Origin(HalfEdgeMesh::Previous(edge)),
    mesh.Origin(HalfEdgeMesh::Previous(twin)) };
}

//------------------------------------------------------------------------------
Verdict JudgeFlipTopology(const HalfEdgeMesh& mesh, Index edge)
{
  if (mesh.Twin(edge) == None)
  {
    return Verdict::Border;
  }
  const std::array<Index, 4> corners = CornersAround(mesh, edge);
  for (const Index v : corners)
  {
    if (mesh.Kind(v) == VertexKind::Locked)
    {
      return Verdict::NonManifold;
    }
  }
  bool joined = corners[2] == corners[3];
  mesh.VisitEdges(corners[2],
    [&](Index h) { joined = joined || mesh.Across(h, corners[2]) == corners[3]; });
  return joined ? Verdict::LinkCondition : Verdict::Allowed;
}

//------------------------------------------------------------------------------
Verdict JudgeFlipPlace(const HalfEdgeMesh& mesh, const FaceAreas& areas, Index edge)
{
  const std::array<Index, 4> corners = CornersAround(mesh, edge);
  std::array<const Vector3*, 4> p{};
  std::transform(
    corners.begin(), corners.end(), p.begin(), [&](Index v) { return &mesh.Position(v); });
  const FaceAreas::Face& first = areas[HalfEdgeMesh::Face(edge)];
  const FaceAreas::Face& second = areas[HalfEdgeMesh::Face(mesh.Twin(edge))];
  const double worst = std::min(
    ShapeQuality(first.Area, *p[0], *p[1], *p[2]), ShapeQuality(second.Area, *p[0], *p[1], *p[3]));
  for (const std::array<std::size_t, 3>& face :
    { std::array<std::size_t, 3>{ 0, 3, 2 }, std::array<std::size_t, 3>{ 1, 2, 3 } })
  {
    const Vector3 after = AreaVector(*p[face[0]], *p[face[1]], *p[face[2]]);
    const double area = after.norm();
    if (!(area > 0.0))
    {
      return Verdict::Degenerate;
    }
    if (IsTurned(first, after, area) || IsTurned(second, after, area))
    {
      return Verdict::Flip;
    }
    const double quality = ShapeQuality(area, *p[face[0]], *p[face[1]], *p[face[2]]);
    if (quality < LeastShapeQuality && quality < worst)
    {
      return Verdict::Degenerate;
    }
  }
  return Verdict::Allowed;
}

//------------------------------------------------------------------------------
double FlipVolumeChange(const HalfEdgeMesh& mesh, Index edge)
{
  const std::array<Index, 4> corners = CornersAround(mesh, edge);
  const Vector3& a = mesh.Position(corners[0]);
  const Vector3 c = mesh.Position(corners[2]) - a;
  const Vector3 d = mesh.Position(corners[3]) - a;
  return (mesh.Position(corners[1]) - a).dot(c.cross(d)) / 6.0;
}

//------------------------------------------------------------------------------
Verdict JudgeMove(
  const HalfEdgeMesh& mesh, const FaceAreas& areas, Index vertex, const Vector3& position)
{
  if (mesh.Kind(vertex) != VertexKind::Inside)
  {
    return mesh.Kind(vertex) == VertexKind::Border ? Verdict::Border : Verdict::NonManifold;
  }
  for (const Index h : mesh.OutgoingOf(vertex))
  {
    const Vector3& second = mesh.Position(mesh.Target(h));
    const Vector3& third = mesh.Position(mesh.Origin(HalfEdgeMesh::Previous(h)));
    const Verdict verdict = JudgeCorner(
      areas[HalfEdgeMesh::Face(h)], mesh.Position(vertex), position, second, third);
    if (verdict != Verdict::Allowed)
    {
      return verdict;
    }
  }
  return Verdict::Allowed;
}

//------------------------------------------------------------------------------
double MoveVolumeChange(
  const HalfEdgeMesh& mesh, const FaceAreas& areas, Index vertex, const Vector3& position)
{
  Vector3 sum = Vector3::Zero();
  for (const Index h : mesh.OutgoingOf(vertex))
  {
    const FaceAreas::Face& face = areas[HalfEdgeMesh::Face(h)];
    sum += face.Area * face.Normal;
  }
  return sum.dot(position - mesh.Position(vertex)) / 3.0;
}
}
