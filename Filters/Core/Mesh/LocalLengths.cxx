// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalLengths.h"

#include "Base/Parallel.h"

#include <utility>

namespace bonedecimate
{
LocalLengths::LocalLengths(
  std::shared_ptr<const SizingField> sizes, const HalfEdgeMesh& mesh, int threads)
  : Sizes(std::move(sizes))
{
  if (!this->Sizes)
  {
    return;
  }
  this->OfVertex.resize(static_cast<std::size_t>(mesh.NumberOfVertexSlots()));
  ForEachId(this->OfVertex.size(), threads,
    [&](std::size_t v)
    {
      const Vector3& position = mesh.Position(static_cast<Index>(v));
      this->OfVertex[v] = { position, this->Sizes->At(position) };
    });
}

//------------------------------------------------------------------------------
double LocalLengths::At(VertexId vertex, const Vector3& position) const
{
  const Known& known = this->OfVertex[vertex];
  return known.Position == position ? known.There.Length
                                    : this->Sizes->At(position, known.There.Triangle).Length;
}

//------------------------------------------------------------------------------
double LocalLengths::Keep(VertexId vertex, const Vector3& position)
{
  Known& known = this->OfVertex[vertex];
  if (known.Position != position)
  {
    known = { position, this->Sizes->At(position, known.There.Triangle) };
  }
  return known.There.Length;
}
}
