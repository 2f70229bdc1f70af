// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LocalLengths.h
 * @brief The requested edge length at each vertex, stored with the position of the vertex, so that
 * only moved vertices are looked up again.
 */
#ifndef BoneDecimate_Core_Mesh_LocalLengths_h
#define BoneDecimate_Core_Mesh_LocalLengths_h

#include "HalfEdgeMesh.h"
#include "SizingField.h"

#include <memory>
#include <vector>

namespace bonedecimate
{
class LocalLengths
{
public:
  /// @param sizes Null: there are no local lengths.
  LocalLengths(std::shared_ptr<const SizingField> sizes, const HalfEdgeMesh& mesh, int threads);

  /// The length, mm, for a vertex at the given position.
  double At(VertexId vertex, const Vector3& position) const;

  /// The same. Stores the length if the vertex has moved or is new.
  double Update(VertexId vertex, const Vector3& position);

private:
  struct CachedLength
  {
    Vector3 Position;
    SizingField::LocalLength Found;
  };
  std::shared_ptr<const SizingField> Sizes;
  std::vector<CachedLength> CachedLengths;
};
}

#endif
