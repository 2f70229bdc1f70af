// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshState.h
 * @brief A mesh as numbers, so that a test can compare it with what it was before.
 */
#ifndef BoneDecimate_Testing_MeshState_h
#define BoneDecimate_Testing_MeshState_h

#include "Mesh/HalfEdgeMesh.h"

#include <vector>

namespace bonedecimate::testsupport
{
/// All there is to a mesh but its quadrics.
inline std::vector<double> StateOf(const HalfEdgeMesh& mesh)
{
  std::vector<double> state = { static_cast<double>(mesh.NumberOfFaces()) };
  for (FaceId face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    const FaceRecord& record = *mesh.RecordOfFace(HalfEdgeMesh::HalfEdge(face, 0));
    state.insert(state.end(), record.Origins.begin(), record.Origins.end());
    state.insert(state.end(), record.Twins.begin(), record.Twins.end());
  }
  for (VertexId v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    state.push_back(static_cast<Index>(mesh.Outgoing(v)));
    state.push_back(static_cast<double>(mesh.Constraint(v)));
    state.insert(state.end(), mesh.Position(v).data(), mesh.Position(v).data() + 3);
  }
  return state;
}
}

#endif
