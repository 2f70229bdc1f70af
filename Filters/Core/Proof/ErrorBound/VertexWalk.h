// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VertexWalk.h
 * @brief Walks over the current mesh from a vertex of any constraint to the face nearest to a
 * point.
 */
#ifndef BoneDecimate_Core_Proof_ErrorBound_VertexWalk_h
#define BoneDecimate_Core_Proof_ErrorBound_VertexWalk_h

#include "Proof/Reference/SurfaceWalk.h"

#include <vector>

namespace bonedecimate
{
class VertexWalk
{
public:
  explicit VertexWalk(const HalfEdgeMesh& mesh)
    : Mesh(mesh)
    , FaceAtVertex(static_cast<std::size_t>(mesh.NumberOfVertexSlots()), None)
  {
    for (FaceId face = 0; face < mesh.NumberOfFaceSlots(); ++face)
    {
      if (mesh.IsAlive(face))
      {
        for (const Index v : mesh.Corners(face))
        {
          this->FaceAtVertex[v] = face;
        }
      }
    }
  }

  /// @param vertex A vertex of the mesh that has faces.
  PointOnMesh FindNear(const Vector3& p, VertexId vertex) const
  {
    return this->Mesh.MovesFreely(vertex) ? WalkFromVertex(this->Mesh, p, vertex)
                                          : WalkFrom(this->Mesh, p, this->FaceAtVertex[vertex]);
  }

private:
  const HalfEdgeMesh& Mesh;
  std::vector<Index> FaceAtVertex;
};
}

#endif
