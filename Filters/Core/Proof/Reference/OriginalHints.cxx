// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OriginalHints.h"

#include "Base/Parallel.h"

namespace bonedecimate
{
bool OriginalHints::Restart(const HalfEdgeMesh& mesh, int threads, const Monitor& monitor)
{
  return ForEachChunk(this->TriangleOfVertex.size(), threads, monitor,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (VertexId v = static_cast<Index>(first); v < static_cast<Index>(last); ++v)
      {
        if (mesh.Outgoing(v) != None)
        {
          const FaceId start = this->Starts != nullptr
            ? FaceId((*this->Starts)[v])
            : HalfEdgeMesh::Face(this->OriginalMesh.Outgoing(v));
          this->TriangleOfVertex[v] = WalkFrom(this->OriginalMesh, mesh.Position(v), start).Face;
        }
      }
    });
}
}
