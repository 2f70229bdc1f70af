// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Invariants.h"

namespace bonedecimate
{
namespace
{
std::string At(const char* what, Index index)
{
  return std::string(what) + " " + std::to_string(index);
}

std::string BrokenFace(const HalfEdgeMesh& mesh, FaceId face)
{
  const Triangle c = mesh.Corners(face);
  if (c[1] == None || c[2] == None || c[0] == c[1] || c[1] == c[2] || c[2] == c[0])
  {
    return At("corners of face", face);
  }
  for (HalfEdgeId h = HalfEdgeMesh::HalfEdge(face, 0); h < HalfEdgeMesh::HalfEdge(face, 3); ++h)
  {
    const HalfEdgeId twin = mesh.Twin(h);
    if (twin == None)
    {
      continue;
    }
    if (mesh.Twin(twin) != h || !mesh.IsAlive(HalfEdgeMesh::Face(twin)))
    {
      return At("twin of half-edge", h);
    }
    if (mesh.Origin(twin) != mesh.Target(h) || mesh.Target(twin) != mesh.Origin(h))
    {
      return At("ends of half-edge", h);
    }
  }
  return {};
}

std::string BrokenRing(const HalfEdgeMesh& mesh, VertexId v, Index numberOfFaces)
{
  const HalfEdgeId start = mesh.Outgoing(v);
  if (start == None || !mesh.IsAlive(HalfEdgeMesh::Face(start)))
  {
    return At("outgoing half-edge of vertex", v);
  }
  Index found = 0;
  for (const HalfEdgeId h : mesh.OutgoingOf(v))
  {
    if (mesh.Origin(h) != v || ++found > numberOfFaces)
    {
      return At("ring of vertex", v);
    }
  }
  const bool onBoundary = mesh.Twin(start) == None;
  const bool isConstrained = mesh.Constraint(v) == VertexConstraint::Constrained;
  if (found != numberOfFaces || (!isConstrained && onBoundary != mesh.IsOnBoundary(v)))
  {
    return At("fan of vertex", v);
  }
  return {};
}
}

std::string BrokenInvariant(const HalfEdgeMesh& mesh)
{
  std::vector<Index> numberOfFaces(static_cast<std::size_t>(mesh.NumberOfVertexSlots()), 0);
  Index liveFaces = 0;
  for (FaceId face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    if (!mesh.IsAlive(face))
    {
      continue;
    }
    ++liveFaces;
    const std::string broken = BrokenFace(mesh, face);
    if (!broken.empty())
    {
      return broken;
    }
    for (const Index corner : mesh.Corners(face))
    {
      ++numberOfFaces[corner];
    }
  }
  if (liveFaces != mesh.NumberOfFaces())
  {
    return At("number of faces", mesh.NumberOfFaces());
  }
  for (VertexId v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    if (numberOfFaces[v] > 0 && mesh.Constraint(v) != VertexConstraint::NonManifold)
    {
      const std::string broken = BrokenRing(mesh, v, numberOfFaces[v]);
      if (!broken.empty())
      {
        return broken;
      }
    }
  }
  return {};
}
}
