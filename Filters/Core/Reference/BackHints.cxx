// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BackHints.h"

namespace bonedecimate
{
void BackHints::Begin(const HalfEdgeMesh& mesh)
{
  for (Index v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    if (mesh.Outgoing(v) != None)
    {
      this->OfVertex[v] =
        WalkFrom(this->Source, mesh.Position(v), HalfEdgeMesh::Face(this->Source.Outgoing(v))).Face;
    }
  }
  for (Index face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    if (mesh.IsAlive(face))
    {
      const Triangle c = mesh.Corners(face);
      const Vector3 middle =
        (mesh.Position(c[0]) + mesh.Position(c[1]) + mesh.Position(c[2])) / 3.0;
      this->OfFace[face] = WalkFrom(this->Source, middle, this->OfVertex[c[0]]).Face;
    }
  }
}
}
