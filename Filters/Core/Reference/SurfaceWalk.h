// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceWalk.h
 * @brief From a face of a mesh to the face nearest to a point, over neighbouring faces while the distance falls.
 *
 *     the nearest place lies inside the face:   the end
 *     on an edge:                               try the face across
 *     on a corner:                              try all faces around it
 *
 * It finds the least distance nearby, which need not be the least of all: it never jumps from sheet to sheet.
 */
#ifndef BoneDecimate_Core_Reference_SurfaceWalk_h
#define BoneDecimate_Core_Reference_SurfaceWalk_h

#include "Geometry/TriangleFrame.h"
#include "Mesh/HalfEdgeMesh.h"

namespace bonedecimate
{
struct PlaceOnMesh
{
  Index Face = None;
  TriangleFrame::Place Place;
};

/// The frame of a face; its corners A, B, C are Corners(face).
inline TriangleFrame FrameOf(const HalfEdgeMesh& mesh, Index face)
{
  const Triangle corners = mesh.Corners(face);
  return { mesh.Position(corners[0]), mesh.Position(corners[1]), mesh.Position(corners[2]) };
}

/// Walks on from a place found on a face.
PlaceOnMesh WalkOn(const HalfEdgeMesh& mesh, const Vector3& p, PlaceOnMesh from);

/// Walks from the best of the faces around a vertex.
PlaceOnMesh WalkFromVertex(const HalfEdgeMesh& mesh, const Vector3& p, Index vertex);

inline PlaceOnMesh WalkFrom(const HalfEdgeMesh& mesh, const Vector3& p, Index face)
{
  return WalkOn(mesh, p, { face, FrameOf(mesh, face).Nearest(p) });
}
}

#endif
