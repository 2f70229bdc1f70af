// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatchBoundaries.h"

#include "Geometry/TriangleGeometry.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
using Ends = std::array<Index, 2>;

/// The neighbors along a patch boundary; None where the boundary ends.
Ends NeighborsOnBoundary(const HalfEdgeMesh& mesh, VertexId v)
{
  const Ends beside = BoundaryNeighbors(mesh, v);
  bool runs = mesh.NextDuplicate(v) != v && beside[0] != beside[1];
  for (VertexId copy = mesh.NextDuplicate(v); copy != v && runs; copy = mesh.NextDuplicate(copy))
  {
    runs = BoundaryNeighbors(mesh, copy) == beside;
  }
  return runs ? beside : Ends{ None, None };
}
}

std::array<Index, 2> BoundaryNeighbors(const HalfEdgeMesh& mesh, VertexId v)
{
  if (mesh.IsConstrained(v) || !mesh.IsOnBoundary(v))
  {
    return { None, None };
  }
  Index last = None;
  for (const HalfEdgeId h : mesh.OutgoingOf(v))
  {
    last = HalfEdgeMesh::Previous(h);
  }
  const VertexId before = mesh.OriginalVertex(mesh.Origin(last));
  const VertexId after = mesh.OriginalVertex(mesh.Target(mesh.Outgoing(v)));
  return { std::min(before, after), std::max(before, after) };
}

//------------------------------------------------------------------------------
bool IsInsidePatchBoundary(const HalfEdgeMesh& mesh, VertexId v)
{
  return NeighborsOnBoundary(mesh, v)[0] != None;
}

//------------------------------------------------------------------------------
PatchBoundaries::PatchBoundaries(const HalfEdgeMesh& mesh)
{
  const auto count = static_cast<std::size_t>(mesh.NumberOfVertexSlots());
  std::vector<Ends> beside(count, { None, None });
  std::vector<char> isOpen(count, 0); // an inner vertex of a curve that is not collected yet
  for (Index v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    beside[v] = mesh.OriginalVertex(v) == v ? NeighborsOnBoundary(mesh, v) : beside[v];
    isOpen[v] = beside[v][0] != None ? 1 : 0;
  }
  for (Index original = 0; original < mesh.NumberOfVertexSlots(); ++original)
  {
    if (isOpen[original] == 0)
    {
      continue;
    }
    Index first = beside[original][0]; // back to the start of the curve
    Index second = original;
    while (first != original && beside[first][0] != None)
    {
      const Index next = beside[first][0] == second ? beside[first][1] : beside[first][0];
      second = std::exchange(first, next);
    }
    this->AddCurve(first, second, isOpen, beside);
  }
  this->InitialEdges = this->Edges;
}

//------------------------------------------------------------------------------
void PatchBoundaries::AddCurve(
  Index first, Index second, std::vector<char>& isOpen, const std::vector<Ends>& beside)
{
  const Index begin = this->NumberOfPositions();
  this->OriginalVertices.push_back(first);
  isOpen[first] = 0; // of a closed curve; ends are not marked
  Index before = first;
  Index at = second;
  for (; isOpen[at] != 0; isOpen[before] = 0)
  {
    this->OriginalVertices.push_back(at);
    const Index next = beside[at][0] == before ? beside[at][1] : beside[at][0];
    before = std::exchange(at, next);
  }
  this->OriginalVertices.push_back(at);
  for (Index index = begin; index < this->NumberOfPositions(); ++index)
  {
    const bool isEnd = index == begin || index + 1 == this->NumberOfPositions();
    this->Neighbors.push_back(isEnd ? Ends{ None, None } : Ends{ index - 1, index + 1 });
  }
  this->Edges += this->NumberOfPositions() - begin - 1;
}

//------------------------------------------------------------------------------
double PatchBoundaries::Distance(
  const HalfEdgeMesh& mesh, Index original, const Ends& segment) const
{
  const Vector3& a = mesh.Position(segment[0]);
  const Vector3& b = mesh.Position(segment[1]);
  const Vector3& p = mesh.Position(original);
  return (a + NearestFraction(p, a, b) * (b - a) - p).norm();
}

//------------------------------------------------------------------------------
void PatchBoundaries::Remove(Index index)
{
  const Ends beside = this->Neighbors[index];
  this->Neighbors[index] = { None, None };
  if (this->Neighbors[beside[0]][1] != None)
  {
    this->Neighbors[beside[0]][1] = beside[1];
  }
  if (this->Neighbors[beside[1]][0] != None)
  {
    this->Neighbors[beside[1]][0] = beside[0];
  }
  --this->Edges;
}
}
