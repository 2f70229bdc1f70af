// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceWalk.h"

namespace bonedecimate
{
namespace
{
/// The half-edge of the face that leaves the corner.
Index HalfEdgeAt(FaceId face, int corner)
{
  const HalfEdgeId first = HalfEdgeMesh::HalfEdge(face, 0);
  return corner == 0 ? first
    : corner == 1    ? HalfEdgeMesh::Next(first)
                     : HalfEdgeMesh::Previous(first);
}

void Try(const HalfEdgeMesh& mesh, const Vector3& p, FaceId face, PointOnMesh& best)
{
  const TriangleFrame::Point point = FrameOf(mesh, face).Nearest(p);
  if (point.SquaredDistance < best.Point.SquaredDistance)
  {
    best = { face, point };
  }
}

void TryAcross(const HalfEdgeMesh& mesh, const Vector3& p, HalfEdgeId h, PointOnMesh& best)
{
  const HalfEdgeId twin = mesh.Twin(h);
  if (twin != None)
  {
    Try(mesh, p, HalfEdgeMesh::Face(twin), best);
  }
}

/// Tries all faces around the origin of h except that of h.
void TryAround(const HalfEdgeMesh& mesh, const Vector3& p, HalfEdgeId h, PointOnMesh& best)
{
  if (mesh.Constraint(mesh.Origin(h)) == VertexConstraint::NonManifold)
  {
    TryAcross(mesh, p, h, best);
    TryAcross(mesh, p, HalfEdgeMesh::Previous(h), best);
    return;
  }
  const FaceId face = HalfEdgeMesh::Face(h);
  for (const Index out : mesh.OutgoingOf(mesh.Origin(h)))
  {
    if (HalfEdgeMesh::Face(out) != face)
    {
      Try(mesh, p, HalfEdgeMesh::Face(out), best);
    }
  }
}

/// The only corner whose weight is not zero.
int CornerOf(int clamped)
{
  return clamped == 6 ? 0 : clamped == 5 ? 1 : 2;
}

bool IsCorner(int clamped)
{
  return (clamped & (clamped - 1)) != 0;
}

/// The half-edge opposite the only corner whose weight is zero.
Index EdgeOf(FaceId face, int clamped)
{
  return HalfEdgeAt(face, clamped == 1 ? 1 : clamped == 2 ? 2 : 0);
}

/// From a point inside a face, tries the faces across those edges where a nearer face is possible.
void TryNearby(const HalfEdgeMesh& mesh, const Vector3& p, PointOnMesh& best)
{
  const Index face = best.Face;
  const int edges = FrameOf(mesh, face).EdgesNearby(best.Point);
  for (const int edge : { 1, 2, 4 })
  {
    if ((edges & edge) != 0)
    {
      TryAcross(mesh, p, EdgeOf(face, edge), best);
    }
  }
}
}

PointOnMesh WalkOn(const HalfEdgeMesh& mesh, const Vector3& p, PointOnMesh from)
{
  Index face = None;
  while (face != from.Face && from.Point.SquaredDistance > 0.0)
  {
    face = from.Face;
    const int clamped = from.Point.Clamped;
    if (clamped == 0)
    {
      TryNearby(mesh, p, from);
    }
    else if (IsCorner(clamped))
    {
      TryAround(mesh, p, HalfEdgeAt(face, CornerOf(clamped)), from);
    }
    else
    {
      TryAcross(mesh, p, EdgeOf(face, clamped), from);
    }
  }
  return from;
}

//------------------------------------------------------------------------------
PointOnMesh WalkFromVertex(const HalfEdgeMesh& mesh, const Vector3& p, VertexId vertex)
{
  const HalfEdgeId outgoing = mesh.Outgoing(vertex);
  const FaceId face = HalfEdgeMesh::Face(outgoing);
  PointOnMesh best = { face, FrameOf(mesh, face).Nearest(p) };
  if (best.Point.SquaredDistance > 0.0)
  {
    TryAround(mesh, p, outgoing, best);
  }
  return WalkOn(mesh, p, best);
}
}
