// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Neighbourhood.h"

#include <algorithm>

namespace bonedecimate
{
void NeighbourhoodGatherer::Gather(const HalfEdgeMesh& mesh, Index edge, Neighbourhood& around)
{
  around.Edge = edge;
  around.Start = mesh.Origin(edge);
  around.End = mesh.Target(edge);
  around.NumberOfGoneFaces = 0;
  for (const Index half : { edge, mesh.Twin(edge) })
  {
    if (half != None)
    {
      around.GoneFaces[around.NumberOfGoneFaces] = HalfEdgeMesh::Face(half);
      around.Apexes[around.NumberOfGoneFaces] = mesh.Origin(HalfEdgeMesh::Previous(half));
      ++around.NumberOfGoneFaces;
    }
  }
  if (++this->Gatherings == 0) // wrapped round: old marks could be taken for new ones
  {
    std::fill(this->Marks.begin(), this->Marks.end(), 0);
    this->Gatherings = 1;
  }
  around.Corners.clear();
  around.CommonNeighbours = 0;
  const auto keepCorner = [&](Index h, Index v)
  {
    const Index face = HalfEdgeMesh::Face(h);
    const bool gone =
      face == around.GoneFaces[0] || (!around.IsBorderEdge() && face == around.GoneFaces[1]);
    if (mesh.Origin(h) == v && !gone)
    {
      around.Corners.push_back(h);
    }
  };
  mesh.VisitEdges(around.Start,
    [&](Index h)
    {
      this->Marks[mesh.Across(h, around.Start)] = this->Gatherings;
      keepCorner(h, around.Start);
    });
  mesh.VisitEdges(around.End,
    [&](Index h)
    {
      around.CommonNeighbours +=
        this->Marks[mesh.Across(h, around.End)] == this->Gatherings ? 1 : 0;
      keepCorner(h, around.End);
    });
}
}
