// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SeamLines.h"

#include "Geometry/TriangleGeometry.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
using Ends = std::array<Index, 2>;

/// The same of a seam: None where it does not run through.
Ends BesideOnSeam(const HalfEdgeMesh& mesh, Index v)
{
  const Ends beside = BesideOnBorder(mesh, v);
  bool runs = mesh.NextCopy(v) != v && beside[0] != beside[1];
  for (Index copy = mesh.NextCopy(v); copy != v && runs; copy = mesh.NextCopy(copy))
  {
    runs = BesideOnBorder(mesh, copy) == beside;
  }
  return runs ? beside : Ends{ None, None };
}
}

std::array<Index, 2> BesideOnBorder(const HalfEdgeMesh& mesh, Index v)
{
  if (mesh.IsFixed(v) || !mesh.IsOnBorder(v))
  {
    return { None, None };
  }
  Index last = None;
  for (const Index h : mesh.OutgoingOf(v))
  {
    last = HalfEdgeMesh::Previous(h);
  }
  const Index before = mesh.Site(mesh.Origin(last));
  const Index after = mesh.Site(mesh.Target(mesh.Outgoing(v)));
  return { std::min(before, after), std::max(before, after) };
}

//------------------------------------------------------------------------------
bool SeamRunsThrough(const HalfEdgeMesh& mesh, Index v)
{
  return BesideOnSeam(mesh, v)[0] != None;
}

//------------------------------------------------------------------------------
SeamLines::SeamLines(const HalfEdgeMesh& mesh)
{
  const auto count = static_cast<std::size_t>(mesh.NumberOfVertexSlots());
  std::vector<Ends> beside(count, { None, None });
  std::vector<char> isOpen(count, 0); // a seam runs through, and no line has it yet
  for (Index v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    beside[v] = mesh.Site(v) == v ? BesideOnSeam(mesh, v) : beside[v];
    isOpen[v] = beside[v][0] != None ? 1 : 0;
  }
  for (Index site = 0; site < mesh.NumberOfVertexSlots(); ++site)
  {
    if (isOpen[site] == 0)
    {
      continue;
    }
    Index first = beside[site][0]; // back to where the line begins
    Index second = site;
    while (first != site && beside[first][0] != None)
    {
      const Index next = beside[first][0] == second ? beside[first][1] : beside[first][0];
      second = std::exchange(first, next);
    }
    this->AddLine(first, second, isOpen, beside);
  }
  this->EdgesAtFirst = this->Edges;
}

//------------------------------------------------------------------------------
void SeamLines::AddLine(
  Index first, Index second, std::vector<char>& isOpen, const std::vector<Ends>& beside)
{
  const Index begin = this->NumberOfPlaces();
  this->Sites.push_back(first);
  isOpen[first] = 0; // of a ring; an end is none
  Index before = first;
  Index at = second;
  for (; isOpen[at] != 0; isOpen[before] = 0)
  {
    this->Sites.push_back(at);
    const Index next = beside[at][0] == before ? beside[at][1] : beside[at][0];
    before = std::exchange(at, next);
  }
  this->Sites.push_back(at);
  for (Index place = begin; place < this->NumberOfPlaces(); ++place)
  {
    const bool isEnd = place == begin || place + 1 == this->NumberOfPlaces();
    this->Neighbours.push_back(isEnd ? Ends{ None, None } : Ends{ place - 1, place + 1 });
  }
  this->Edges += this->NumberOfPlaces() - begin - 1;
}

//------------------------------------------------------------------------------
double SeamLines::Distance(const HalfEdgeMesh& mesh, Index site, const Ends& segment) const
{
  const Vector3& a = mesh.Position(segment[0]);
  const Vector3& b = mesh.Position(segment[1]);
  const Vector3& p = mesh.Position(site);
  return (a + NearestFraction(p, a, b) * (b - a) - p).norm();
}

//------------------------------------------------------------------------------
void SeamLines::Remove(Index place)
{
  const Ends beside = this->Neighbours[place];
  this->Neighbours[place] = { None, None };
  if (this->Neighbours[beside[0]][1] != None)
  {
    this->Neighbours[beside[0]][1] = beside[1];
  }
  if (this->Neighbours[beside[1]][0] != None)
  {
    this->Neighbours[beside[1]][0] = beside[0];
  }
  --this->Edges;
}
}
