// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HandleLimit.h"

#include <vector>

namespace bonedecimate
{
namespace
{
template <typename Visit>
void VisitHalfEdges(const HalfEdgeMesh& mesh, const Visit& visit)
{
  for (FaceId face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    for (Index corner = 0; corner < 3 && mesh.IsAlive(face); ++corner)
    {
      visit(HalfEdgeMesh::HalfEdge(face, corner));
    }
  }
}

/// The half-edge without a twin that begins at the end of this one.
HalfEdgeId NextOnBoundary(const HalfEdgeMesh& mesh, HalfEdgeId h)
{
  h = HalfEdgeMesh::Next(h);
  while (mesh.Twin(h) != None)
  {
    h = HalfEdgeMesh::Next(mesh.Twin(h));
  }
  return h;
}

Index NumberOfBoundaryLoops(const HalfEdgeMesh& mesh)
{
  std::vector<char> isKnown(4 * static_cast<std::size_t>(mesh.NumberOfFaceSlots()), 0);
  Index loops = 0;
  VisitHalfEdges(mesh,
    [&](HalfEdgeId h)
    {
      if (mesh.Twin(h) == None && !isKnown[h])
      {
        ++loops;
        for (; !isKnown[h]; h = NextOnBoundary(mesh, h))
        {
          isKnown[h] = 1;
        }
      }
    });
  return loops;
}

/// By Euler's formula. 0 if there are duplicates, because patches have no components of their own.
Index NumberOfHandles(const Editor& editor)
{
  const HalfEdgeMesh& mesh = editor.Mesh();
  Index euler = mesh.NumberOfFaces();
  for (VertexId v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    if (mesh.NextDuplicate(v) != v || mesh.Constraint(v) == VertexConstraint::NonManifold)
    {
      return 0;
    }
    euler += mesh.Outgoing(v) != None ? 1 : 0;
  }
  VisitHalfEdges(
    mesh, [&](HalfEdgeId h) { euler -= mesh.Twin(h) == None || h < mesh.Twin(h) ? 1 : 0; });
  return (2 * editor.Components().Count() - NumberOfBoundaryLoops(mesh) - euler) / 2;
}
}

bool AreHandlesInTheWay(const Editor& editor)
{
  const HalfEdgeMesh& mesh = editor.Mesh();
  if (NumberOfHandles(editor) <= 0)
  {
    return false;
  }
  EditWorkspace workspace;
  Index edges = 0;
  Index loops = 0;
  VisitHalfEdges(mesh,
    [&](HalfEdgeId h)
    {
      if (mesh.Twin(h) == None || h < mesh.Twin(h))
      {
        ++edges;
        loops += editor.Gather(h, workspace).Reason() == Rejection::LinkCondition ? 1 : 0;
      }
    });
  return 2 * loops >= edges;
}
}
