// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Neighbourhood.h"

#include <algorithm>

namespace bonedecimate
{
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
  this->Corners.clear();
  this->Ring.clear();

  const bool startOnBorder = twin != None && mesh.Kind(this->Start) == VertexKind::Border;
  this->IsOpen = startOnBorder || mesh.Kind(this->End) == VertexKind::Border;
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
  for (auto at = this->Ring.begin(); at != this->Ring.end(); ++at)
  {
    if (*at == this->Start || *at == this->End ||
      std::find(at + 1, this->Ring.end(), *at) != this->Ring.end())
    {
      return false;
    }
  }
  return true;
}
}
