// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceChange.h"

#include <algorithm>

namespace bonedecimate
{
void SurfaceChange::Fill(const HalfEdgeMesh& mesh, const EdgeNeighborhood& around)
{
  const Edit& edit = this->Requested;
  this->OldFaces.clear();
  this->NewFaces.clear();
  this->OldBoundary.clear();
  this->NewBoundary.clear();
  this->BoundaryStays = false;
  this->MovedVertex = edit.Kind == EditKind::Flip ? VertexId() : edit.Keep;
  switch (edit.Kind)
  {
    case EditKind::Collapse:
      this->Ends = { around.Start, around.End };
      this->AddCollapse(mesh, around, edit);
      break;
    case EditKind::Flip:
      this->FillFlip(mesh);
      break;
    case EditKind::Move:
      this->FillMove(mesh);
      break;
    case EditKind::Split:
      this->FillSplit(mesh);
      break;
  }
}

//------------------------------------------------------------------------------
/// Adds an old face, and its boundary edges at one of the two vertices.
void SurfaceChange::AddOld(const HalfEdgeMesh& mesh, FaceId face, Index at, Index orAt)
{
  this->OldFaces.push_back(face);
  for (Index corner = 0; corner < 3; ++corner)
  {
    const HalfEdgeId h = HalfEdgeMesh::HalfEdge(face, corner);
    const VertexId from = mesh.Origin(h);
    const VertexId to = mesh.Target(h);
    if (mesh.Twin(h) == None && (from == at || from == orAt || to == at || to == orAt))
    {
      this->OldBoundary.push_back(h);
    }
  }
}

//------------------------------------------------------------------------------
void SurfaceChange::AddCollapse(
  const HalfEdgeMesh& mesh, const EdgeNeighborhood& around, const Edit& edit)
{
  const std::size_t count = around.Corners.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const FaceId face = HalfEdgeMesh::Face(around.Corners[i]);
    const Index second = around.Ring[i];
    const Index third = around.Ring[(i + 1) % around.Ring.size()];
    this->AddOld(mesh, face, around.Start, around.End);
    this->NewFaces.push_back({ face, { edit.Keep, second, third },
      { edit.Position, mesh.Position(second), mesh.Position(third) } });
  }
  for (Index i = 0; i < around.NumberOfRemovedFaces; ++i)
  {
    this->AddOld(mesh, around.RemovedFaces[i], around.Start, around.End);
  }
  if (around.IsOpen)
  {
    this->AddBoundary(mesh, around, edit);
  }
}

//------------------------------------------------------------------------------
void SurfaceChange::TakeNewFaces(const HalfEdgeMesh& after)
{
  this->NewFaces.clear();
  for (const FaceId face : this->OldFaces)
  {
    if (after.IsAlive(face))
    {
      this->NewFaces.push_back({ face, after.Corners(face), PositionsOf(after, face) });
    }
  }
}

//------------------------------------------------------------------------------
/// Several curves may meet in a stationary vertex. There, an edge replaces only an edge of its own
/// curve.
void SurfaceChange::AddBoundary(
  const HalfEdgeMesh& mesh, const EdgeNeighborhood& around, const Edit& edit)
{
  const bool keepIsStationary = mesh.IsStationary(edit.Keep);
  const VertexId gone = edit.Keep == around.Start ? around.End : around.Start;
  const auto curveVertex = [&](VertexId v) {
    return !mesh.IsStationary(v) ? v : keepIsStationary ? gone : edit.Keep;
  };
  this->BoundaryStays = keepIsStationary && !around.IsBoundaryEdge();
  std::array<BoundaryEdge, 2> edges;
  edges[0] = { around.Corners.front(), { edit.Keep, around.Ring.front() },
    { edit.Position, mesh.Position(around.Ring.front()) } };
  edges[1] = { HalfEdgeMesh::Previous(around.Corners.back()), { around.Ring.back(), edit.Keep },
    { mesh.Position(around.Ring.back()), edit.Position } };
  for (std::size_t i = 0; i < 2; ++i)
  {
    BoundaryEdge& edge = edges[i];
    edge.CurveVertices = { curveVertex(edge.Vertices[0]), curveVertex(edge.Vertices[1]) };
    const auto old = std::find_if(this->OldBoundary.begin(), this->OldBoundary.end(),
      [&](HalfEdgeId h) {
        return i == 0 ? mesh.Target(h) == around.Ring.front()
                      : mesh.Origin(h) == around.Ring.back();
      });
    if (this->BoundaryStays)
    {
      edge.Replaces = *old;
    }
    if (keepIsStationary && !this->BoundaryStays && around.BoundaryEnds[i] == edit.Keep)
    {
      this->OldBoundary.erase(old); // belongs to another curve
    }
    else
    {
      this->NewBoundary.push_back(edge);
    }
  }
}

