// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HalfEdgeMesh.h"

#include "EdgeGroups.h"
#include "Neighbourhood.h"

#include <cmath>

namespace bonedecimate
{
namespace
{
/// The power of two nearest below the mean edge length, mm; 1 if there is no length.
double UnitOf(const Surface& surface)
{
  double sum = 0.0; // mm
  for (const Triangle& c : surface.Triangles)
  {
    sum += (surface.Points[c[1]] - surface.Points[c[0]]).norm();
  }
  const double mean = sum / static_cast<double>(surface.Triangles.size());
  return mean > 0.0 && std::isfinite(mean) ? std::ldexp(1.0, std::ilogb(mean)) : 1.0;
}
}

HalfEdgeMesh::HalfEdgeMesh(const Surface& surface)
  : Vertices(surface.Points.size())
  , Faces(surface.Triangles.size())
  , Kinds(surface.Points.size(), VertexKind::Inside)
  , LiveFaces(static_cast<Index>(surface.Triangles.size()))
  , LengthUnit(UnitOf(surface))
{
  for (std::size_t v = 0; v < this->Vertices.size(); ++v)
  {
    this->Vertices[v].Position = surface.Points[v];
  }
  for (std::size_t f = 0; f < this->Faces.size(); ++f)
  {
    const Triangle& c = surface.Triangles[f];
    this->Faces[f].Origins = { c[0], c[1], c[2], None };
  }
  this->MatchEdges(surface);
  this->FindRings();
}

//------------------------------------------------------------------------------
void HalfEdgeMesh::MatchEdges(const Surface& surface)
{
  const auto worst = [this](Index v, VertexKind kind)
  { this->Kinds[v] = std::max(this->Kinds[v], kind); };
  const auto idOf = [](Index h) { return HalfEdge(h / 3, h % 3); };
  VisitEdgeGroups(surface.Triangles, surface.Points.size(),
    [&](const Index* first, const Index* last)
    {
      const Index h = idOf(first[0]);
      const Index second = idOf(last[-1]);
      if (last - first == 2 && this->Origin(h) == this->Target(second))
      {
        this->Faces[Face(h)].Twins[h & 3] = second;
        this->Faces[Face(second)].Twins[second & 3] = h;
        return;
      }
      const VertexKind kind = last - first == 1 ? VertexKind::Border : VertexKind::Locked;
      worst(this->Origin(h), kind);
      worst(this->Target(h), kind);
    });
}

//------------------------------------------------------------------------------
void HalfEdgeMesh::FindRings()
{
  std::vector<Index> numberOfFaces(this->Vertices.size(), 0);
  for (Index face = 0; face < this->NumberOfFaceSlots(); ++face)
  {
    for (Index h = HalfEdge(face, 0); h < HalfEdge(face, 3); ++h)
    {
      const Index v = this->Origin(h);
      ++numberOfFaces[v];
      if (this->Outgoing(v) == None || this->Twin(h) == None)
      {
        this->Vertices[v].Outgoing = h;
      }
    }
  }
  for (Index v = 0; v < this->NumberOfVertexSlots(); ++v)
  {
    Index found = 0; // rings end or come back to their start, since twins are paired one to one
    for (const Index h : this->OutgoingOf(v))
    {
      found += this->Origin(h) == v ? 1 : 0;
    }
    if (found != numberOfFaces[v])
    {
      this->Kinds[v] = VertexKind::Locked;
    }
  }
}

//------------------------------------------------------------------------------
void HalfEdgeMesh::Collapse(const Neighbourhood& around, Index keep, const Vector3& position)
{
  const Index gone = around.Start == keep ? around.End : around.Start;
  for (const Index out : around.Corners)
  {
    this->Faces[Face(out)].Origins[out & 3] = keep;
  }
  const Index twin = this->Twin(around.Edge);
  this->RemoveFace(around.Edge);
  if (twin != None)
  {
    this->RemoveFace(twin);
  }
  this->Vertices[gone].Outgoing = None;
  this->Vertices[keep].Outgoing = around.Corners.front(); // on a border the one without a twin
  this->Kinds[keep] = std::max(this->Kinds[keep], this->Kinds[gone]);
  this->Vertices[keep].Position = position;
}

//------------------------------------------------------------------------------
/// Takes out the face of h, whose other two edges become one.
void HalfEdgeMesh::RemoveFace(Index h)
{
  const Index alongNext = this->Twin(Next(h));
  const Index alongPrevious = this->Twin(Previous(h));
  if (alongNext != None)
  {
    this->Faces[Face(alongNext)].Twins[alongNext & 3] = alongPrevious;
  }
  if (alongPrevious != None)
  {
    this->Faces[Face(alongPrevious)].Twins[alongPrevious & 3] = alongNext;
  }
  const Index apex = this->Origin(Previous(h));
  if (this->Outgoing(apex) == Previous(h))
  {
    this->Vertices[apex].Outgoing = alongNext;
  }
  this->Faces[Face(h)] = FaceRecord();
}
}
