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
  this->CachedLengths.resize(static_cast<std::size_t>(mesh.NumberOfVertexSlots()));
  ForEachId(this->CachedLengths.size(), threads,
    [&](std::size_t v)
    {
      const Vector3& position = mesh.Position(static_cast<Index>(v));
      this->CachedLengths[v] = { position, this->Sizes->At(position) };
    });
}

//------------------------------------------------------------------------------
double LocalLengths::At(VertexId vertex, const Vector3& position) const
{
  const CachedLength& known = this->CachedLengths[vertex];
  return known.Position == position ? known.Found.Length
                                    : this->Sizes->At(position, known.Found.Triangle).Length;
}

//------------------------------------------------------------------------------
double LocalLengths::Update(VertexId vertex, const Vector3& position)
{
  CachedLength& known = this->CachedLengths[vertex];
  if (known.Position != position)
  {
    known = { position, this->Sizes->At(position, known.Found.Triangle) };
  }
  return known.Found.Length;
}
}