//------------------------------------------------------------------------------
void SurfaceChange::FillMove(const HalfEdgeMesh& mesh)
{
  const Edit& edit = this->Requested;
  this->Ends = { edit.Keep, edit.Keep };
  for (const HalfEdgeId h : mesh.OutgoingOf(edit.Keep))
  {
    const FaceId face = HalfEdgeMesh::Face(h);
    const VertexId second = mesh.Target(h);
    const VertexId third = mesh.Apex(h);
    this->AddOld(mesh, face, edit.Keep, edit.Keep);
    this->NewFaces.push_back({ face, { edit.Keep, second, third },
      { edit.Position, mesh.Position(second), mesh.Position(third) } });
  }
  for (const HalfEdgeId h : this->OldBoundary)
  {
    const VertexId from = mesh.Origin(h);
    const VertexId to = mesh.Target(h);
    const auto curveVertex = [&](VertexId v) { return mesh.IsStationary(v) ? edit.Keep : v; };
    const auto position = [&](VertexId v)
    { return v == edit.Keep ? edit.Position : mesh.Position(v); };
    this->NewBoundary.push_back({ h, { from, to }, { position(from), position(to) }, None,
      { curveVertex(from), curveVertex(to) } });
  }
}

//------------------------------------------------------------------------------
void SurfaceChange::FillFlip(const HalfEdgeMesh& mesh)
{
  const HalfEdgeId h = this->Requested.Edge;
  const HalfEdgeId twin = mesh.Twin(h);
  const VertexId a = mesh.Origin(h);
  const VertexId b = mesh.Origin(twin);
  const VertexId c = mesh.Apex(h);
  const VertexId d = mesh.Apex(twin);
  this->Ends = { a, b };
  this->AddOld(mesh, HalfEdgeMesh::Face(h), a, b);
  this->AddOld(mesh, HalfEdgeMesh::Face(twin), a, b);
  const auto add = [&](FaceId face, const Triangle& v)
  {
    this->NewFaces.push_back(
      { face, v, { mesh.Position(v[0]), mesh.Position(v[1]), mesh.Position(v[2]) } });
  };
  add(HalfEdgeMesh::Face(h), { d, c, a });
  add(HalfEdgeMesh::Face(twin), { c, d, b });
  this->BoundaryStays = true;
  this->MoveBoundary(mesh, HalfEdgeMesh::Next(h), HalfEdgeMesh::Previous(twin));
  this->MoveBoundary(mesh, HalfEdgeMesh::Previous(h), HalfEdgeMesh::Next(h));
  this->MoveBoundary(mesh, HalfEdgeMesh::Next(twin), HalfEdgeMesh::Previous(h));
  this->MoveBoundary(mesh, HalfEdgeMesh::Previous(twin), HalfEdgeMesh::Next(twin));
}

//------------------------------------------------------------------------------
/// The boundary edge keeps its position and gets another half-edge.
void SurfaceChange::MoveBoundary(const HalfEdgeMesh& mesh, HalfEdgeId from, HalfEdgeId to)
{
  if (mesh.Twin(from) == None)
  {
    const std::array<VertexId, 2> v = { mesh.Origin(from), mesh.Target(from) };
    this->NewBoundary.push_back({ to, v, { mesh.Position(v[0]), mesh.Position(v[1]) }, from, v });
  }
}

//------------------------------------------------------------------------------
/// Must agree with HalfEdgeMesh::SplitFace.
void SurfaceChange::SplitFace(
  const HalfEdgeMesh& mesh, HalfEdgeId edge, VertexId vertex, FaceId made)
{
  const HalfEdgeId next = HalfEdgeMesh::Next(edge);
  const HalfEdgeId previous = HalfEdgeMesh::Previous(edge);
  const FaceId face = HalfEdgeMesh::Face(edge);
  const VertexId a = mesh.Origin(edge);
  const VertexId b = mesh.Origin(next);
  const VertexId c = mesh.Origin(previous);
  this->AddOld(mesh, face, a, b);
  this->NewFaces.push_back(
    { face, { a, vertex, c }, { mesh.Position(a), this->Requested.Position, mesh.Position(c) } });
  this->NewFaces.push_back({ made, { vertex, b, c },
    { this->Requested.Position, mesh.Position(b), mesh.Position(c) }, face });
  this->MoveBoundary(mesh, next, HalfEdgeMesh::HalfEdge(made, 1));
  this->MoveBoundary(mesh, previous, previous);
}

//------------------------------------------------------------------------------
/// A boundary edge has one face to split.
void SurfaceChange::FillSplit(const HalfEdgeMesh& mesh)
{
  const Edit& edit = this->Requested;
  const HalfEdgeId h = edit.Edge;
  const HalfEdgeId twin = mesh.Twin(h);
  const VertexId a = mesh.Origin(h);
  const VertexId b = mesh.Target(h);
  this->Ends = { a, b };
  this->SplitFace(mesh, h, edit.Keep, edit.Made[0]);
  this->BoundaryStays = twin != None;
  if (twin != None)
  {
    this->SplitFace(mesh, twin, edit.Keep, edit.Made[1]);
    return;
  }
  const VertexId curveVertex = mesh.IsStationary(a) ? b : a; // at most one of them is stationary
  const VertexId other = mesh.IsStationary(b) ? a : b;
  this->NewBoundary.push_back({ h, { a, edit.Keep }, { mesh.Position(a), this->Requested.Position },
    None, { curveVertex, curveVertex } });
  this->NewBoundary.push_back({ HalfEdgeMesh::HalfEdge(edit.Made[0], 0), { edit.Keep, b },
    { this->Requested.Position, mesh.Position(b) }, None, { other, other } });
}
}
