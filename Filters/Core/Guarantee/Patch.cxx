// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Patch.h"

#include <algorithm>

namespace bonedecimate
{
void Patch::Clear()
{
  this->OldFaces.clear();
  this->NewFaces.clear();
  this->OldBorder.clear();
  this->NewBorder.clear();
  this->BorderStays = false;
  this->Moved = None;
}

//------------------------------------------------------------------------------
/// With its border edges at one of the two vertices.
void Patch::AddOld(const HalfEdgeMesh& mesh, Index face, Index at, Index orAt)
{
  this->OldFaces.push_back(face);
  for (Index corner = 0; corner < 3; ++corner)
  {
    const Index h = HalfEdgeMesh::HalfEdge(face, corner);
    const Index from = mesh.Origin(h);
    const Index to = mesh.Target(h);
    if (mesh.Twin(h) == None && (from == at || from == orAt || to == at || to == orAt))
    {
      this->OldBorder.push_back(h);
    }
  }
}

//------------------------------------------------------------------------------
void Patch::FillCollapse(const HalfEdgeMesh& mesh, const Neighbourhood& around, const Edit& edit)
{
  this->Clear();
  this->Ends = { around.Start, around.End };
  this->Moved = edit.Keep;
  this->Position = edit.Position;
  this->AddCollapse(mesh, around, edit);
}

//------------------------------------------------------------------------------
void Patch::AddCollapse(const HalfEdgeMesh& mesh, const Neighbourhood& around, const Edit& edit)
{
  const std::size_t count = around.Corners.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const Index face = HalfEdgeMesh::Face(around.Corners[i]);
    const Index second = around.Ring[i];
    const Index third = around.Ring[(i + 1) % around.Ring.size()];
    this->AddOld(mesh, face, around.Start, around.End);
    this->NewFaces.push_back({ face, { edit.Keep, second, third },
      { edit.Position, mesh.Position(second), mesh.Position(third) } });
  }
  for (Index i = 0; i < around.NumberOfGoneFaces; ++i)
  {
    this->AddOld(mesh, around.GoneFaces[i], around.Start, around.End);
  }
  if (around.IsOpen)
  {
    this->AddBorder(mesh, around, edit);
  }
}

//------------------------------------------------------------------------------
/// Different lines may meet in a pinned vertex: there only edges of one line may take each other's place.
void Patch::AddBorder(const HalfEdgeMesh& mesh, const Neighbourhood& around, const Edit& edit)
{
  const bool isPinned = mesh.IsPinned(edit.Keep);
  const Index gone = edit.Keep == around.Start ? around.End : around.Start;
  const auto onLine = [&](Index v) { return !mesh.IsPinned(v) ? v : isPinned ? gone : edit.Keep; };
  this->BorderStays = isPinned && !around.IsBorderEdge();
  std::array<BorderEdge, 2> edges;
  edges[0] = { around.Corners.front(), { edit.Keep, around.Ring.front() },
    { edit.Position, mesh.Position(around.Ring.front()) } };
  edges[1] = { HalfEdgeMesh::Previous(around.Corners.back()), { around.Ring.back(), edit.Keep },
    { mesh.Position(around.Ring.back()), edit.Position } };
  for (std::size_t i = 0; i < 2; ++i)
  {
    BorderEdge& edge = edges[i];
    edge.OnLine = { onLine(edge.Vertices[0]), onLine(edge.Vertices[1]) };
    const auto old = std::find_if(this->OldBorder.begin(), this->OldBorder.end(),
      [&](Index h) {
        return i == 0 ? mesh.Target(h) == around.Ring.front()
                      : mesh.Origin(h) == around.Ring.back();
      });
    if (this->BorderStays)
    {
      edge.Replaces = *old;
    }
    if (isPinned && !this->BorderStays && around.BorderEnds[i] == edit.Keep)
    {
      this->OldBorder.erase(old); // that of the pinned vertex's other line
    }
    else
    {
      this->NewBorder.push_back(edge);
    }
  }
}

//------------------------------------------------------------------------------
void Patch::FillMove(const HalfEdgeMesh& mesh, const Edit& edit)
{
  this->Clear();
  this->Ends = { edit.Keep, edit.Keep };
  this->Moved = edit.Keep;
  this->Position = edit.Position;
  for (const Index h : mesh.OutgoingOf(edit.Keep))
  {
    const Index face = HalfEdgeMesh::Face(h);
    const Index second = mesh.Target(h);
    const Index third = mesh.Origin(HalfEdgeMesh::Previous(h));
    this->AddOld(mesh, face, edit.Keep, edit.Keep);
    this->NewFaces.push_back({ face, { edit.Keep, second, third },
      { edit.Position, mesh.Position(second), mesh.Position(third) } });
  }
  for (const Index h : this->OldBorder)
  {
    const Index from = mesh.Origin(h);
    const Index to = mesh.Target(h);
    const auto onLine = [&](Index v) { return mesh.IsPinned(v) ? edit.Keep : v; };
    const auto position = [&](Index v)
    { return v == edit.Keep ? edit.Position : mesh.Position(v); };
    this->NewBorder.push_back(
      { h, { from, to }, { position(from), position(to) }, None, { onLine(from), onLine(to) } });
  }
}

//------------------------------------------------------------------------------
void Patch::FillFlip(const HalfEdgeMesh& mesh, const Edit& edit)
{
  this->Clear();
  const Index h = edit.Edge;
  const Index twin = mesh.Twin(h);
  const Index a = mesh.Origin(h);
  const Index b = mesh.Origin(twin);
  const Index c = mesh.Origin(HalfEdgeMesh::Previous(h));
  const Index d = mesh.Origin(HalfEdgeMesh::Previous(twin));
  this->Ends = { a, b };
  this->AddOld(mesh, HalfEdgeMesh::Face(h), a, b);
  this->AddOld(mesh, HalfEdgeMesh::Face(twin), a, b);
  const auto add = [&](Index face, const Triangle& v)
  {
    this->NewFaces.push_back(
      { face, v, { mesh.Position(v[0]), mesh.Position(v[1]), mesh.Position(v[2]) } });
  };
  add(HalfEdgeMesh::Face(h), { d, c, a });
  add(HalfEdgeMesh::Face(twin), { c, d, b });
  this->BorderStays = true;
  const auto moveBorder = [&](Index from, Index to)
  {
    if (mesh.Twin(from) == None)
    {
      const std::array<Index, 2> v = { mesh.Origin(from), mesh.Target(from) };
      this->NewBorder.push_back({ to, v, { mesh.Position(v[0]), mesh.Position(v[1]) }, from, v });
    }
  };
  moveBorder(HalfEdgeMesh::Next(h), HalfEdgeMesh::Previous(twin));
  moveBorder(HalfEdgeMesh::Previous(h), HalfEdgeMesh::Next(h));
  moveBorder(HalfEdgeMesh::Next(twin), HalfEdgeMesh::Previous(h));
  moveBorder(HalfEdgeMesh::Previous(twin), HalfEdgeMesh::Next(twin));
}
}
