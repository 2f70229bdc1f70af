// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Neighbourhood.h"

#include "Memory/Prefetch.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
/// From both sides at once, while the ring of the start is walked: the faces round the end of the edge.
void FetchFacesOfEnd(const HalfEdgeMesh& mesh, Index edge, Index twin)
{
  constexpr int steps = 2;
  Index left = mesh.Twin(HalfEdgeMesh::Next(edge));
  Index right = twin == None ? None : mesh.Twin(HalfEdgeMesh::Previous(twin));
  for (int i = 0; i < steps && left != None && right != None; ++i)
  {
    left = mesh.Twin(HalfEdgeMesh::Next(left));
    right = mesh.Twin(HalfEdgeMesh::Previous(right));
  }
  Prefetch(mesh.RecordOfFace(std::max(0, left)));
  Prefetch(mesh.RecordOfFace(std::max(0, right)));
}
}

void Neighbourhood::Gather(const HalfEdgeMesh& mesh, Index edge)
{
  const Index twin = mesh.Twin(edge);
  this->Edge = edge;
  this->Start = mesh.Origin(edge);
  this->End = mesh.Target(edge);
  this->NumberOfGoneFaces = twin == None ? 1 : 2;
  this->GoneFaces = { HalfEdgeMesh::Face(edge), twin == None ? None : HalfEdgeMesh::Face(twin) };
  this->Apexes = { mesh.Origin(HalfEdgeMesh::Previous(edge)),
    twin == None ? None : mesh.Origin(HalfEdgeMesh::Previous(twin)) };
  FetchFacesOfEnd(mesh, edge, twin);
  this->Corners.clear();
  this->Ring.clear();

  const bool startOnBorder = twin != None && mesh.IsOnBorder(this->Start);
  this->IsOpen = startOnBorder || mesh.IsOnBorder(this->End);
  const Index first = !this->IsOpen ? mesh.Twin(HalfEdgeMesh::Previous(edge))
    : startOnBorder                 ? mesh.Outgoing(this->Start)
                                    : mesh.Outgoing(this->End);
  Index out = first;
  Index last = None; // on a border: the half-edge that comes back from the last of the ring
  do
  {
    const Index face = HalfEdgeMesh::Face(out);
    if (face == this->GoneFaces[0] || face == this->GoneFaces[1])
    {
      last = HalfEdgeMesh::Next(out); // over to the other end of the edge
    }
    else
    {
      this->Corners.push_back(out);
      this->Ring.push_back(mesh.Target(out));
      Prefetch(&mesh.Record(this->Ring.back())); // whoever judges the edge asks for it next
      last = HalfEdgeMesh::Previous(out);
    }
    out = mesh.Twin(last);
  } while (out != None && out != first);
  if (this->IsOpen)
  {
    this->Ring.push_back(mesh.Origin(last));
    this->BorderEnds = { mesh.Origin(first), mesh.Target(last) };
  }
}

//------------------------------------------------------------------------------
bool Neighbourhood::RingIsSimple() const
{
  // Nearly every ring is simple: all pairs without leaving early are faster than leaving early.
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
}
