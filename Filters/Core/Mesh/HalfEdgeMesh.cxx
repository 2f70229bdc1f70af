// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HalfEdgeMesh.h"

#include "EdgeGroups.h"

#include <array>

namespace bonedecimate
{
HalfEdgeMesh::HalfEdgeMesh(const Surface& surface)
  : Positions(surface.Points)
  , Twins(3 * surface.Triangles.size(), None)
  , Outgoings(surface.Points.size(), None)
  , Kinds(surface.Points.size(), VertexKind::Inside)
  , LiveFaces(static_cast<Index>(surface.Triangles.size()))
{
  this->Origins.reserve(3 * surface.Triangles.size());
  for (const Triangle& corners : surface.Triangles)
  {
    this->Origins.insert(this->Origins.end(), corners.begin(), corners.end());
  }
  this->MatchEdges(surface);
  this->FindRings();
}

//------------------------------------------------------------------------------
void HalfEdgeMesh::MatchEdges(const Surface& surface)
{
  const auto worst = [this](Index v, VertexKind kind)
  { this->Kinds[v] = std::max(this->Kinds[v], kind); };
  VisitEdgeGroups(surface.Triangles, surface.Points.size(),
    [&](const Index* first, const Index* last)
    {
      const bool isPair = last - first == 2 && this->Origin(first[0]) == this->Target(first[1]);
      if (isPair)
      {
        this->Twins[first[0]] = first[1];
        this->Twins[first[1]] = first[0];
        return;
      }
      const VertexKind kind = last - first == 1 ? VertexKind::Border : VertexKind::Locked;
      worst(this->Origin(*first), kind);
      worst(this->Target(*first), kind);
    });
}

//------------------------------------------------------------------------------
void HalfEdgeMesh::FindRings()
{
  std::vector<Index> numberOfFaces(this->Positions.size(), 0);
  for (Index h = 0; h < static_cast<Index>(this->Origins.size()); ++h)
  {
    const Index v = this->Origin(h);
    ++numberOfFaces[v];
    if (this->Outgoings[v] == None || this->Twins[h] == None)
    {
      this->Outgoings[v] = h;
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
void HalfEdgeMesh::Collapse(Index h, Index keep, const Vector3& position)
{
  const Index gone = this->Across(h, keep);
  const Index twin = this->Twin(h);
  for (const Index out : this->OutgoingOf(gone))
  {
    this->Origins[out] = keep;
  }
  Index start = this->LiveOutgoing(h);
  start = start == None && twin != None ? this->LiveOutgoing(twin) : start;
  this->RemoveFace(h);
  if (twin != None)
  {
    this->RemoveFace(twin);
  }
  this->Outgoings[gone] = None;
  this->Outgoings[keep] = start;
  this->Kinds[keep] = std::max(this->Kinds[keep], this->Kinds[gone]);
  this->Positions[keep] = position;
  this->TurnToBorder(keep);
}

//------------------------------------------------------------------------------
void HalfEdgeMesh::Pair(Index h, Index twin)
{
  this->Twins[h] = twin;
  if (twin != None)
  {
    this->Twins[twin] = h;
  }
}

//------------------------------------------------------------------------------
/// Faces a b c and b a d become a d c and b c d, each in its old slot.
void HalfEdgeMesh::Flip(Index h)
{
  const Index t = this->Twin(h);
  const std::array<Index, 3> f = { h, Next(h), Previous(h) };
  const std::array<Index, 3> g = { t, Next(t), Previous(t) };
  const std::array<Index, 4> outer = { this->Twin(f[1]), this->Twin(f[2]), this->Twin(g[1]),
    this->Twin(g[2]) }; // across b c, c a, a d, d b
  const Index a = this->Origin(h);
  const Index b = this->Origin(t);
  const Index c = this->Origin(f[2]);
  const Index d = this->Origin(g[2]);
  const auto turn = [this](Index v, Index from, Index other, Index to)
  {
    Index& outgoing = this->Outgoings[v];
    outgoing = outgoing == from || outgoing == other ? to : outgoing;
  };
  turn(a, h, g[1], f[2]);
  turn(b, t, f[1], g[2]);
  turn(c, f[2], None, f[1]);
  turn(d, g[2], None, g[1]);
  this->Origins[f[0]] = d;
  this->Origins[f[1]] = c;
  this->Origins[f[2]] = a;
  this->Origins[g[0]] = c;
  this->Origins[g[1]] = d;
  this->Origins[g[2]] = b;
  this->Pair(f[1], outer[1]);
  this->Pair(f[2], outer[2]);
  this->Pair(g[1], outer[3]);
  this->Pair(g[2], outer[0]);
}

//------------------------------------------------------------------------------
/// A half-edge that leaves the merged vertex and survives the removal of h's face; None if the face ends there.
Index HalfEdgeMesh::LiveOutgoing(Index h) const
{
  const Index alongPrevious = this->Twin(Previous(h));
  const Index alongNext = this->Twin(Next(h));
  return alongPrevious != None ? alongPrevious : alongNext == None ? None : Next(alongNext);
}

//------------------------------------------------------------------------------
/// Takes out the face of h, whose other two edges become one.
void HalfEdgeMesh::RemoveFace(Index h)
{
  const Index alongNext = this->Twin(Next(h));
  const Index alongPrevious = this->Twin(Previous(h));
  if (alongNext != None)
  {
    this->Twins[alongNext] = alongPrevious;
  }
  if (alongPrevious != None)
  {
    this->Twins[alongPrevious] = alongNext;
  }
  const Index apex = this->Origin(Previous(h));
  if (this->Outgoings[apex] == Previous(h))
  {
    this->Outgoings[apex] = alongNext;
  }
  const Index face = Face(h);
  for (Index k = 3 * face; k < 3 * face + 3; ++k)
  {
    this->Origins[k] = None;
    this->Twins[k] = None;
  }
  --this->LiveFaces;
}

//------------------------------------------------------------------------------
/// Turns Outgoing(v) clockwise until it has no twin or the ring is round.
void HalfEdgeMesh::TurnToBorder(Index v)
{
  const Index start = this->Outgoings[v];
  Index at = start;
  while (this->Twin(at) != None)
  {
    at = Next(this->Twin(at));
    if (at == start)
    {
      return;
    }
  }
  this->Outgoings[v] = at;
}
}
