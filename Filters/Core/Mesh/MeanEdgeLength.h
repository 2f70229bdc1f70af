// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeanEdgeLength.h
 * @brief The mean edge length, by which costs of different powers of length become comparable.
 */
#ifndef BoneDecimate_Core_Mesh_MeanEdgeLength_h
#define BoneDecimate_Core_Mesh_MeanEdgeLength_h

#include "HalfEdgeMesh.h"

namespace bonedecimate
{
/// Mean length of all edges, mm.
inline double MeanEdgeLength(const HalfEdgeMesh& mesh)
{
  double sum = 0.0; // mm
  Index edges = 0;
  for (FaceId face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    for (HalfEdgeId h = HalfEdgeMesh::HalfEdge(face, 0);
         mesh.IsAlive(face) && h < HalfEdgeMesh::HalfEdge(face, 3); ++h)
    {
      const HalfEdgeId twin = mesh.Twin(h);
      if (twin == None || h < twin)
      {
        sum += (mesh.Position(mesh.Target(h)) - mesh.Position(mesh.Origin(h))).norm();
        ++edges;
      }
    }
  }
  return edges > 0 ? sum / edges : 0.0;
}
}

#endif
