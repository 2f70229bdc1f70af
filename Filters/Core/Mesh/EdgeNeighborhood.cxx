// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeNeighborhood.h"

#include "Base/Prefetch.h"
#include "Edit.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// Prefetches faces around the end of the edge while the ring of the start is traversed.
void FetchFacesOfEnd(const HalfEdgeMesh& mesh, HalfEdgeId edge, HalfEdgeId twin)
{
  constexpr int steps = 2;
  HalfEdgeId left = mesh.Twin(HalfEdgeMesh::Next(edge));
  HalfEdgeId right = twin == None ? HalfEdgeId() : mesh.Twin(HalfEdgeMesh::Previous(twin));
  for (int i = 0; i < steps && left != None && right != None; ++i)
  {
    left = mesh.Twin(HalfEdgeMesh::Next(left));
    right = mesh.Twin(HalfEdgeMesh::Previous(right));
  }
  Prefetch(mesh.RecordOfFace(left == None ? HalfEdgeId(0) : left));
  Prefetch(mesh.RecordOfFace(right == None ? HalfEdgeId(0) : right));
}
}

bool EdgeNeighborhood::Gather(const HalfEdgeMesh& mesh, HalfEdgeId edge)
{
  const HalfEdgeId twin = mesh.Twin(edge);
  this->Edge = edge;
  this->Start = mesh.Origin(edge);
  this->End = mesh.Target(edge);
  this->NumberOfRemovedFaces = twin == None ? 1 : 2;
  this->RemovedFaces = { HalfEdgeMesh::Face(edge),
    twin == None ? FaceId() : HalfEdgeMesh::Face(twin) };
  this->Apexes = { mesh.Apex(edge), twin == None ? VertexId() : mesh.Apex(twin) };
  FetchFacesOfEnd(mesh, edge, twin);
  this->Corners.clear();
  this->Ring.clear();

  const bool startOnBoundary = twin != None && mesh.IsOnBoundary(this->Start);
  this->IsOpen = startOnBoundary || mesh.IsOnBoundary(this->End);
  const Index first = !this->IsOpen ? mesh.Twin(HalfEdgeMesh::Previous(edge))
    : startOnBoundary               ? mesh.Outgoing(this->Start)
                                    : mesh.Outgoing(this->End);
  Index out = first;
  Index last = None; // on a boundary: the incoming half-edge at the end of the ring
  do
  {
    const FaceId face = HalfEdgeMesh::Face(out);
    if (face == this->RemovedFaces[0] || face == this->RemovedFaces[1])
    {
      last = HalfEdgeMesh::Next(out); // continue at the other end of the edge
    }
    else if (this->Corners.size() == MaxFacesOfEdit)
    {
      return false;
    }
    else
    {
      this->Corners.push_back(out);
      this->Ring.push_back(mesh.Target(out));
      Prefetch(&mesh.Record(this->Ring.back())); // read next by the validity checks
      last = HalfEdgeMesh::Previous(out);
    }
    out = mesh.Twin(last);
  } while (out != None && out != first);
  if (this->IsOpen)
  {
    this->Ring.push_back(mesh.Origin(last));
    this->BoundaryEnds = { mesh.Origin(first), mesh.Target(last) };
  }
  return true;
}

//------------------------------------------------------------------------------
/// A collapse removes at most two faces of the vertex and, with a closed ring, adds at least one.
bool IsHub(const HalfEdgeMesh& mesh, VertexId vertex)
{
  Index faces = 0;
  mesh.VisitNeighbors(vertex, [&](HalfEdgeId, Index) { return ++faces <= MaxFacesOfEdit + 2; });
  return faces > MaxFacesOfEdit + 2;
}

//------------------------------------------------------------------------------
std::vector<Index> EdgeNeighborhood::Faces() const
{
  std::vector<Index> faces(this->Corners.size());
  std::transform(this->Corners.begin(), this->Corners.end(), faces.begin(), HalfEdgeMesh::Face);
  faces.insert(faces.end(), this->RemovedFaces.begin(),
    this->RemovedFaces.begin() + this->NumberOfRemovedFaces);
  return faces;
}

//------------------------------------------------------------------------------
bool EdgeNeighborhood::RingIsSimple() const
{
  constexpr std::size_t fewVertices = 32;
  if (this->Ring.size() > fewVertices)
  {
    std::vector<Index> sorted = this->Ring;
    sorted.insert(sorted.end(), { this->Start, this->End });
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
  }
  // Nearly every ring is simple: comparing all pairs is faster than an early exit.
  const Index* ring = this->Ring.data();
  bool isMet = false;
  for (std::size_t i = 0; i < this->Ring.size(); ++i)
  {
    isMet |= ring[i] == this->Start || ring[i] == this->End;
    for (std::size_t k = 0; k < i; ++k)
    {
      isMet |= ring[k] == ring[i];
    }
  }
  return !isMet;
}

//------------------------------------------------------------------------------
std::size_t EdgeNeighborhood::SlotAtApex(std::size_t k) const
{
  const auto apex = std::find(this->Ring.begin(), this->Ring.end(), this->Apexes[k]);
  return static_cast<std::size_t>(apex - this->Ring.begin()) % this->Corners.size();
}
}
