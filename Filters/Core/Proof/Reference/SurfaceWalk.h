// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceWalk.h
 * @brief Finds a face near a point by walking over neighboring faces while the distance decreases.
 *
 *     the nearest point is inside the face:   stop
 *     on an edge:                             try the face across it
 *     on a corner:                            try all faces around it
 *
 * The result is a local minimum of the distance, which need not be the global one: the walk never
 * leaves a connected part.
 */
#ifndef BoneDecimate_Core_Proof_Reference_SurfaceWalk_h
#define BoneDecimate_Core_Proof_Reference_SurfaceWalk_h

#include "Geometry/TriangleFrame.h"
#include "Mesh/HalfEdgeMesh.h"

namespace bonedecimate
{
struct PointOnMesh
{
  Index Face = None;
  TriangleFrame::Point Point;
};

/// The frame of a face; its corners A, B, C are Corners(face).
inline TriangleFrame FrameOf(const HalfEdgeMesh& mesh, FaceId face)
{
  const Triangle corners = mesh.Corners(face);
  return { mesh.Position(corners[0]), mesh.Position(corners[1]), mesh.Position(corners[2]) };
}

/// Walks on from a point on a face.
PointOnMesh WalkOn(const HalfEdgeMesh& mesh, const Vector3& p, PointOnMesh from);

/// Walks from the nearest of the faces around a vertex.
PointOnMesh WalkFromVertex(const HalfEdgeMesh& mesh, const Vector3& p, VertexId vertex);

inline PointOnMesh WalkFrom(const HalfEdgeMesh& mesh, const Vector3& p, FaceId face)
{
  return WalkOn(mesh, p, { face, FrameOf(mesh, face).Nearest(p) });
}
}

#endif
